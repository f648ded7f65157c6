// percal scale JOB: the ten groups of two systems, the model's missing values, and the similar scene.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "percal/problem/scale_job.hpp"
#include "percal/problem/similar_scene.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

ScaleJob read_job(const ScaleArguments& arguments) {
  ScaleJob job = read_scale_job(arguments.job);
  if (!arguments.write_scene.empty()) job.output_scene = arguments.write_scene;
  check_output_scene(job);
  return job;
}

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

std::string scene_comment(const ScaleJob& job, const Completion& completion) {
  return fmt::format(
      "{} made similar to {} ({}).\n"
      "Written by percal scale; every group that decides the run is equal in both, so both are one dimensionless "
      "problem.",
      title(completion.model), title(job.prototype.system),
      std::filesystem::path(job.prototype_scene->source).filename().string());
}

Exit say_valid(const ScaleArguments& arguments, const Common& common) {
  if (common.json)
    fmt::print("{}\n", nlohmann::json{{"command", "scale"}, {"job", arguments.job}, {"valid", true}}.dump());
  else if (!common.quiet)
    fmt::print("{}: a job that can be run\n", arguments.job);
  return Exit::done;
}

}  // namespace

Exit run_scale(const ScaleArguments& arguments, const Common& common) {
  auto job = read_job(arguments);
  auto completion = complete(job.prototype.system, job.model.system);
  if (!job.output_scene.empty()) require_similar(completion, job.file);
  if (common.check) return say_valid(arguments, common);

  auto comparisons = compare(job.prototype.system, completion.model, job.tolerance);
  auto result = scale_to_json(job, completion, comparisons);
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
