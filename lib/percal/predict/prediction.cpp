#include "percal/predict/prediction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/campaign/sphere_runs.hpp"
#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr int points_of_curve = 25;
constexpr double beside_one_speed = 0.25;  // of it, on either side, where nothing else says how far a curve goes
constexpr double like_it = 0.02;           // relative: spheres that may stand beside a curve
constexpr double may_pass = 0.005;         // a probability of passing that is worth a sentence

bool is_like(const SphereShot& a, const SphereShot& b) {
  return place_of_body(a) == place_of_body(b) && std::abs(a.radius / b.radius - 1) < like_it &&
         std::abs(a.density / b.density - 1) < like_it;
}

// What was fired at, and what is asked for.
QuantityRange speeds_about(const SphereShot& shot, const std::vector<FiredShot>& fired) {
  QuantityRange range{shot.speed, shot.speed};
  for (const FiredShot& other : fired) {
    range.low = std::min(range.low, other.speed);
    range.high = std::max(range.high, other.speed);
  }
  if (range.low == range.high) return {range.low * (1 - beside_one_speed), range.high * (1 + beside_one_speed)};
  return range;
}

std::vector<SphereShot> at_speeds(const SphereShot& like, const std::vector<double>& speeds) {
  std::vector<SphereShot> shots(speeds.size(), like);
  for (std::size_t k = 0; k < speeds.size(); ++k) shots[k].speed = speeds[k];
  return shots;
}

// Each once, in the order of the shots.
std::vector<std::string> ways_outside(const Prediction& prediction) {
  std::vector<std::string> ways;
  const auto take = [&](const DepthPrediction& depth) {
    for (const std::string& way : depth.outside)
      if (std::ranges::find(ways, way) == ways.end()) ways.push_back(way);
  };
  for (const ShotPrediction& one : prediction.shots) take(one.depth);
  if (prediction.request.speeds)
    for (const auto* end : {&prediction.curve.front(), &prediction.curve.back()}) take(*end);
  return ways;
}

std::vector<std::string> findings_of(const Prediction& prediction, const ShotModel& model) {
  const ShotHypothesis& hypothesis = model.hypotheses[prediction.request.hypothesis];
  std::vector<std::string> findings;
  if (hypothesis.contradicted)
    findings.push_back(
        "The data contradict each other under this hypothesis: what follows from it is no prediction to rely on.");
  if (!prediction.request.columns_passed_over.empty())
    findings.push_back(
        "Columns of " + prediction.request.words.shots +
        " that say nothing of a shot were passed over: " + listed(prediction.request.columns_passed_over) + ".");
  for (const std::string& way : ways_outside(prediction)) findings.push_back("Beyond what was fitted: " + way + ".");
  for (const ShotPrediction& one : prediction.shots)
    if (!model.passage && one.depth.passes >= may_pass)
      findings.push_back(
          fmt::format("{}: as deep as the layer with a probability of {}. Depths near its lower face are "
                      "those of a layer that holds.",
                      one.shot.label, page::percent(one.depth.passes)));
  if (std::abs(hypothesis.mesh_error) > 0)
    findings.push_back(
        fmt::format("Depths are those of {:g} elements {}, as in the calibration, whose parameters make up for "
                    "it; without a mesh they would change by {}.",
                    model.elements,
                    prediction.request.body ? "on the smaller of half width and half thickness"
                    : hypothesis.materials.front().points.front().erosion_length ? "in the erosion length"
                                                                                 : "per radius",
                    page::signed_percent(hypothesis.mesh_error)));
  return findings;
}

}  // namespace

Prediction predict(const ShotModel& model, const PredictRequest& request) {
  const Predictor predictor(model, request.hypothesis, request.material, request.level);
  Prediction prediction{.request = request,
                        .material = predictor.material().name,
                        .hypothesis = model.hypotheses[request.hypothesis].name,
                        .passage = model.passage,
                        .beside = {},
                        .shots = {},
                        .speeds = {},
                        .curve = {},
                        .solved = {},
                        .fired = {},
                        .findings = {},
                        .cost = {}};
  for (const auto& [number, learnt] : model.beside)
    if (!request.body) prediction.beside.push_back(number);
  std::vector<NamedShot> asked = request.shots;
  if (request.looked_for) {
    prediction.solved = predictor.solve(*request.looked_for, asked.front(), request.depth, request.speed_error);
    if (prediction.solved->found) {
      static_cast<SphereShot&>(asked.front()) = prediction.solved->at;
      asked.front().label = words_of(asked.front());
    } else {
      asked.clear();
    }
  }
  const SphereShot* single = asked.size() == 1 ? &asked.front() : nullptr;
  if (single) {
    for (const FiredShot& shot : model.shots)
      if (shot.material == request.material && is_like(shot, *single)) prediction.fired.push_back(shot);
    const auto [low, high] = request.speeds.value_or(speeds_about(*single, prediction.fired));
    prediction.speeds = page::spaced(low, high, points_of_curve);
    prediction.curve = predictor.depths(at_speeds(*single, prediction.speeds), request.speed_error);
  }
  if (request.speeds) asked.clear();
  const std::vector<SphereShot> shots(asked.begin(), asked.end());
  const auto depths = predictor.depths(shots, request.speed_error);
  for (std::size_t k = 0; k < asked.size(); ++k) prediction.shots.push_back({asked[k], depths[k], {}, {}});
  for (std::size_t h = 0; h < model.hypotheses.size(); ++h) {
    if (static_cast<int>(h) == request.hypothesis) continue;
    const auto other = predictor.under(static_cast<int>(h)).best_depths(shots);
    for (std::size_t k = 0; k < asked.size(); ++k) prediction.shots[k].elsewhere.push_back(other[k]);
  }
  prediction.findings = findings_of(prediction, model);
  return prediction;
}

namespace {

MeanOfRuns mean_reach(const Problem& problem, const std::vector<Evaluation>& runs, double radius) {
  std::vector<double> reaches;
  for (const Evaluation& run : runs)
    if (const auto reach = reach_of(problem, run.result)) reaches.push_back(*reach * radius);
  return mean_of_runs(reaches.size() == runs.size() ? reaches : std::vector<double>{});
}

}  // namespace

void check_by_runs(Prediction& prediction, const ShotModel& model, Campaign& campaign) {
  const CoveredMaterial& material =
      model.hypotheses[prediction.request.hypothesis].materials[prediction.request.material].points.front();
  std::vector<Problem> problems;
  std::vector<Reduction> reductions;
  for (const ShotPrediction& one : prediction.shots) {
    const auto& body = one.shot.body;
    Scene scene =
        parse_scene(body ? model.bodies[body->place - 1].scene : model.scene, "scene of the calibration's runs");
    scene.mesh.elements_per_radius = mesh_of(one.shot, material, model.elements);
    reductions.push_back(reduce(scene_of_shot(std::move(scene), one.shot, material)));
    problems.push_back(reductions.back().problem);
  }
  Progress progress("runs", static_cast<long>(problems.size()) * model.replicates);
  const auto runs = campaign.replicate(problems, model.replicates, &progress);
  for (std::size_t k = 0; k < problems.size(); ++k) {
    ShotPrediction& one = prediction.shots[k];
    CheckedByRuns checked{.runs = model.replicates,
                          .outcome = summarise(runs[k], problems[k], reductions[k].scales).outcome,
                          .depth = mean_reach(problems[k], runs[k], one.shot.radius),
                          .standardised = {}};
    if (checked.depth.mean) {
      const double own = checked.depth.standard_error.value_or(0) / *checked.depth.mean;
      checked.standardised = std::log(*checked.depth.mean / one.depth.depth) / std::hypot(one.depth.by_emulator, own);
    }
    one.checked = std::move(checked);
  }
}

}  // namespace percal
