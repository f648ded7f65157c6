#include "percal/calibrate/cards.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "percal/calibrate/shot_problem.hpp"
#include "percal/text/sha256.hpp"

namespace percal {
namespace {

// Natural values of all the job's parameters, the held ones included.
std::vector<double> natural_of(const CalibrationJob& job, const ReadingResult& result) {
  std::vector<double> natural(job.parameters.size());
  for (const auto& [k, value] : job.readings[result.reading].held) natural[k] = value;
  const Eigen::VectorXd& searched = result.minima.front().searched;
  for (std::size_t i = 0; i < result.parameters.size(); ++i)
    natural[result.parameters[i]] =
        job.parameters[result.parameters[i]].free.natural(searched[static_cast<Eigen::Index>(i)]);
  return natural;
}

CardInterval card_interval(const std::string& parameter, const Interval& interval) {
  const auto end = [](double value, bool open) {
    return open || !std::isfinite(value) ? std::nullopt : std::optional(value);
  };
  return {parameter, end(interval.low, interval.low_open), end(interval.high, interval.high_open)};
}

// The interval of a material's number that was fitted.
void add_fitted(const ReadingResult& result, const MaterialNumber& number, const std::string& name,
                CardIntervals& intervals) {
  const auto* shared = std::get_if<SharedParameter>(&number);
  if (!shared) return;
  for (const ProfileInterval& interval : result.intervals)
    if (result.parameters[interval.parameter] == shared->index)
      intervals.of.push_back(card_interval(name, interval.interval));
}

CardIntervals intervals_of(const CalibrationJob& job, const ReadingResult& result,
                           const CalibrationMaterial& material) {
  CardIntervals intervals{job.level, {}};
  for (const MaterialModuli& moduli : result.moduli) {
    if (moduli.material != material.name) continue;
    intervals.of.push_back(card_interval("mu_true_Pa", moduli.mu_true.interval));
    intervals.of.push_back(card_interval("mu_over_alpha_Pa", moduli.mu_over_alpha.interval));
  }
  add_fitted(result, material.alpha, "alpha", intervals);
  add_fitted(result, material.erosion_strain, "erosion_strain", intervals);
  return intervals;
}

double bulk_ratio(const CalibrationJob& job, int material, const MaterialAt& at) {
  enum { log_bulk_ratio = 5 };
  double ratio = least_bulk_ratio;
  for (const MeasuredShot& shot : job.shots)
    if (shot.material == material) ratio = std::max(ratio, std::exp(shot_inputs(shot, at).at[log_bulk_ratio]));
  return ratio;
}

std::vector<CardData> data_of(const CalibrationJob& job) {
  std::vector<std::string> files = {job.file};
  for (const MeasuredShot& shot : job.shots) files.push_back(shot.file);
  for (const MeasuredCurve& curve : job.curves)
    for (const CurveSource& source : curve.data.sources) files.push_back(source.file);
  std::vector<CardData> data;
  std::set<std::string> seen;
  for (const std::string& file : files) {
    if (file.empty() || !seen.insert(file).second) continue;
    if (const auto digest = sha256_of_file(file))
      data.push_back({std::filesystem::path(file).filename().string(), *digest});
  }
  return data;
}

std::string error_of(const ReadingResult& result) {
  double sum = 0;
  int shots = 0;
  for (const ShotDepth& shot : result.shots) {
    if (!shot.fitted || !shot.deviation) continue;
    sum += std::abs(*shot.deviation);
    ++shots;
  }
  return shots == 0 ? "" : fmt::format("mean deviation {:.3g} % over the {} depths fitted", 100 * sum / shots, shots);
}

}  // namespace

std::vector<CardMaterial> calibration_cards(const CalibrationJob& job, const ReadingResult& result) {
  std::vector<CardMaterial> cards;
  if (result.minima.empty()) return cards;
  const CalibrationReading& reading = job.readings[result.reading];
  const auto natural = natural_of(job, result);
  const auto data = data_of(job);
  for (std::size_t m = 0; m < job.materials.size(); ++m) {
    const CalibrationMaterial& material = job.materials[m];
    const MaterialAt at = material_at(job, reading, static_cast<int>(m), natural);
    CardMaterial card{.name = job.readings.size() == 1 ? material.name : material.name + ", " + reading.name,
                      .density = at.density,
                      .terms = {{at.mu_true, at.alpha}},
                      .bulk_modulus = at.mu_true * bulk_ratio(job, static_cast<int>(m), at),
                      .erosion = CardErosion{at.erosion_strain, StrainMeasure::engineering},
                      .comments = {"calibrated by percal from " + job.title + ", reading '" + reading.name + "'"},
                      .intervals = intervals_of(job, result, material),
                      .fit_error = error_of(result),
                      .data = data};
    cards.push_back(std::move(card));
  }
  return cards;
}

}  // namespace percal
