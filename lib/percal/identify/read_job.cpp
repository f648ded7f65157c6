#include <algorithm>
#include <cmath>

#include "percal/identify/job.hpp"
#include "percal/text/csv.hpp"
#include "percal/text/toml.hpp"

namespace percal {
namespace {

const Range length = positive("length"), density = positive("density"), speed = positive("speed"), pressure = positive("pressure");
const Range strain = positive("strain"), factor = positive("factor");

CsvTable table_of(const TomlTable& block, const std::string& key = "file") {
  CsvTable table = read_csv(block.path(key));
  if (block.has("where")) table = table.where(block.texts("where"));
  if (table.rows.empty()) block.refuse("where", "no row of " + table.file, "conditions that some row meets");
  return table;
}

// A column named in the job, as positive numbers.
std::vector<double> column(const TomlTable& block, const std::string& key, const CsvTable& table, const Dimension& dimension) {
  const std::string name = block.text(key);
  if (!table.find(name)) block.refuse(key, "\"" + name + "\"", "a column of " + table.file);
  return table.numbers(name, dimension);
}

SphereScene read_sphere(const TomlTable& block) {
  return {.name = block.text("particle"),
          .radius = block.quantity("radius", dimension::length, length),
          .density = block.quantity("density", dimension::density, density),
          .speed = block.quantity("speed", dimension::speed, speed),
          .youngs_modulus = block.optional_quantity("youngs_modulus", dimension::pressure, pressure)};
}

ModelMaterial read_gelatin(const TomlTable& block) {
  ModelMaterial gelatin{.name = block.text("name", "gelatin"),
                        .density = block.quantity("density", dimension::density, density),
                        .rate_factor = block.number("rate_factor", factor),
                        .exponent = block.optional_number("exponent", any_number()),
                        .formulations = {}};
  const TomlTable rows = block.table("formulations");
  const CsvTable table = table_of(rows);
  const auto concentration = column(rows, "concentration", table, dimension::none);
  const auto quasi_static = column(rows, "mu_quasi_static", table, dimension::pressure);
  const auto penetration = column(rows, "penetration", table, dimension::length);
  std::vector<double> high_rate, deviation;
  if (rows.has("mu_high_rate")) high_rate = column(rows, "mu_high_rate", table, dimension::pressure);
  if (rows.has("penetration_sd")) deviation = column(rows, "penetration_sd", table, dimension::length);
  for (std::size_t i = 0; i < concentration.size(); ++i) {
    Formulation f{.concentration = concentration[i], .mu_quasi_static = quasi_static[i], .mu_high_rate = {},
                  .penetration = penetration[i], .penetration_sd = {}, .measured = true};
    if (!high_rate.empty()) f.mu_high_rate = high_rate[i];
    if (!deviation.empty()) f.penetration_sd = deviation[i];
    gelatin.formulations.push_back(f);
  }
  if (const auto condition = rows.optional_text("law_rows")) {
    const CsvTable measured = table.where({*condition});
    if (measured.rows.empty()) rows.refuse("law_rows", "\"" + *condition + "\", which no row meets", "COLUMN=VALUE of some row");
    for (std::size_t i = 0; i < table.rows.size(); ++i)
      gelatin.formulations[i].measured = std::any_of(measured.rows.begin(), measured.rows.end(),
                                                     [&](const CsvRow& row) { return row.line == table.rows[i].line; });
  }
  return gelatin;
}

VolumetricChoice read_volumetric(const TomlTable& block) {
  const auto nu = block.optional_number("nu", Range{-1, 0.5, true, true, "a Poisson's ratio between -1 and 0.5"});
  const auto ratio = block.optional_number("bulk_to_shear", positive("ratio"));
  if (nu && ratio) block.refuse("bulk_to_shear", "both nu and bulk_to_shear", "one of them, or neither (K is then chosen)");
  if (nu) return PoissonRatio{*nu};
  if (ratio) return BulkToShear{*ratio};
  return ChooseBulk{};
}

SolverScene read_solver(const TomlTable& block) {
  SolverScene solver;
  solver.contact_stiffness = block.number("contact_stiffness", positive("stiffness"), solver.contact_stiffness);
  solver.hourglass = block.number("hourglass", not_negative("stiffness"), solver.hourglass);
  solver.linear_viscosity = block.number("linear_viscosity", not_negative("viscosity"), solver.linear_viscosity);
  solver.quadratic_viscosity = block.number("quadratic_viscosity", not_negative("viscosity"), solver.quadratic_viscosity);
  solver.time_step_factor = block.number("time_step_factor", Range{0, 1.2, true, false, "a share of the stable step, up to 1.2"},
                                         solver.time_step_factor);
  if (block.word("arithmetic", {"single", "double"}, 0) == 1) solver.arithmetic = Arithmetic::double_precision;
  return solver;
}

AlphaChoice read_alpha(const TomlTable& block) {
  const Range exponent{-100, 100, false, false, "an exponent other than 0"};
  if (const auto value = block.optional_number("value", exponent)) {
    if (std::abs(*value) < 1e-3) block.refuse("value", "0", "an exponent other than 0");
    if (block.has("scan")) block.refuse("value", "both value and scan", "one of them");
    return AlphaGiven{*value};
  }
  if (!block.has("scan")) block.refuse("value", "neither value nor scan", "value = NUMBER, or scan = [NUMBER, ...] with a target table");
  AlphaScan scan;
  scan.candidates = block.numbers("scan", exponent);
  std::sort(scan.candidates.begin(), scan.candidates.end());
  scan.elements_per_radius = block.integer("elements_per_radius", 1, 1000, scan.elements_per_radius);
  scan.replicates = block.integer("replicates", 1, 100, scan.replicates);
  const TomlTable target = block.table("target");
  const CsvTable table = table_of(target);
  scan.target_name = target.text("name", table.file);
  const auto mu = column(target, "mu", table, dimension::pressure);
  const auto strains = column(target, "erosion_strain", table, dimension::none);
  std::vector<double> mu_model;
  if (target.has("mu_model")) mu_model = column(target, "mu_model", table, dimension::pressure);
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
  const auto lengths = [&](const std::string& key) { return column(block, key, table, dimension::length); };
  const bool by_diameter = block.has("diameter_column");
  const auto size = lengths(by_diameter ? "diameter_column" : "radius_column");
  const auto speeds = column(block, "speed_column", table, dimension::speed);
  const std::vector<double> densities = block.has("particle_density_column")
                                            ? column(block, "particle_density_column", table, dimension::density)
                                            : std::vector<double>(n, block.quantity("particle_density", dimension::density, density));
  const std::vector<std::string> names = block.has("particle_column") ? table.texts(block.text("particle_column"))
                                                                      : std::vector<std::string>(n, block.text("particle", "sphere"));
  std::vector<double> measured, reference;
  if (block.has("measured_column")) measured = lengths("measured_column");
  if (block.has("reference_column")) reference = lengths("reference_column");
  for (std::size_t i = 0; i < n; ++i) {
    shots[i] = {.particle = names[i], .density = densities[i], .radius = by_diameter ? size[i] / 2 : size[i], .speed = speeds[i],
                .measured = {}, .reference = {}};
    if (!measured.empty()) shots[i].measured = measured[i];
    if (!reference.empty()) shots[i].reference = reference[i];
    if (!(shots[i].radius > 0 && shots[i].speed > 0 && shots[i].density > 0))
      throw BadInput({table.file, table.rows[i].line, ""}, "a radius, speed or density that is not positive", "positive numbers");
  }
  return shots;
}

PredictionMaterial read_material(const TomlTable& block) {
  switch (block.word("material", {"given", "tissue", "model"})) {
    case 1: return IdentifiedTissue{};
    case 2: return IdentifiedModel{};
    default: return PairGiven{block.quantity("mu", dimension::pressure, any_number()), block.number("erosion_strain", strain)};
  }
}

// One block may ask for several target densities: a set for each.
std::vector<PredictionSet> read_predictions(const TomlTable& block) {
  PredictionSet set;
  set.system = block.text("system");
  set.shots = read_shots_to_predict(block, table_of(block));
  set.material = read_material(block);
  set.volumetric = read_volumetric(block);
  set.elements_per_radius = block.integer("elements_per_radius", 1, 1000, set.elements_per_radius);
  set.replicates = block.integer("replicates", 1, 100, set.replicates);
  std::vector<PredictionSet> sets;
  for (const double target_density : block.quantities("target_density", dimension::density, density)) {
    sets.push_back(set);
    sets.back().target_density = target_density;
  }
  return sets;
}

TrendTable read_trend(const TomlTable& block) {
  const CsvTable table = table_of(block);
  TrendTable trend;
  trend.name = block.text("name");
  trend.x_name = block.text("x");
  trend.y_name = block.text("y");
  const auto in_own_unit = [&](const std::string& key, double& unit_in_si) {
    const int index = table.column(block.text(key));
    const Quantity unit = parse_unit(table.columns[index].unit);
    unit_in_si = unit.value;
    auto values = table.numbers(index, unit.dimension);
    for (double& value : values) value /= unit.value;
    return values;
  };
  trend.x = in_own_unit("x", trend.x_unit);
  trend.y = in_own_unit("y", trend.y_unit);
  trend.unit = table.columns[table.column(trend.y_name)].unit + " per " + table.columns[table.column(trend.x_name)].unit;
  trend.reference_slope = block.optional_number("reference_slope", any_number());
  trend.reference_intercept = block.optional_number("reference_intercept", any_number());
  return trend;
}

ScaledLine read_scaled_line(const TomlTable& block) {
  ScaledLine line;
  line.name = block.text("name");
  const TomlTable shots = block.table("shots");
  const CsvTable table = table_of(shots);
  line.shots = read_shots(table, {.density = shots.text("density"), .radius = shots.text("radius", ""),
                                  .diameter = shots.text("diameter", ""), .speed = shots.text("speed"), .depth = shots.text("penetration")});
  const TomlTable cases = block.table("cases");
  line.cases = read_shots_to_predict(cases, table_of(cases));
  line.reference_mean_error = block.optional_number("reference_mean_error", positive("share"));
  return line;
}

EqualMass read_equal_mass(const TomlTable& block) {
  EqualMass equal{.mass = block.quantity("mass", dimension::mass, positive("mass")),
                  .speed = block.quantity("speed", dimension::speed, speed), .shapes = {}};
  for (const TomlTable& shape : block.tables("shapes"))
    equal.shapes.push_back({.name = shape.text("name"), .trend = shape.text("trend", ""),
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
  for (const auto& shape : job.equal_mass->shapes) {
    const bool known = std::any_of(job.trends.begin(), job.trends.end(), [&](const TrendTable& t) { return t.name == shape.trend; });
    if (!shape.trend.empty() && !known)
      root.refuse("equal_mass.shapes.trend", "\"" + shape.trend + "\"", "the name of a [[trends]] block");
    if (shape.trend.empty() && !job.scaled_line)
      root.refuse("equal_mass.shapes.trend", "nothing", "the name of a [[trends]] block (a sphere needs [scaled_line])");
  }
}

}  // namespace

const std::vector<ReferenceKey>& reference_keys() {
  static const std::vector<ReferenceKey> keys{
      {"model_density", dimension::density},        {"modulus_ratio", dimension::none},
      {"model_penetration", dimension::length},     {"model_fe_penetration", dimension::length},
      {"model_modulus", dimension::pressure},       {"highrate_modulus", dimension::pressure},
      {"erosion_strain", dimension::none},          {"quasistatic_shear_modulus", dimension::pressure},
      {"quasistatic_youngs_modulus", dimension::pressure}};
  return keys;
}

IdentifyJob read_identify_job(const std::string& path) {
  const TomlTable root = read_toml(path);
  IdentifyJob job;
  job.file = path;
  job.title = root.text("title", path);
  const TomlTable convention = root.table("convention");
  job.convention = convention.word("modulus", {"true", "mu/alpha"}) == 1 ? ModulusConvention::mu_over_alpha : ModulusConvention::true_shear;
  job.measure = static_cast<StrainMeasure>(convention.word("strain", {"engineering", "true", "green-lagrange"}, 0));

  job.gelatin = read_gelatin(root.table("gelatin"));
  const TomlTable tissue = root.table("tissue");
  job.tissue = {.name = tissue.text("name"), .density = tissue.quantity("density", dimension::density, density),
                .rate_factor = tissue.number("rate_factor", factor)};
  const TomlTable calibration = root.table("calibration");
  job.calibration = read_sphere(calibration);
  job.penetration = calibration.quantity("penetration", dimension::length, length);
  job.penetration_error = calibration.optional_quantity("penetration_standard_error", dimension::length, not_negative("length"));
  job.model = read_sphere(root.table("model"));

  if (const auto layer = root.optional_table("layer")) {
    job.layer.depth = layer->number("depth_over_radius", Range{1, 1e6, true, false, "more than one radius"}, job.layer.depth);
    job.layer.width = layer->number("width_over_radius", Range{1, 1e6, true, false, "more than one radius"}, job.layer.width);
    job.layer.bottom = layer->word("bottom", {"free", "fixed"}, 0) == 1 ? Bottom::fixed : Bottom::free;
  }
  if (const auto solver = root.optional_table("solver")) {
    job.volumetric = read_volumetric(*solver);
    job.solver = read_solver(*solver);
  }
  job.alpha = read_alpha(root.table("alpha"));
  const TomlTable ridge = root.table("ridge");
  job.ridge.erosion_strains = ridge.numbers("erosion_strains", strain);
  job.ridge.start = ridge.quantity("start", dimension::pressure, any_number());
  job.ridge.elements_per_radius = ridge.integer("elements_per_radius", 1, 1000, job.ridge.elements_per_radius);
  if (job.ridge.erosion_strains.size() < 2) ridge.refuse("erosion_strains", "one strain", "two or more: a ridge");
  std::sort(job.ridge.erosion_strains.begin(), job.ridge.erosion_strains.end());
  if (const auto check = root.optional_table("model_check")) {
    job.check_elements_per_radius = check->integer("elements_per_radius", 1, 1000, job.check_elements_per_radius);
    job.check_replicates = check->integer("replicates", 1, 100, job.check_replicates);
  }
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
  if (const auto block = root.optional_table("reference")) read_reference(*block, job);
  root.finish();
  check_references_between_blocks(root, job);
  return job;
}

}  // namespace percal
