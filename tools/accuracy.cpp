#include "accuracy.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "percal/base/progress.hpp"
#include "percal/study/kept_ladder.hpp"
#include "percal/study/page/error_vs_time.hpp"
#include "percal/units/quantity.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

constexpr double finest_accuracy = 0.001, coarsest_accuracy = 0.5;
constexpr double farthest_extrapolation = 1.5;  // of the ladder's finest mesh

}  // namespace

double parse_accuracy(const std::string& text) {
  const auto refuse = [&]() -> double {
    throw BadInput(Place{.file = "", .line = 0, .key = "--accuracy"}, in_quotes(text),
                   fmt::format("a share of the depth from {0}% to {1}%, as \"2%\" or \"0.02\"", 100 * finest_accuracy,
                               100 * coarsest_accuracy));
  };
  std::string number = text;
  while (!number.empty() && number.back() == ' ') number.pop_back();
  const bool is_percent = !number.empty() && number.back() == '%';
  if (is_percent) number.pop_back();
  double value = 0;
  try {
    const Quantity quantity = parse_quantity(number);
    if (quantity.dimension != dimension::none) return refuse();
    value = is_percent ? quantity.value / 100 : quantity.value;
  } catch (const std::invalid_argument&) {
    return refuse();
  }
  constexpr double round_off = 1e-12;
  if (!(value >= finest_accuracy * (1 - round_off) && value <= coarsest_accuracy)) return refuse();
  return value;
}

bool AccuracyChoice::can_be_run() const {
  return advice.is_found && advice.elements_per_radius <= farthest_extrapolation * ladder.meshes.back();
}

std::string AccuracyChoice::refusal() const {
  if (!advice.is_found) return fmt::format("an error of {:.3g} %: {}", 100 * advice.target, advice.why_not);
  return fmt::format(
      "an error of {:.3g} %: no mesh of the ladder (up to {} elements per radius) reaches it; by extrapolation {} "
      "elements "
      "per radius and {} replicates would, in about {:.3g} s of processor time: run these by --elements-per-radius and "
      "--replicates, or a finer ladder by percal study --meshes",
      100 * advice.target, ladder.meshes.back(), advice.elements_per_radius, advice.replicates, advice.cpu_seconds);
}

AccuracyChoice choose_setting(const Scene& scene, double target, Store& store, const Common& common) {
  const std::string key = study_key(scene);
  const auto kept = kept_ladder(store, key);
  const LadderOptions options = kept.value_or(LadderOptions{});
  const bool talk = !common.quiet && !common.json;
  if (talk && !kept) {
    fmt::print("no study of this scene is kept: its error against time is measured first, by {} runs\n",
               ladder_runs(options));
    std::fflush(stdout);
  }
  Campaign campaign(&store, common.threads);
  const Ladder ladder = [&] {
    Progress progress("study", ladder_runs(options));
    return run_ladder(scene, options, campaign, &progress);
  }();
  if (!kept) keep_ladder(store, key, ladder.options);
  const AdvisedSetting advice = advise(ladder, error_vs_time(ladder), target);
  if (talk && !kept) fmt::print("the study took {:.1f} s of processor time and is kept\n", campaign.cost().cpu_seconds);
  return {advice, ladder.options, kept.has_value(), campaign.cost()};
}

Scene with_setting(const Scene& scene, const AccuracyChoice& choice) {
  Scene set = rung_scene(scene, choice.advice.elements_per_radius, choice.ladder.time_step_factor.value(),
                         Arithmetic::single_precision);
  set.output = scene.output;
  set.replicates = choice.advice.replicates;
  return set;
}

nlohmann::json accuracy_to_json(const AccuracyChoice& choice) {
  auto json = advice_to_json(choice.advice);
  json["ladder"] = {{"elements_per_radius", choice.ladder.meshes},
                    {"replicates", choice.ladder.replicates},
                    {"time_step_factor", choice.ladder.time_step_factor.value()}};
  json["study_was_kept"] = choice.study_was_kept;
  json["study_cpu_s"] = choice.study_cost.cpu_seconds;
  return json;
}

}  // namespace percal::tools
