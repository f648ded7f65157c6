#include <algorithm>
#include <cmath>
#include <set>

#include "percal/identify/job.hpp"
#include "percal/identify/layer_width.hpp"
#include "percal/scene/document_kind.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/scene/sphere_toml.hpp"
#include "percal/text/csv.hpp"
#include "percal/text/csv_cells.hpp"
#include "percal/text/file.hpp"
#include "percal/text/job_table.hpp"
#include "percal/text/toml.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

const Range length = positive("length"), density = positive("density"), speed = positive("speed"),
            pressure = positive("pressure");
const Range strain = positive("strain"), factor = positive("factor");

ParticleScene read_sphere(const TomlTable& block) {
  const std::string name = block.text("particle");
  const Sphere sphere = sphere_from(block);
  return {.name = name,
          .radius = sphere.radius,
          .density = sphere.density,
          .speed = block.quantity("speed", dimension::speed, speed),
          .youngs_modulus = block.optional_quantity("youngs_modulus", dimension::pressure, pressure)};
}

ModelMaterial read_gelatin(const TomlTable& block) {
  ModelMaterial gelatin{.name = block.text("name", "gelatin"),
                        .density = block.quantity("density", dimension::density, density),
                        .rate_factor = block.number("rate_factor", factor),
                        .exponent = block.optional_number("exponent", any_number()),
                        .table = "",
                        .file = "",
                        .formulations = {}};
  const TomlTable rows = block.table("formulations");
  const CsvTable table = table_of(rows);
  gelatin.table = rows.text("name", gelatin.name + " formulations");
  gelatin.file = table.file;
  const auto concentration = column_of(rows, "concentration", table, dimension::none);
  const auto quasi_static = column_of(rows, "mu_quasi_static", table, dimension::pressure);
  const auto penetration = column_of(rows, "penetration", table, dimension::length);
  std::vector<double> high_rate, deviation;
  if (rows.has("mu_high_rate")) high_rate = column_of(rows, "mu_high_rate", table, dimension::pressure);
  if (rows.has("penetration_sd"))
    deviation = column_of(rows, "penetration_sd", table, dimension::length, not_negative());
  for (std::size_t i = 0; i < concentration.size(); ++i) {
    Formulation f{.concentration = concentration[i],
                  .mu_quasi_static = quasi_static[i],
                  .mu_high_rate = {},
                  .penetration = penetration[i],
                  .penetration_sd = {},
                  .measured = true};
    if (!high_rate.empty()) f.mu_high_rate = high_rate[i];
    if (!deviation.empty()) f.penetration_sd = deviation[i];
    gelatin.formulations.push_back(f);
  }
  if (const auto condition = rows.optional_text("law_rows")) {
    const CsvTable measured = table.where({*condition});
    if (measured.rows.empty())
      rows.refuse("law_rows", "\"" + *condition + "\", which no row meets", "COLUMN=VALUE of some row");
    for (std::size_t i = 0; i < table.rows.size(); ++i)
      gelatin.formulations[i].measured = std::any_of(measured.rows.begin(), measured.rows.end(),
                                                     [&](const CsvRow& row) { return row.line == table.rows[i].line; });
  }
  std::set<double> concentrations;
  for (const Formulation& f : gelatin.formulations)
    if (f.measured) concentrations.insert(f.concentration);
  if (!gelatin.exponent && concentrations.size() < 2)
    rows.refuse("concentration", "one concentration",
                "two or more with measured moduli, or gelatin.exponent, for the law mu = k c^n");
  return gelatin;
}

// Moduli in this program's jobs are positive, so a mu that stands for mu_true 2/alpha needs a positive alpha.
void check_exponent(const TomlTable& block, const std::string& key, double alpha, ModulusConvention convention) {
  if (std::abs(alpha) < 1e-3) block.refuse(key, "0", "an exponent at least 0.001 in size");
  if (alpha < 0 && convention == ModulusConvention::mu_over_alpha)
    block.refuse(key, "an exponent below 0 beside convention.modulus = \"mu/alpha\"",
                 "a positive exponent, or convention.modulus = \"true\"");
}

AlphaChoice read_alpha(const TomlTable& block, ModulusConvention convention) {
  const Range exponent{-100, 100, false, false, "an exponent from -100 to 100, other than 0"};
  if (const auto value = block.optional_number("value", exponent)) {
    check_exponent(block, "value", *value, convention);
    if (block.has("scan")) block.refuse("value", "both value and scan", "one of them");
    return AlphaGiven{*value};
  }
  if (!block.has("scan"))
    block.refuse("value", "neither value nor scan", "value = NUMBER, or scan = [NUMBER, ...] with a target table");
  AlphaScan scan;
  scan.candidates = block.numbers("scan", exponent);
  for (const double alpha : scan.candidates) check_exponent(block, "scan", alpha, convention);
  const std::set<double> candidates(scan.candidates.begin(), scan.candidates.end());
  scan.candidates.assign(candidates.begin(), candidates.end());
  if (scan.candidates.size() < 2 || scan.candidates.front() * scan.candidates.back() < 0)
    block.refuse("scan", scan.candidates.size() < 2 ? "one exponent" : "exponents of both signs",
                 "two or more exponents of one sign");
  scan.elements_per_radius = block.number("elements_per_radius", elements_per_radius_range(), scan.elements_per_radius);
  scan.replicates = block.integer("replicates", 1, 100, scan.replicates);
  const TomlTable target = block.table("target");
  const CsvTable table = table_of(target);
  scan.target_name = target.text("name", table.file);
  scan.file = table.file;
  const auto mu = column_of(target, "mu", table, dimension::pressure);
  const auto strains = column_of(target, "erosion_strain", table, dimension::none);
  std::vector<double> mu_model;
  if (target.has("mu_model")) mu_model = column_of(target, "mu_model", table, dimension::pressure);
  for (std::size_t i = 0; i < mu.size(); ++i) {
    scan.target.push_back({.mu = mu[i], .erosion_strain = strains[i], .mu_model = {}});
    if (!mu_model.empty()) scan.target.back().mu_model = mu_model[i];
  }
  return scan;
}

// Shots of a table: columns where they differ from row to row, a value in the job where they don't.
std::vector<PredictedShot> read_shots_to_predict(const TomlTable& block, const CsvTable& table) {
  const auto n = table.rows.size();
  std::vector<PredictedShot> shots(n);
  const auto lengths = [&](const std::string& key) { return column_of(block, key, table, dimension::length); };
  const auto spheres = spheres_of_rows(block, table);
  const auto speeds = column_of(block, "speed_column", table, dimension::speed);
  const std::vector<std::string> names = block.has("particle_column")
                                             ? table.texts(block.text("particle_column"))
                                             : std::vector<std::string>(n, block.text("particle", "sphere"));
  std::vector<double> measured, reference;
  if (block.has("measured_column")) measured = lengths("measured_column");
  if (block.has("reference_column")) reference = lengths("reference_column");
  for (std::size_t i = 0; i < n; ++i) {
    shots[i] = {.particle = names[i],
                .density = spheres[i].density,
                .radius = spheres[i].radius,
                .speed = speeds[i],
                .measured = {},
                .reference = {}};
    if (!measured.empty()) shots[i].measured = measured[i];
    if (!reference.empty()) shots[i].reference = reference[i];
  }
  return shots;
}

PredictionMaterial read_material(const TomlTable& block) {
  switch (block.word("material", {"given", "tissue", "model"})) {
    case 1: return IdentifiedTissue{};
    case 2: return IdentifiedModel{};
    default:
      return PairGiven{block.quantity("mu", dimension::pressure, pressure), block.number("erosion_strain", strain)};
  }
}

// One block may ask for several target densities: a set for each.
std::vector<PredictionSet> read_predictions(const TomlTable& block) {
  PredictionSet set;
  set.system = block.text("system");
  set.table = block.text("table", "");
  set.shots = read_shots_to_predict(block, table_of(block));
  set.material = read_material(block);
  set.volumetric = volumetric_from(block);
  set.elements_per_radius = block.number("elements_per_radius", elements_per_radius_range(), set.elements_per_radius);
  set.replicates = block.integer("replicates", 1, 100, set.replicates);
  std::vector<PredictionSet> sets;
  for (const double target_density : block.quantities("target_density", dimension::density, density)) {
    sets.push_back(set);
    sets.back().target_density = target_density;
  }
  return sets;
}

// A straight line takes two different x.
void check_line(const TomlTable& block, const std::string& key, const std::vector<double>& x) {
  if (std::set<double>(x.begin(), x.end()).size() < 2)
    block.refuse(key, "rows that are all at one place", "rows at two or more, for a straight line");
}

TrendTable read_trend(const TomlTable& block) {
  const CsvTable table = table_of(block);
  TrendTable trend;
  trend.name = block.text("name");
  trend.x_name = block.text("x");
  trend.y_name = block.text("y");
  const auto in_own_unit = [&](const std::string& key, double& unit_in_si) {
    const int index = column_index(block, key, table);
    Quantity unit{1, dimension::none};
    try {
      unit = column_unit(table.columns[index].unit);
    } catch (const std::invalid_argument& error) {
      throw BadInput({table.file, table.header_line, table.columns[index].header}, error.what(),
                     "a unit that is known");
    }
    unit_in_si = unit.value;
    auto values = table.numbers(index, unit.dimension);
    for (double& value : values) value /= unit.value;
    return values;
  };
  trend.x = in_own_unit("x", trend.x_unit);
  trend.y = in_own_unit("y", trend.y_unit);
  if (block.has("reference_column")) {
    double unit = 1;
    trend.reference = in_own_unit("reference_column", unit);
    for (double& value : trend.reference) value *= unit / trend.y_unit;
  }
  trend.unit =
      table.columns[table.column(trend.y_name)].unit + " per " + table.columns[table.column(trend.x_name)].unit;
  check_line(block, "x", trend.x);
  trend.reference_slope = block.optional_number("reference_slope", any_number());
  trend.reference_intercept = block.optional_number("reference_intercept", any_number());
  return trend;
}

constexpr Dimension depth_per_impact_parameter{.mass = -1, .length = 2, .time = 1};

ScaledLine read_scaled_line(const TomlTable& block) {
  ScaledLine line;
  line.name = block.text("name");
  line.reference_slope = block.optional_quantity("reference_slope", depth_per_impact_parameter, any_number());
  line.reference_intercept = block.optional_quantity("reference_intercept", dimension::length, any_number());
  const TomlTable shots = block.table("shots");
  const CsvTable table = table_of(shots);
  line.shots_table = shots.text("name", "model shots");
  line.shots = read_shots(table, {.density = shots.text("density"),
                                  .radius = shots.text("radius", ""),
                                  .diameter = shots.text("diameter", ""),
                                  .speed = shots.text("speed"),
                                  .depth = shots.text("penetration")});
  std::vector<double> parameters;
  for (const Shot& shot : line.shots) parameters.push_back(impact_parameter(shot));
  check_line(shots, "file", parameters);
  const TomlTable cases = block.table("cases");
  line.cases = read_shots_to_predict(cases, table_of(cases));
  line.reference_mean_error = block.optional_number("reference_mean_error", positive("share"));
  return line;
}

EqualMass read_equal_mass(const TomlTable& block) {
  EqualMass equal{.table = block.text("name", "shapes of equal mass"),
                  .mass = block.quantity("mass", dimension::mass, positive("mass")),
                  .speed = block.quantity("speed", dimension::speed, speed),
                  .shapes = {}};
  for (const TomlTable& shape : block.tables("shapes"))
    equal.shapes.push_back({.name = shape.text("name"),
                            .trend = shape.text("trend", ""),
                            .mass = shape.optional_quantity("mass", dimension::mass, positive("mass")),
                            .reference = shape.quantity("reference", dimension::length, length)});
  return equal;
}

void read_reference(const TomlTable& block, IdentifyJob& job) {
  job.reference_name = block.text("name", "reference");
  for (const auto& [key, dimension] : reference_keys())
    if (const auto value = block.optional_quantity(key, dimension, any_number())) job.reference[key] = *value;
}

void check_references_between_blocks(const TomlTable& root, const IdentifyJob& job) {
  if (!job.equal_mass) return;
  const auto blocks = root.table("equal_mass").tables("shapes");
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const EqualMass::Shape& shape = job.equal_mass->shapes[i];
    const bool known =
        std::any_of(job.trends.begin(), job.trends.end(), [&](const TrendTable& t) { return t.name == shape.trend; });
    if (!shape.trend.empty() && !known)
      blocks[i].refuse("trend", in_quotes(shape.trend), "the name of a [[trends]] block");
    if (shape.trend.empty() && !job.scaled_line)
      blocks[i].refuse("trend", "nothing", "the name of a [[trends]] block (a sphere needs [scaled_line])");
  }
}

}  // namespace

const std::vector<ReferenceKey>& reference_keys() {
  static const std::vector<ReferenceKey> keys{{"model_density", dimension::density},
                                              {"modulus_ratio", dimension::none},
                                              {"model_penetration", dimension::length},
                                              {"model_fe_penetration", dimension::length},
                                              {"model_modulus", dimension::pressure},
                                              {"highrate_modulus", dimension::pressure},
                                              {"erosion_strain", dimension::none},
                                              {"quasistatic_shear_modulus", dimension::pressure},
                                              {"quasistatic_youngs_modulus", dimension::pressure}};
  return keys;
}

IdentifyJob read_identify_job(const std::string& path) {
  IdentifyJob job;
  job.file = path;
  job.text = read_file(path);
  const TomlTable root = parse_toml(job.text, path);
  need_kind(root, DocumentKind::identify);
  job.title = root.text("title", path);
  const TomlTable convention = root.table("convention");
  job.convention = convention.word("modulus", {"true", "mu/alpha"}) == 1 ? ModulusConvention::mu_over_alpha
                                                                         : ModulusConvention::true_shear;
  job.measure = static_cast<StrainMeasure>(convention.word("strain", {"engineering", "true", "green-lagrange"}, 0));

  job.gelatin = read_gelatin(root.table("gelatin"));
  const TomlTable tissue = root.table("tissue");
  job.tissue = {.name = tissue.text("name"),
                .density = tissue.quantity("density", dimension::density, density),
                .rate_factor = tissue.number("rate_factor", factor)};
  const TomlTable calibration = root.table("calibration");
  job.calibration = read_sphere(calibration);
  job.penetration = calibration.quantity("penetration", dimension::length, length);
  job.penetration_error =
      calibration.optional_quantity("penetration_standard_error", dimension::length, not_negative("length"));
  job.model = read_sphere(root.table("model"));

  job.layer.width_was_chosen = true;
  if (const auto layer = root.optional_table("layer")) {
    job.layer.depth =
        layer->number("depth_over_radius", Range{1, 1e6, true, false, "more than one radius"}, job.layer.depth);
    const auto width = layer->optional_number("width_over_radius", Range{1, 1e6, true, false, "more than one radius"});
    job.layer.width_was_chosen = !width;
    job.layer.width = width.value_or(job.layer.width);
    job.layer.bottom = layer->word("bottom", {"free", "fixed"}, 0) == 1 ? Bottom::fixed : Bottom::free;
  }
  if (const auto solver = root.optional_table("solver")) {
    job.volumetric = volumetric_from(*solver);
    job.solver = solver_from(*solver);
    if (job.solver.end_time)
      solver->refuse("end_time", "a time for all spheres, small and large",
                     "no end_time in a job: runs end when the sphere stops");
  }
  job.alpha = read_alpha(root.table("alpha"), job.convention);
  const TomlTable ridge = root.table("ridge");
  job.ridge.erosion_strains = ridge.numbers("erosion_strains", strain);
  job.ridge.start = ridge.quantity("start", dimension::pressure, pressure);
  job.ridge.elements_per_radius =
      ridge.number("elements_per_radius", elements_per_radius_range(), job.ridge.elements_per_radius);
  job.ridge.replicates = ridge.integer("replicates", 1, 100, job.ridge.replicates);
  const std::set<double> strains(job.ridge.erosion_strains.begin(), job.ridge.erosion_strains.end());
  if (strains.size() < 2) ridge.refuse("erosion_strains", "one strain", "two or more: a ridge");
  job.ridge.erosion_strains.assign(strains.begin(), strains.end());
  if (const auto check = root.optional_table("model_check")) {
    job.check_elements_per_radius =
        check->number("elements_per_radius", elements_per_radius_range(), job.check_elements_per_radius);
    job.check_replicates = check->integer("replicates", 1, 100, job.check_replicates);
  }
  if (const auto study = root.optional_table("mesh_study"))
    job.mesh_study = study->numbers("elements_per_radius", elements_per_radius_range());
  for (const TomlTable& block : root.tables("predictions"))
    for (auto& set : read_predictions(block)) job.predictions.push_back(std::move(set));
  for (const TomlTable& block : root.tables("trends")) job.trends.push_back(read_trend(block));
  if (const auto block = root.optional_table("scaled_line")) job.scaled_line = read_scaled_line(*block);
  if (const auto block = root.optional_table("equal_mass")) job.equal_mass = read_equal_mass(*block);
  if (const auto block = root.optional_table("card")) {
    job.card_name = block->text("name", job.tissue.name);
    if (block->has("comments")) job.card_comments = block->texts("comments");
  } else {
    job.card_name = job.tissue.name;
  }
  // Cards are files of this name.
  if (job.card_name.empty() || job.card_name.find_first_of("/\\") != std::string::npos ||
      std::any_of(job.card_name.begin(), job.card_name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
    root.refuse("card", "the name " + in_quotes(job.card_name), "a name that files may have");
  if (const auto block = root.optional_table("reference")) read_reference(*block, job);
  root.finish();
  check_references_between_blocks(root, job);
  if (job.layer.width_was_chosen) job.layer.width = widest_needed(job);
  return job;
}

}  // namespace percal
