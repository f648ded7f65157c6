// percal impact: one scene, its replicates, the summary.
#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "accuracy.hpp"
#include "colour.hpp"
#include "commands.hpp"
#include "impact_views.hpp"
#include "percal/base/progress.hpp"
#include "percal/base/version.hpp"
#include "percal/campaign/campaign.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/observe/penetration.hpp"
#include "percal/observe/result_json.hpp"
#include "percal/problem/problem.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/text/file.hpp"
#include "percal/units/quantity.hpp"

namespace percal::tools {
namespace {

using Json = nlohmann::json;

Scene scene_with_options(const ImpactArguments& arguments) {
  Scene scene = read_scene(arguments.scene);
  if (arguments.elements_per_radius) scene.mesh.elements_per_radius = *arguments.elements_per_radius;
  if (arguments.replicates) scene.replicates = *arguments.replicates;
  if (arguments.arithmetic)
    scene.solver.arithmetic =
        *arguments.arithmetic == "double" ? Arithmetic::double_precision : Arithmetic::single_precision;
  if (!arguments.history.empty()) scene.output.history = true;
  return scene;
}

// The first replicate keeps the history and is looked at; the others, which are for the scatter, aren't.
std::vector<Evaluation> evaluate(Campaign& campaign, const Problem& problem, int replicates, FrameObserver* observer) {
  Progress progress("impact", replicates);
  std::vector<Problem> problems(replicates, problem);
  for (int k = 0; k < replicates; ++k) {
    problems[k].speed_factor = replicate_speed_factor(k);
    if (k > 0) problems[k].history_samples = 0;
  }
  return campaign.evaluate(problems, &progress, observer);
}

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

struct Findings {
  const Scene& scene;
  const Reduction& reduction;
  const std::vector<Evaluation>& runs;
  const Penetration& penetration;
  const std::vector<std::string>& warnings;
  double wall_seconds;
  CampaignCost cost;
  const std::optional<AccuracyChoice>& accuracy;
  const ImpactViews& views;
};

Json to_json(const Findings& f) {
  Json left_out = Json::array(), runs = Json::array();
  for (const auto& omission : f.reduction.left_out)
    left_out.push_back({{"what", omission.what}, {"why", omission.why}});
  for (std::size_t k = 0; k < f.runs.size(); ++k) {
    const auto& r = f.runs[k].result;
    runs.push_back({{"speed_factor", replicate_speed_factor(static_cast<int>(k))},
                    {"outcome", word(r.outcome)},
                    {"depth_m", f.penetration.depths[k]},
                    {"steps", r.steps},
                    {"eroded", r.eroded},
                    {"smallest_jacobian", r.smallest_jacobian},
                    {"smallest_step_over_first", r.smallest_step},
                    {"largest_gap_over_element", r.largest_gap},
                    {"turn_rad", r.turn},
                    {"energy_closure", r.energy.closure()},
                    {"cpu_s", f.runs[k].cpu_seconds},
                    {"reused", f.runs[k].reused}});
  }
  const auto& first = f.runs.front().result;
  const auto& series = f.views.series();
  return {{"schema", result_schema},
          {"percal", version()},
          {"command", "impact"},
          {"input", {{"scene", f.scene.source}, {"toml", scene_to_toml(f.scene, "")}}},
          {"outcome", word(f.penetration.outcome)},
          {"depth_m", optional_json(f.penetration.depth)},
          {"depth_spread_m", optional_json(f.penetration.spread)},
          {"depth_standard_error_m", optional_json(f.penetration.standard_error)},
          {"depth_at_least_m", optional_json(f.penetration.at_least)},
          {"mu_as_given_Pa", f.scene.target.mu_as_given},
          {"mu_true_Pa", f.reduction.mu_true},
          {"convention", word(f.scene.target.convention)},
          {"bulk_modulus_Pa", f.reduction.bulk_modulus},
          {"bulk_was_chosen", f.reduction.bulk_was_chosen},
          {"mach", f.reduction.mach},
          {"steps", first.steps},
          {"elements", first.elements},
          {"element_steps", first.element_steps},
          {"energy", energy_to_json(f.penetration.energy)},
          {"energy_worst_closure", f.penetration.worst_closure},
          {"history", first.history.empty() ? Json(nullptr) : history_to_json(first.history, f.reduction.scales)},
          {"fields", series ? Json{{"list", series->list()}, {"frames", series->frames()}} : Json(nullptr)},
          {"picture", f.views.picture().empty() ? Json(nullptr) : Json(f.views.picture())},
          {"runs", runs},
          {"wall_s", f.wall_seconds},
          {"cpu_s", f.cost.cpu_seconds},
          {"reused", f.cost.reused},
          {"isa", f.runs.front().instruction_level},
          {"accuracy", f.accuracy ? accuracy_to_json(*f.accuracy) : Json(nullptr)},
          {"left_out", left_out},
          {"warnings", f.warnings}};
}

void print_energy(const EnergyLedger& e) {
  fmt::print("  energy, shares of the impact energy (mean of the runs)\n");
  const std::pair<const char*, double> rows[] = {{"particle, kinetic", e.particle},
                                                 {"particle, elastic", e.particle_elastic},
                                                 {"nodes with elements, kinetic", e.live_kinetic},
                                                 {"freed mass, kinetic", e.freed_mass},
                                                 {"elastic", e.elastic},
                                                 {"hourglass springs", e.hourglass},
                                                 {"bulk viscosity", e.viscosity},
                                                 {"relaxation", e.relaxation},
                                                 {"eroded elements", e.eroded},
                                                 {"contact springs", e.contact},
                                                 {"contact springs dropped at erosion", e.contact_dropped}};
  for (const auto& [name, share] : rows)
    if (share != 0) fmt::print("    {:<36}{:8.4f}\n", name, share);  // what the scene does not have is not listed
  fmt::print("    {:<36}{:8.4f}\n", "sum", e.sum());
}

void print_accuracy(const AccuracyChoice& choice) {
  const auto& advice = choice.advice;
  fmt::print("\n  estimated error {:.2g} % (mesh {:.2g} %, noise {:.2g} %), from the scene's study{}",
             100 * advice.error, 100 * advice.discretisation_error, 100 * advice.noise_error,
             advice.cost_is_estimated ? ", by extrapolation beyond its meshes" : "");
}

// The accuracy asked for is not in reach: no impact is run.
Exit refuse_accuracy(const AccuracyChoice& choice, const Common& common) {
  if (common.json)
    fmt::print("{}\n", Json{{"schema", result_schema},
                            {"percal", version()},
                            {"command", "impact"},
                            {"outcome", nullptr},
                            {"depth_m", nullptr},
                            {"accuracy", accuracy_to_json(choice)}}
                           .dump(2));
  else if (!common.quiet)
    fmt::print("not run. {}\n", choice.refusal());
  return Exit::outcome_not_reached;
}

void print(const Findings& f) {
  const auto length = [](double metres) { return format_quantity(metres, dimension::length); };
  const auto& p = f.penetration;
  const auto& first = f.runs.front().result;
  const bool reached = p.outcome == Outcome::stopped || p.outcome == Outcome::passed_through;
  fmt::print("{} into {}: {}", f.scene.particle.name, f.scene.target.name,
             reached ? green(word(p.outcome)) : red(word(p.outcome)));
  if (p.depth) fmt::print(", depth {}", length(*p.depth));
  if (p.spread)
    fmt::print(" (spread of {} runs {}, standard error {})", f.runs.size(), length(*p.spread),
               length(*p.standard_error));
  if (p.at_least) fmt::print(", deeper than the target's {}", length(*p.at_least));
  if (f.accuracy) print_accuracy(*f.accuracy);
  fmt::print("\n  mu {} as given ({}), {} true; K {} ({}), Mach {:.3g}\n",
             format_quantity(f.scene.target.mu_as_given, dimension::pressure), word(f.scene.target.convention),
             format_quantity(f.reduction.mu_true, dimension::pressure),
             format_quantity(f.reduction.bulk_modulus, dimension::pressure),
             f.reduction.bulk_was_chosen ? fmt::format("chosen: K/mu {:.4g}", f.reduction.problem.bulk_ratio) : "given",
             f.reduction.mach);
  if (first.steps == 0) return;
  fmt::print(
      "  {} elements ({} per radius), {} steps, {} eroded, smallest J {:.3f}, smallest step {:.3f} of the first\n",
      first.elements, f.reduction.problem.elements_per_radius, first.steps, first.eroded, first.smallest_jacobian,
      first.smallest_step);
  print_energy(p.energy);
  fmt::print("  left out\n");
  for (const auto& omission : f.reduction.left_out) fmt::print("    {}: {}\n", omission.what, omission.why);
  fmt::print("  {} runs, {} from the store, {:.2f} s of processor time, {:.2f} s in all, {}\n", f.cost.runs,
             f.cost.reused, f.cost.cpu_seconds, f.wall_seconds, f.runs.front().instruction_level);
  if (const auto& series = f.views.series())
    fmt::print("  {} frames of the first run: {}\n", series->frames(), series->list());
  for (const auto& warning : f.warnings) fmt::print("  {} {}\n", yellow("warning:"), warning);
}

// Of the run that is shown.
std::string picture_title(const Scene& scene, const Reduction& reduction, const ImpactResult& run) {
  return fmt::format("{} into {}: {}, depth {}", scene.particle.name, scene.target.name, word(run.outcome),
                     format_quantity(run.depth * reduction.scales.radius, dimension::length));
}

}  // namespace

Exit run_impact(const ImpactArguments& arguments, const Common& common) {
  const auto start = std::chrono::steady_clock::now();
  Scene scene = scene_with_options(arguments);
  Reduction reduction = reduce(scene);
  std::optional<double> target;
  if (!arguments.accuracy.empty()) target = parse_accuracy(arguments.accuracy);
  check_views(arguments);
  if (common.check) {
    if (common.json)
      fmt::print("{}\n", Json{{"command", "impact"}, {"scene", arguments.scene}, {"valid", true}}.dump());
    else if (!common.quiet)
      fmt::print("{}: a scene that can be run\n", arguments.scene);
    return Exit::done;
  }
  if (!common.out.empty()) ensure_writable_folder(common.out);
  if (!arguments.history.empty()) ensure_writable(arguments.history);
  ensure_views_can_be_made(arguments);
  Store store(common.store.empty() ? default_store_path() : common.store);
  std::optional<AccuracyChoice> accuracy;
  if (target) {
    accuracy = choose_setting(scene, *target, store, common);
    if (!accuracy->can_be_run()) return refuse_accuracy(*accuracy, common);
    scene = with_setting(scene, *accuracy);
    reduction = reduce(scene);
  }
  Campaign campaign(&store, common.threads);
  ImpactViews views(arguments, common, reduction);
  const auto runs = evaluate(campaign, reduction.problem, scene.replicates, views.observer());
  const Penetration penetration = summarise(runs, reduction.problem, reduction.scales);
  auto notes = warnings(penetration, runs, reduction.problem);
  notes.insert(notes.begin(), reduction.warnings.begin(), reduction.warnings.end());
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const Findings findings{scene, reduction, runs, penetration, notes, wall, campaign.cost(), accuracy, views};
  if (!arguments.history.empty())
    write_file(arguments.history, history_csv(runs.front().result.history, reduction.scales));
  const std::string result =
      to_json(findings).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";  // a path need not be UTF-8
  if (!common.out.empty()) {
    write_file(common.out + "/result.json", result);
    if (scene.output.history)
      write_file(common.out + "/history.csv", history_csv(runs.front().result.history, reduction.scales));
  }
  if (common.json)
    fmt::print("{}", result);
  else if (!common.quiet)
    print(findings);
  views.draw(picture_title(scene, reduction, runs.front().result));
  const bool reached = penetration.outcome == Outcome::stopped || penetration.outcome == Outcome::passed_through;
  return reached ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace percal::tools
