#include "percal/powder/powder_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/predict/request.hpp"

namespace percal {
namespace {

constexpr double worth_a_word = 5e-4;  // share of a powder

double layer_depth_of(const PowderJob& job, const ShotModel& calibration, int material) {
  if (job.layer_depth) return *job.layer_depth;
  const auto common =
      number_in_common(calibration.shots, material, [](const FiredShot& shot) { return shot.layer_depth; });
  if (!common)
    throw BadInput({job.file, 0, "layer_depth"}, "no such key, and the calibration's shots differ in it",
                   "the target's depth, such as \"2 mm\"");
  return *common;
}

double deepest_fitted(const ShotModel& calibration, int material) {
  const auto depths = numbers_of_shots(calibration.shots, material, Shots::fitted,
                                       [](const FiredShot& shot) { return shot.depth.value_or(0); });
  return depths ? depths->high : 0;
}

void check_depths(const PowderJob& job, double layer_depth) {
  const auto refuse = [&](const std::string& key, double depth) {
    throw BadInput({job.file, 0, key}, "a depth of " + format_quantity(depth, dimension::length),
                   "depths within the target's " + format_quantity(layer_depth, dimension::length) +
                       " (layer_depth, or that of the calibration's shots)");
  };
  const double within = layer_depth * (1 + rounding);
  if (!job.layers.empty() && job.layers.back().to > within) refuse("layers", job.layers.back().to);
  if (job.band && job.band->to > within) refuse("band", job.band->to);
}

// Of the fitted shots.
struct FittedRange {
  const char* name;
  Dimension dimension;
  double PowderParticle::*number;
  Between fitted;
  bool has(const PowderParticle& particle) const {
    return particle.*number >= fitted.low * (1 - rounding) && particle.*number <= fitted.high * (1 + rounding);
  }
};
std::vector<FittedRange> fitted_ranges(const ShotModel& calibration, int material) {
  std::vector<FittedRange> ranges;
  const auto add = [&](const char* name, const Dimension& dimension, double PowderParticle::*number, auto of_shot) {
    if (const auto fitted = numbers_of_shots(calibration.shots, material, Shots::fitted, of_shot))
      ranges.push_back({name, dimension, number, *fitted});
  };
  add("radii", dimension::length, &PowderParticle::radius, [](const FiredShot& shot) { return shot.radius; });
  add("densities", dimension::density, &PowderParticle::density, [](const FiredShot& shot) { return shot.density; });
  add("speeds", dimension::speed, &PowderParticle::speed, [](const FiredShot& shot) { return shot.speed; });
  return ranges;
}

// How many of the calibration's shots went in although they are below the breach.
std::pair<int, int> shots_below(const Breach& breach, const PowderModel& model) {
  int below = 0, all = 0;
  for (const FiredShot& shot : model.calibration->shots) {
    if (shot.material != model.material || !shot.depth) continue;
    ++all;
    if (impact_parameter({shot.radius, shot.density, shot.speed}) < breach.impact_parameter) ++below;
  }
  return {below, all};
}

std::string in_words(const BeyondFitted& beyond) {
  const std::string shares = fmt::format("{} of the mass, {} of the particles", page::percent(beyond.by_mass),
                                         page::percent(beyond.by_number));
  if (beyond.number == "emulator's runs")
    return fmt::format("Beyond the emulator's runs: {}. Depths there go on as its trend does.", shares);
  const auto words = [&](double x) { return format_quantity(x, beyond.dimension, 3); };
  const std::string range =
      is_one(beyond.fitted) ? words(beyond.fitted.low) : words(beyond.fitted.low) + " to " + words(beyond.fitted.high);
  return fmt::format("Beyond the {} fitted, {}: {}.", beyond.number, range, shares);
}

}  // namespace

SphereShot PowderModel::shot_of(const PowderParticle& particle) const {
  return {.radius = particle.radius,
          .density = particle.density,
          .speed = particle.speed,
          .layer_depth = question.layer_depth,
          .layer_width = width_in_radii * particle.radius};
}

PowderModel powder_model(const PowderJob& job, const ShotModel& calibration) {
  const int hypothesis = hypothesis_named(job.hypothesis.text, calibration, job.hypothesis.place),
            material = material_named(job.material.text, calibration, job.material.place);
  const double level = job.level.value_or(calibration.level);
  const FiredShot& fired = calibration.shots.front();
  PowderModel model{.calibration = &calibration,
                    .hypothesis = hypothesis,
                    .material = material,
                    .predictor = Predictor(calibration, hypothesis, material, level),
                    .forward = {},
                    .question = {.bounce = job.bounce,
                                 .layer_depth = layer_depth_of(job, calibration, material),
                                 .ends = {},
                                 .band = job.band,
                                 .known_depth = deepest_fitted(calibration, material),
                                 .level = level},
                    .width_in_radii = fired.layer_width / fired.radius};
  check_depths(job, model.question.layer_depth);
  for (const DepthLayer& layer : job.layers) model.question.ends.push_back(layer.to);
  const MaterialSample& sample = model.predictor.material();
  model.forward.scatter = job.scatter.value_or(sample.scatter);
  model.forward.freedom = job.scatter ? 0 : sample.freedom;
  const auto shots = [shape = model](std::span<const PowderParticle> particles) {
    std::vector<SphereShot> all;
    for (const PowderParticle& particle : particles) all.push_back(shape.shot_of(particle));
    return all;
  };
  model.forward.log_depths = [shots, predictor = model.predictor](std::span<const PowderParticle> particles) {
    return predictor.log_depths(shots(particles));
  };
  model.forward.errors = [shots, predictor = model.predictor](std::span<const PowderParticle> particles) {
    return predictor.emulator_errors(shots(particles));
  };
  model.forward.has_seen = [shape = model, ranges = fitted_ranges(calibration, material)](const PowderParticle& one) {
    return std::ranges::all_of(ranges, [&](const FittedRange& range) { return range.has(one); }) &&
           shape.predictor.beyond_runs(shape.shot_of(one)) == 0;
  };
  return model;
}

std::vector<BeyondFitted> beyond_fitted(const std::vector<ParticleClass>& classes, const PowderModel& model) {
  std::vector<BeyondFitted> found;
  const auto add = [&](BeyondFitted one, const auto& is_beyond) {
    for (const ParticleClass& each : classes) {
      if (!is_beyond(middle_of(each))) continue;
      one.by_number += each.number;
      one.by_mass += each.mass;
    }
    if (std::max(one.by_number, one.by_mass) >= worth_a_word) found.push_back(one);
  };
  for (const FittedRange& range : fitted_ranges(*model.calibration, model.material))
    add({range.name, range.dimension, range.fitted},
        [&](const PowderParticle& particle) { return !range.has(particle); });
  add({"emulator's runs", dimension::none, {}},
      [&](const PowderParticle& particle) { return model.predictor.beyond_runs(model.shot_of(particle)) > 0; });
  return found;
}

std::vector<std::string> model_findings(const PowderJob& job, const PowderModel& model,
                                        const std::vector<BeyondFitted>& beyond) {
  std::vector<std::string> findings;
  if (model.of_hypothesis().contradicted)
    findings.push_back(
        "The calibration's data contradict each other under this hypothesis: what follows from it is nothing to rely "
        "on.");
  for (const BeyondFitted& one : beyond) findings.push_back(in_words(one));
  if (const auto* breach = std::get_if<Breach>(&job.bounce))
    if (const auto [below, all] = shots_below(*breach, model); below > 0)
      findings.push_back(fmt::format(
          "{} of the calibration's {} shots into {} went in although they are below the breach of {}: particles that "
          "count as bounced may go in.",
          below, all, model.predictor.material().name,
          format_quantity(breach->impact_parameter, dimension::impact_parameter, 3)));
  if (!job.layers.empty())
    findings.push_back(
        fmt::format("Layers are places in depth: the calibration's {} goes through all of them.",
                    model.predictor.material().points.front().covers.empty() ? "one material" : "target"));
  if (const double cell = model.predictor.material().points.front().laws.cell; cell > 0)
    findings.push_back(
        fmt::format("Depths change at once at the cell's size of {}; here they do so over 12 % of the size.",
                    format_quantity(cell, dimension::length, 3)));
  return findings;
}

}  // namespace percal
