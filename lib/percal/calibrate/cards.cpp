#include "percal/calibrate/cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/calibrate/shot_problem.hpp"
#include "percal/fit/page/cards.hpp"
#include "percal/scene/solver_words.hpp"
#include "percal/units/quantity.hpp"

namespace percal {
namespace {

// The interval of a material's number that was fitted.
void add_fitted(const HypothesisResult& result, const MaterialNumber& number, const std::string& name,
                CardIntervals& intervals) {
  const auto* shared = std::get_if<SharedParameter>(&number);
  if (!shared) return;
  for (const ProfileInterval& interval : result.intervals)
    if (result.parameters[interval.parameter] == shared->index)
      intervals.of.push_back(card_interval(name, interval.interval));
}

CardIntervals intervals_of(const CalibrationJob& job, const HypothesisResult& result,
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
  double ratio = least_bulk_ratio;
  for (const MeasuredShot& shot : job.shots)
    if (meets(job, shot, material)) ratio = std::max(ratio, std::exp(shot_inputs(shot, at).at.log_bulk_ratio));
  return ratio;
}

// On the mesh of the runs behind the answer. Its size in metres is one only where the shots have one radius, or erosion a length.
CardErosion erosion_of(const CalibrationJob& job, int material, const MaterialAt& at) {
  const double over_radius = 1 / job.training.verify;
  if (at.erosion_length)
    return {at.erosion_strain, StrainMeasure::engineering, std::nullopt, over_radius * *at.erosion_length};
  std::optional<double> element;
  bool one_radius = true;
  for (const MeasuredShot& shot : job.shots) {
    if (!meets(job, shot, material)) continue;
    const double size = shot.radius / mesh_of(shot, at, job.training.verify);
    one_radius = one_radius && (!element || *element == size);
    element = size;
  }
  return {at.erosion_strain, StrainMeasure::engineering, over_radius, one_radius ? element : std::nullopt};
}

// What a card of another program cannot say.
std::vector<std::string> comments_of(const CalibrationJob& job, const Hypothesis& hypothesis, int material,
                                     const MaterialAt& at) {
  std::vector<std::string> comments{"calibrated by percal from " + job.title + ", hypothesis '" + hypothesis.name +
                                    "'"};
  if (std::ranges::any_of(job.shots, [&](const MeasuredShot& shot) { return meets(job, shot, material); }))
    comments.push_back("its runs had " + in_words(job.solver));
  if (at.erosion_length)
    comments.push_back(
        fmt::format("erosion was judged by the energy of a tension test to this strain, averaged over {}: "
                    "where each element is judged by itself, another strain is wanted",
                    format_quantity(*at.erosion_length, dimension::length)));
  if (at.laws.rate_exponent != 0)
    comments.push_back(fmt::format("mu is that at {:.3g} 1/s; it was calibrated to go as the rate to the power {:.3g}",
                                   at.laws.reference_rate, at.laws.rate_exponent));
  if (!at.laws.relaxation.terms.empty())
    comments.push_back(
        fmt::format("mu is the instantaneous modulus of a solid that relaxes to {}, which a card does not say",
                    format_quantity(at.mu_true * lasting_share(at.laws.relaxation), dimension::pressure)));
  if (at.laws.cell > 0)
    comments.push_back(fmt::format("the erosion strain is that for particles larger than {}; smaller ones have {:.4g}",
                                   format_quantity(at.laws.cell, dimension::length), at.laws.erosion_strain_below));
  if (at.laws.size_exponent != 0)
    comments.push_back(
        fmt::format("the erosion strain is that for spheres of radius {}; it was calibrated to go as the radius to the "
                    "power {:.3g}",
                    format_quantity(at.laws.reference_radius, dimension::length), at.laws.size_exponent));
  return comments;
}

std::vector<CardData> data_of(const CalibrationJob& job) {
  std::vector<std::string> files = {job.file};
  for (const MeasuredShot& shot : job.shots) files.push_back(shot.file);
  for (const MeasuredCurve& curve : job.curves)
    for (const CurveSource& source : curve.data.sources) files.push_back(source.file);
  return card_data(files);
}

std::string error_of(const HypothesisResult& result) {
  double sum = 0;
  int shots = 0;
  for (const ShotDepth& shot : result.shots) {
    if (!shot.fitted || !shot.deviation) continue;
    sum += std::abs(*shot.deviation);
    ++shots;
  }
  return shots == 0 ? "" : fmt::format("mean deviation {:.3g} % over the {} depths fitted", 100 * sum / shots, shots);
}

std::string contradiction_of(const Verdict& verdict) {
  return verdict.agreement == DataAgreement::disagrees ? fmt::format("{}", fmt::join(verdict.sentences, " ")) : "";
}

}  // namespace

std::vector<CardMaterial> calibration_cards(const CalibrationJob& job, const HypothesisResult& result) {
  std::vector<CardMaterial> cards;
  if (result.minima.empty()) return cards;
  const Hypothesis& hypothesis = job.hypotheses[result.index];
  const auto natural = natural_values(job, hypothesis, result.parameters, result.minima.front().searched);
  const auto data = data_of(job);
  for (std::size_t m = 0; m < job.materials.size(); ++m) {
    const CalibrationMaterial& material = job.materials[m];
    const MaterialAt at = material_at(job, hypothesis, static_cast<int>(m), natural);
    CardMaterial card{.name = job.hypotheses.size() == 1 ? material.name : material.name + ", " + hypothesis.name,
                      .density = at.density,
                      .terms = {{at.mu_true, at.alpha}},
                      .bulk_modulus = at.mu_true * bulk_ratio(job, static_cast<int>(m), at),
                      .erosion = erosion_of(job, static_cast<int>(m), at),
                      .comments = comments_of(job, hypothesis, static_cast<int>(m), at),
                      .intervals = intervals_of(job, result, material),
                      .fit_error = error_of(result),
                      .contradiction = contradiction_of(result.verdict),
                      .data = data};
    cards.push_back(std::move(card));
  }
  return cards;
}

}  // namespace percal
