#include "percal/predict/predictor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "percal/math/root.hpp"
#include "percal/predict/mixture.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double least_deviation = 1e-6;  // of ln depth: nothing is known better
constexpr double close_enough = 1e-7;     // of the logarithm of a number that is solved for

Between interval_of(const Mixture& mixture, double level) {
  return {mixture.quantile(0.5 - level / 2), mixture.quantile(0.5 + level / 2)};
}

Between natural(const Between& logarithms) { return {std::exp(logarithms.low), std::exp(logarithms.high)}; }

// One shot about the sample's answers, `centres`: to `range`, of which by_emulator and by_speed are known, all the rest.
Mixture about_sample(Eigen::VectorXd centres, const SampleScatter& own, double level, PredictedRange& range) {
  Mixture mixture{.centres = std::move(centres), .deviation = std::max(least_deviation, range.by_emulator)};
  range.by_scatter = own.scatter;
  range.by_parameters = mixture.spread();
  range.mean = natural(interval_of(mixture, level));
  mixture.deviation = std::hypot(mixture.deviation, range.by_scatter, range.by_speed);
  mixture.freedom = own.freedom;
  range.shot = natural(interval_of(mixture, level));
  return mixture;
}

SphereShot with(SphereShot shot, ShotNumber number, double value) {
  if (number == ShotNumber::speed) shot.speed = value;
  if (number == ShotNumber::density) shot.density = value;
  if (number == ShotNumber::diameter) {
    shot.layer_width *= value / 2 / shot.radius;  // as wide in radii
    shot.radius = value / 2;
  }
  return shot;
}

double number_of(const SphereShot& shot, ShotNumber number) {
  if (number == ShotNumber::speed) return shot.speed;
  return number == ShotNumber::density ? shot.density : 2 * shot.radius;
}

}  // namespace

Predictor::Predictor(const ShotModel& model, int hypothesis, int material, double level)
    : model_(&model), emulators_(emulators_of(model)), hypothesis_(hypothesis), material_(material), level_(level) {
  for (const auto& [of, emulator] : emulators_.of)
    if (of.number == RunNumber::depth) scales_.emplace(of.body, scale_of(emulator.runs()));
}

MatrixXd Predictor::log_depths(std::span<const CoveredMaterial> points, std::span<const SphereShot> shots) const {
  std::vector<SphereInputs> at;
  std::vector<EmulatorOf> wanted;
  for (const SphereShot& shot : shots)
    for (const CoveredMaterial& point : points) {
      at.push_back(shot_inputs(shot, point).at);
      wanted.push_back({place_of_body(shot)});
    }
  const auto rows = static_cast<Eigen::Index>(points.size()), columns = static_cast<Eigen::Index>(shots.size());
  MatrixXd depths = emulators_.answers(at, wanted, 1 / model_->elements, false).log_depth.reshaped(rows, columns);
  for (Eigen::Index k = 0; k < columns; ++k) depths.col(k).array() += std::log(shots[k].radius);
  return depths;
}

MatrixXd Predictor::log_depths(std::span<const SphereShot> shots) const { return log_depths(material().points, shots); }

VectorXd Predictor::emulator_errors(std::span<const SphereShot> shots) const {
  VectorXd errors(static_cast<Eigen::Index>(shots.size()));
  for (std::size_t k = 0; k < shots.size(); ++k) {
    const SphereInputs at = shot_inputs(shots[k], material().points.front()).at;
    errors[static_cast<Eigen::Index>(k)] =
        std::sqrt(emulators_.depth(place_of_body(shots[k])).depth({at}, 1 / model_->elements, true).covariance(0, 0));
  }
  return errors;
}

double Predictor::beyond_runs(const SphereShot& shot) const {
  const InputScale& scale = scales_.at(place_of_body(shot));
  const double furthest = scale.scaled(shot_inputs(shot, material().points.front()).at).cwiseAbs().maxCoeff();
  return furthest > 1 + rounding ? furthest - 1 : 0;
}

Predictor Predictor::under(int hypothesis) const {
  Predictor other = *this;
  other.hypothesis_ = hypothesis;
  return other;
}

std::vector<double> Predictor::best_depths(std::span<const SphereShot> shots) const {
  const MatrixXd depths = log_depths(std::span(material().points).first(1), shots).array().exp();
  return {depths.data(), depths.data() + depths.size()};
}

std::vector<DepthPrediction> Predictor::depths(std::span<const SphereShot> shots, double speed_error) const {
  const MatrixXd of_points = log_depths(shots);
  std::vector<DepthPrediction> predictions;
  for (std::size_t k = 0; k < shots.size(); ++k) {
    const ShotInputs best = shot_inputs(shots[k], material().points.front());
    const DepthAnswers answer = emulators_.depth(place_of_body(shots[k])).depth({best.at}, 1 / model_->elements, true);
    DepthPrediction prediction;
    prediction.speed_exponent = answer.gradient.row(0).dot(best.by_log_speed);
    prediction.by_emulator = std::sqrt(answer.covariance(0, 0));
    prediction.by_speed = std::abs(prediction.speed_exponent) * speed_error;
    const Mixture shot = about_sample(of_points.col(static_cast<Eigen::Index>(k)),
                                      {material().scatter, material().freedom}, level_, prediction);
    prediction.depth = std::exp(shot.centres[0]);
    prediction.passes = 1 - shot.share_below(std::log(shots[k].layer_depth));
    prediction.outside = outside(shots[k]);
    for (const auto& [number, learnt] : model_->beside)
      if (!shots[k].body) prediction.beside[number] = this->number(number, shots[k], speed_error);
    predictions.push_back(std::move(prediction));
  }
  return predictions;
}

// As the depth's, about the number's own scatter.
NumberPrediction Predictor::number(RunNumber number, const SphereShot& shot, double speed_error) const {
  std::vector<SphereInputs> at;
  for (const CoveredMaterial& point : material().points) at.push_back(shot_inputs(shot, point).at);
  const double h = 1 / model_->elements;
  const ShotInputs best = shot_inputs(shot, material().points.front());
  const DepthAnswers answer = emulators_.answers({best.at}, {{0, number}}, h, true);
  NumberPrediction prediction;
  prediction.by_emulator = std::sqrt(answer.covariance(0, 0));
  prediction.by_speed = std::abs(answer.gradient.row(0).dot(best.by_log_speed)) * speed_error;
  VectorXd centres = emulators_.answers(at, std::vector(at.size(), EmulatorOf{0, number}), h, false).log_depth;
  centres.array() += std::log(shot.radius);
  prediction.value = std::exp(centres[0]);
  about_sample(std::move(centres), material().beside.at(number), level_, prediction);
  return prediction;
}

// Each point of the sample has a root of its own; about it an error of ln depth is one of the number by the depth's slope.
SolvedShot Predictor::solve(ShotNumber wanted, const SphereShot& like, double depth, double speed_error) const {
  const double begin = std::log(number_of(like, wanted)), reach = std::log(solved_within);
  const auto& points = material().points;
  const auto excess = [&](const CoveredMaterial& point, double log_number) {
    const SphereShot shot = with(like, wanted, std::exp(log_number));
    return log_depths(std::span(&point, 1), std::span(&shot, 1))(0, 0) - std::log(depth);
  };
  Mixture mixture{.centres = VectorXd(static_cast<Eigen::Index>(points.size()))};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto of_point = [&](double log_number) { return excess(points[k], log_number); };
    // The first bracket is about the last root: those of a sample lie close together.
    const double centre = k == 0 ? begin : mixture.centres[static_cast<Eigen::Index>(k) - 1];
    double step = k == 0 ? 0.5 : 0.1, low = centre - step, high = centre + step;
    while (of_point(low) > 0 && low > begin - reach) low -= (step *= 2);
    while (of_point(high) < 0 && high < begin + reach) high += (step *= 2);
    if (of_point(low) > 0 || of_point(high) < 0) return {};
    mixture.centres[static_cast<Eigen::Index>(k)] = root(of_point, low, high, close_enough);
  }
  SolvedShot solved;
  solved.found = true;
  solved.value = std::exp(mixture.centres[0]);
  solved.at = with(like, wanted, solved.value);
  const DepthPrediction there = depths(std::span(&solved.at, 1), speed_error).front();
  constexpr double small = 0.01;
  const double slope =
      (excess(points[0], mixture.centres[0] + small) - excess(points[0], mixture.centres[0] - small)) / (2 * small);
  const double per_depth = 1 / std::max(std::abs(slope), small);
  mixture.deviation = std::max(least_deviation, there.by_emulator) * per_depth;
  solved.mean = natural(interval_of(mixture, level_));
  mixture.deviation =
      std::hypot(std::max(least_deviation, there.by_emulator), there.by_scatter, there.by_speed) * per_depth;
  mixture.freedom = material().freedom;
  solved.shot = natural(interval_of(mixture, level_));
  solved.outside = there.outside;
  return solved;
}

// Beyond the material's fitted shots, or beyond the emulator's runs.
std::vector<std::string> Predictor::outside(const SphereShot& shot) const {
  std::vector<std::string> found;
  const auto compare = [&](const char* name, const Dimension& dimension, auto number) {
    const auto fitted =
        numbers_of_shots(shots_of_body(model_->shots, place_of_body(shot)), material_, Shots::fitted, number);
    const double value = number(shot);
    if (!fitted || (value >= fitted->low * (1 - rounding) && value <= fitted->high * (1 + rounding))) return;
    const auto words = [&](double x) { return format_quantity(x, dimension, 3); };
    const std::string range = is_one(*fitted) ? words(fitted->low) : words(fitted->low) + " to " + words(fitted->high);
    found.push_back(fmt::format("{} {}, fitted {}", name, words(value), range));
  };
  compare("speed", dimension::speed, [](const SphereShot& s) { return s.speed; });
  if (!shot.body) compare("diameter", dimension::length, [](const SphereShot& s) { return 2 * s.radius; });
  compare("density", dimension::density, [](const SphereShot& s) { return s.density; });
  compare("layer", dimension::length, [](const SphereShot& s) { return s.layer_depth; });
  if (const double beyond = beyond_runs(shot); beyond > 0)
    found.push_back(fmt::format("the emulator's runs end {:.0f} % of their range before it", 50 * beyond));
  return found;
}

}  // namespace percal
