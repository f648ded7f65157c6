// percal scale JOB: the ten groups of two systems, the model's missing values, and the similar scene.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "percal/base/version.hpp"
#include "percal/scaling/similar.hpp"
#include "percal/scaling/system_toml.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/text/file.hpp"
#include "percal/text/toml.hpp"

namespace percal::tools {
namespace {

using nlohmann::json;

// Of a group's agreement where the job says none: about the last digit of most printed values.
constexpr double default_tolerance = 0.01;

struct ScaleJob {
  std::string file;
  SystemInput prototype;
  SystemInput model;
  std::optional<Scene> prototype_scene;
  double tolerance = default_tolerance;
  std::string output_scene;  // empty: write none
};

// --- scenes and systems -----------------------------------------------------------------------------------------
SystemInput system_of(const Scene& scene) {
  SystemInput input;
  const auto& layer = scene.target;
  input.convention = layer.convention;
  auto& system = input.system;
  system.particle = scene.particle.name;
  system.target = layer.name;
  system.radius = scene.particle.radius;
  system.particle_density = scene.particle.density;
  system.particle_modulus = scene.particle.youngs_modulus;
  system.speed = scene.particle.speed;
  system.target_density = layer.density;
  system.mu = true_modulus(layer.mu_as_given, layer.alpha, layer.convention);
  system.alpha = layer.alpha;
  system.depth = layer.depth;
  system.width = layer.width;
  if (const auto* erosion = std::get_if<StrainErosion>(&layer.erosion)) {
    input.measure = erosion->measure;
    system.erosion_strain = erosion->limit;
    if (erosion->measure != StrainMeasure::engineering)
      system.erosion_strain = strain_at(stretch_at(erosion->limit, erosion->measure), StrainMeasure::engineering);
  }
  return input;
}

// Profile, lower layers, erosion limits and times: lengths by pi1, densities by pi5, pressures by pi4, times by pi10.
void scale_the_rest(Scene& scene, const System& prototype, const System& model) {
  const auto ratio = [&](auto member) { return required(model, member) / required(prototype, member); };
  const double length = ratio(&System::radius), density = ratio(&System::target_density), pressure = ratio(&System::mu);
  if (auto* profile = std::get_if<ProfileShape>(&scene.particle.shape)) {
    for (auto& vertex : profile->vertices)
      for (double& coordinate : vertex) coordinate *= length;
    const int dimensions = scene.geometry == Geometry::plane_strain ? 2 : 3;
    if (profile->mass) *profile->mass *= ratio(&System::particle_density) * std::pow(length, dimensions);
  }
  for (LowerLayerScene& layer : scene.below) {
    layer.density *= density;
    layer.mu_as_given *= pressure;
    layer.depth *= length;
    if (layer.erosion_limit && !std::holds_alternative<StrainErosion>(scene.target.erosion))
      *layer.erosion_limit *= pressure;
  }
  if (auto* stress = std::get_if<StressErosion>(&scene.target.erosion)) stress->limit *= pressure;
  if (auto* energy = std::get_if<EnergyErosion>(&scene.target.erosion)) energy->limit *= pressure;
  if (auto* series = std::get_if<PronySeries>(&scene.target.relaxation))
    for (PronyTerm& term : series->terms) term.time = map_time(term.time, prototype, model);
  if (scene.solver.end_time) scene.solver.end_time = map_time(*scene.solver.end_time, prototype, model);
}

// The prototype's scene with the model's numbers: geometry by Eq. 3-1, time by pi10; what has no dimension - erosion,
// volumetric ratio, mesh, solver settings, replicates - is the prototype's.
Scene similar_scene(const Scene& prototype_scene, const System& prototype, const System& model) {
  Scene scene = prototype_scene;
  scene.particle.name = model.particle;
  scene.particle.radius = required(model, &System::radius);
  scene.particle.density = required(model, &System::particle_density);
  scene.particle.speed = required(model, &System::speed);
  scene.particle.youngs_modulus = model.particle_modulus;
  scene.target.name = model.target;
  scene.target.density = required(model, &System::target_density);
  scene.target.mu_as_given =
      modulus_as_given(required(model, &System::mu), scene.target.alpha, scene.target.convention);
  scene.target.depth = required(model, &System::depth);
  scene.target.width = required(model, &System::width);
  scale_the_rest(scene, prototype, model);
  return scene;
}

// --- the job ----------------------------------------------------------------------------------------------------
SystemInput read_side(const TomlTable& table, const SystemInput& otherwise, std::optional<Scene>& scene) {
  auto path = table.optional_path("scene");
  if (!path) return read_system(table, otherwise);
  scene = read_scene(*path);
  auto input = system_of(*scene);
  read_response(table, input.system);
  return input;
}

ScaleJob read_job(const ScaleArguments& arguments) {
  ScaleJob job;
  job.file = arguments.job;
  auto root = read_toml(arguments.job);
  job.tolerance = root.number("tolerance", not_negative("tolerance of a group's agreement"), default_tolerance);
  job.prototype = read_side(root.table("prototype"), {}, job.prototype_scene);
  std::optional<Scene> model_scene;
  job.model = read_side(root.table("model"), job.prototype, model_scene);
  if (auto output = root.optional_table("output")) job.output_scene = output->path("scene");
  if (!arguments.write_scene.empty()) job.output_scene = arguments.write_scene;
  if (!job.output_scene.empty() && !job.prototype_scene)
    throw BadInput({arguments.job, 0, "prototype.scene"}, "no scene to scale",
                   "prototype.scene = \"FILE.toml\" where a similar scene is to be written");
  if (!job.output_scene.empty() && job.model.system.erosion_strain && !job.prototype.system.erosion_strain)
    throw BadInput({arguments.job, 0, "model.erosion_strain"},
                   "an erosion strain where the prototype's scene has no erosion", "none, or a prototype with erosion");
  root.finish();
  return job;
}

// --- the report -------------------------------------------------------------------------------------------------
std::string listed(const std::vector<std::string>& keys) { return fmt::format("{}", fmt::join(keys, ", ")); }

std::string shown(const std::optional<double>& number) { return number ? fmt::format("{:.6g}", *number) : "-"; }

std::string verdict(const Comparison& compared) {
  switch (compared.agreement) {
    case Agreement::agree: return "agree";
    case Agreement::differ: return "differ";
    case Agreement::missing: break;
  }
  std::string text;
  if (!compared.missing_in_prototype.empty()) text = "prototype lacks " + listed(compared.missing_in_prototype);
  if (!compared.missing_in_model.empty())
    text += (text.empty() ? "" : "; ") + std::string("model lacks ") + listed(compared.missing_in_model);
  return text;
}

std::string moduli(const System& system, ModulusConvention convention) {
  if (!system.mu) return "-";
  auto text = format_quantity(*system.mu, dimension::pressure) + " true";
  if (convention != ModulusConvention::true_shear && system.alpha)
    text = format_quantity(modulus_as_given(*system.mu, *system.alpha, convention), dimension::pressure) +
           " as given (" + word(convention) + "), " + text;
  return text;
}

std::string report(const ScaleJob& job, const Completion& completion, const std::vector<Comparison>& comparisons) {
  const auto& prototype = job.prototype.system;
  const auto& model = completion.model;
  auto text = fmt::format("prototype: {}\nmodel:     {}\n\n", title(prototype), title(model));
  text += fmt::format("{:<5} {:<15} {:<31} {:>12} {:>12} {:>10}\n", "group", "formula", "meaning", "prototype", "model",
                      "difference");
  for (const auto& one : comparisons)
    text += fmt::format("{:<5} {:<15} {:<31} {:>12} {:>12} {:>10}  {}\n", one.group->symbol, one.group->formula,
                        one.group->name, shown(one.prototype), shown(one.model),
                        one.difference ? fmt::format("{:.3g} %", 100 * *one.difference) : "-", verdict(one));
  text += fmt::format("(agree: within {:g} %)\n", 100 * job.tolerance);

  if (!completion.derived.empty()) text += "\nthe model's missing values\n";
  for (const auto& one : completion.derived)
    text += fmt::format("  {:<22} {:<14} from {} = {}\n", one.quantity->words,
                        format_quantity(one.value, one.quantity->dimension), one.because->symbol, one.because->formula);
  if (!completion.conflicts.empty() || !completion.gaps.empty()) text += "\nwhat stands in the way of similarity\n";
  for (const auto& conflict : completion.conflicts) text += "  " + describe(conflict) + "\n";
  for (const auto& gap : completion.gaps) text += "  " + describe(gap) + "\n";

  text += fmt::format("\nshear modulus: prototype {}\n               model     {}\n",
                      moduli(prototype, job.prototype.convention), moduli(model, job.model.convention));
  if (prototype.mu && model.mu)
    text += fmt::format("               model over prototype {:.6g}\n", *model.mu / *prototype.mu);
  auto compliances = std::pair(particle_compliance(prototype), particle_compliance(model));
  if (compliances.first || compliances.second)
    text += fmt::format(
        "(rho_t v^2 + 10 mu)/E: prototype {}, model {}; where it is small the particle is rigid and pi3 has no "
        "effect\n",
        compliances.first ? fmt::format("{:.2g}", *compliances.first) : "-",
        compliances.second ? fmt::format("{:.2g}", *compliances.second) : "-");
  return text;
}

json number_or_null(const std::optional<double>& number) { return number ? json(*number) : json(nullptr); }

std::string json_key(const SystemQuantity& quantity) {
  auto key = quantity.member == &System::mu ? std::string("mu_true") : quantity.key;
  return quantity.unit.empty() ? key : key + "_" + quantity.unit;
}

json as_json(const System& system, ModulusConvention convention) {
  json result = {{"particle", system.particle}, {"target", system.target}, {"convention", word(convention)}};
  for (const auto& quantity : system_quantities()) result[json_key(quantity)] = number_or_null(system.*quantity.member);
  bool known = system.mu && (convention == ModulusConvention::true_shear || system.alpha);
  result["mu_as_given_Pa"] =
      known ? json(modulus_as_given(*system.mu, system.alpha.value_or(1), convention)) : json(nullptr);
  return result;
}

json as_json(const ScaleJob& job, const Completion& completion, const std::vector<Comparison>& comparisons) {
  json groups = json::array(), derived = json::array(), obstacles = json::array();
  for (const auto& one : comparisons)
    groups.push_back({{"symbol", one.group->symbol},
                      {"formula", one.group->formula},
                      {"name", one.group->name},
                      {"prototype", number_or_null(one.prototype)},
                      {"model", number_or_null(one.model)},
                      {"agreement", word(one.agreement)},
                      {"difference", number_or_null(one.difference)},
                      {"missing_in_prototype", one.missing_in_prototype},
                      {"missing_in_model", one.missing_in_model}});
  for (const auto& one : completion.derived)
    derived.push_back({{"quantity", json_key(*one.quantity)}, {"value", one.value}, {"from", one.because->symbol}});
  for (const auto& conflict : completion.conflicts) obstacles.push_back(describe(conflict));
  for (const auto& gap : completion.gaps) obstacles.push_back(describe(gap));
  const auto& prototype = job.prototype.system;
  const auto& model = completion.model;
  bool has_ratio = prototype.mu && model.mu;
  return {{"schema", result_schema},
          {"version", version()},
          {"command", "scale"},
          {"job", std::filesystem::path(job.file).filename().string()},
          {"input", read_file(job.file)},
          {"tolerance", job.tolerance},
          {"prototype", as_json(prototype, job.prototype.convention)},
          {"model", as_json(model, job.model.convention)},
          {"groups", groups},
          {"derived", derived},
          {"not_similar_because", obstacles},
          {"modulus_ratio", has_ratio ? json(*model.mu / *prototype.mu) : json(nullptr)}};
}

std::string scene_comment(const ScaleJob& job, const Completion& completion) {
  return fmt::format(
      "{} made similar to {} ({}).\n"
      "Written by percal scale; every group that decides the run is equal in both, so both are one dimensionless "
      "problem.",
      title(completion.model), title(job.prototype.system),
      std::filesystem::path(job.prototype_scene->source).filename().string());
}

}  // namespace

Exit run_scale(const ScaleArguments& arguments, const Common& common) {
  auto job = read_job(arguments);
  auto completion = complete(job.prototype.system, job.model.system);
  if (!job.output_scene.empty()) require_similar(completion, job.file);
  if (common.check) return Exit::done;

  auto comparisons = compare(job.prototype.system, completion.model, job.tolerance);
  auto result = as_json(job, completion, comparisons);
  if (!job.output_scene.empty())
    write_file(job.output_scene,
               scene_to_toml(similar_scene(*job.prototype_scene, job.prototype.system, completion.model),
                             scene_comment(job, completion)));
  if (!common.out.empty())
    write_file((std::filesystem::path(common.out) / "result.json").string(), result.dump(2) + "\n");
  if (common.json) {
    fmt::print("{}\n", result.dump(2));
  } else if (!common.quiet) {
    fmt::print("{}", report(job, completion, comparisons));
    if (!job.output_scene.empty()) fmt::print("\nwrote {}\n", job.output_scene);
  }
  return Exit::done;
}

}  // namespace percal::tools
