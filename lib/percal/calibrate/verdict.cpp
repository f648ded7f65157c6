#include "percal/calibrate/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/calibrate/error_budget.hpp"
#include "percal/calibrate/shot_problem.hpp"
#include "percal/math/distributions.hpp"
#include "percal/page/numbers.hpp"

namespace percal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double widest_rate_factor = 1e4;  // searched from its inverse up

bool has_curves(const CalibrationJob& job, int material) {
  return std::ranges::any_of(job.curves, [material](const MeasuredCurve& curve) { return curve.material == material; });
}

bool has_fitted_depths(const CalibrationJob& job, const JobFit& fit, int material) {
  return std::ranges::any_of(fit.shots, [&](int i) { return meets(job, job.shots[i], material); });
}

// The number that the job's parameters have beside them while a rate factor is free.
SharedParameter free_rate_factor(const CalibrationJob& job) { return {static_cast<int>(job.parameters.size())}; }

// The model with one more parameter, the factor by which a material's curves are softer than the job says. What the job knows of their
// rate factor is left out.
JobModel with_free_rate_factor(const CalibrationJob& job, const JobModel& model, int material) {
  JobModel freed = model;
  freed.parameters.push_back(
      {.name = "rate factor", .unit = "", .low = 1 / widest_rate_factor, .high = widest_rate_factor});
  freed.of_job.push_back(free_rate_factor(job).index);
  const Index own = static_cast<Index>(model.parameters.size());
  freed.log_depths = [model, own](const VectorXd& searched, std::span<const MeasuredShot> shots, Want want) {
    ModelAnswer answer = model.log_depths(searched.head(own), shots, want);
    answer.jacobian.conservativeResize(Eigen::NoChange, own + 1);
    answer.jacobian.col(own).setZero();
    return answer;
  };
  freed.speed_exponents = [model, own](const VectorXd& searched, std::span<const MeasuredShot> shots) {
    return model.speed_exponents(searched.head(own), shots);
  };
  std::vector<std::pair<Index, Index>> rows;  // first and count, of the material's curves
  Index first = 0;
  for (const MeasuredCurve& curve : job.curves) {
    const auto count = static_cast<Index>(curve.data.points.size());
    if (curve.material == material) rows.emplace_back(first, count);
    first += count;
  }
  freed.stresses = [model, own, rows](const VectorXd& searched, Want want) {
    ModelAnswer answer = model.stresses(searched.head(own), want);
    answer.jacobian.conservativeResize(Eigen::NoChange, own + 1);
    answer.jacobian.col(own).setZero();
    for (const auto& [start, count] : rows) {
      answer.value.segment(start, count) *= std::exp(-searched[own]);
      answer.jacobian.middleRows(start, count) *= std::exp(-searched[own]);
      answer.jacobian.col(own).segment(start, count) = -answer.value.segment(start, count);
      if (answer.covariance.size() > 0) answer.covariance.block(start, start, count, count).setZero();
    }
    return answer;
  };
  return freed;
}

// Whether the job's factor, with its own error, reaches into an interval of that level.
bool reaches(const ImpliedRateFactor& rate, const Interval& implied, double level) {
  const double reach = std::exp(normal_quantile(0.5 + level / 2) * rate.given_error);
  return rate.given * reach >= implied.low && rate.given / reach <= implied.high;
}

bool is_vague(const Interval& implied) {
  return implied.low_open || implied.high_open || implied.high > hopeless_factor * implied.low;
}

ImpliedRateFactor rate_factor(const CalibrationJob& job, int hypothesis, const JobModel& model, const JobFit& fit,
                              int material) {
  const auto curve = std::ranges::find_if(job.curves, [=](const auto& one) { return one.material == material; });
  ImpliedRateFactor rate{.material = material, .given = curve->rate_factor, .given_error = curve->rate_factor_error};
  const JobModel freed = with_free_rate_factor(job, model, material);
  const auto factor = static_cast<int>(model.parameters.size());
  const JobFit joined = fit_job(job, freed, fit.shots, quick_search());
  const auto intervals_at = [&](double level) {
    return region_intervals(joined.problem, joined.minima, level, quick_search());
  };
  const auto implied = [&](const std::vector<ProfileInterval>& intervals) {
    Interval interval = interval_of(freed, joined, free_rate_factor(job), intervals).value();
    interval.low *= rate.given;
    interval.high *= rate.given;
    return interval;
  };
  const auto intervals = intervals_at(job.level);
  rate.implied = {rate.given * std::exp(joined.at[factor]), implied(intervals)};
  const auto natural = natural_values(job, job.hypotheses[hypothesis], model.of_job, joined.at.head(factor));
  const double mu = material_at(job, job.hypotheses[hypothesis], material, natural).mu_as_given;
  rate.modulus_of_depths = {
      mu, interval_of(freed, joined, job.materials[material].mu, intervals).value_or(Interval{mu, mu})};
  rate.modulus_of_curves = mu / rate.implied.value;
  if (reaches(rate, rate.implied.interval, job.level))
    rate.agreement = is_vague(rate.implied.interval) ? DataAgreement::cannot_tell : DataAgreement::agrees;
  else if (!reaches(rate, implied(intervals_at(level_of_contradiction)), level_of_contradiction))
    rate.agreement = DataAgreement::disagrees;
  return rate;
}

std::string between(const Interval& interval, const std::string& low, const std::string& high) {
  if (low == high) return low;
  return fmt::format("{}{} to {}{}", low, interval.low_open ? " or less" : "", high,
                     interval.high_open ? " or more" : "");
}

std::string pressures(const Interval& interval) {
  return between(interval, page::pressure(interval.low, 3), page::pressure(interval.high, 3));
}

std::string factors(const Interval& interval) {
  return between(interval, page::shown(interval.low, 2), page::shown(interval.high, 2));
}

std::string in_words(const CalibrationJob& job, const ImpliedRateFactor& rate) {
  const std::string& material = job.materials[rate.material].name;
  const std::string given = page::shown(rate.given, 3), implied = factors(rate.implied.interval);
  if (rate.agreement == DataAgreement::disagrees)
    return fmt::format(
        "{}: the depths alone want a mu of {}, the curve {}. A rate factor of {} would join them; the job has {}.",
        material, pressures(rate.modulus_of_depths.interval), page::pressure(rate.modulus_of_curves, 3), implied,
        given);
  if (rate.agreement == DataAgreement::cannot_tell && !reaches(rate, rate.implied.interval, job.level))
    return fmt::format(
        "{}: depths and curve hardly agree: the depths alone want a mu of {}, the curve {}, and a rate factor of {} "
        "would join "
        "them where the job has {}. That is doubt, no proof: {} intervals miss so far now and then.",
        material, pressures(rate.modulus_of_depths.interval), page::pressure(rate.modulus_of_curves, 3), implied, given,
        page::percent(job.level));
  if (rate.agreement == DataAgreement::cannot_tell)
    return fmt::format("{}: any rate factor of {} would join depths and curve, so they cannot tell the job's {}.",
                       material, implied, given);
  return fmt::format("{}: depths and curve agree; a free rate factor would be {} ({}), the job has {}.", material,
                     page::shown(rate.implied.value, 2), implied, given);
}

// Returns whether there is such a group.
bool add_impossible_scatter(const CalibrationJob& job, const JobFit& fit, std::vector<std::string>& sentences) {
  bool any = false;
  for (std::size_t g = 0; g < job.groups.size(); ++g) {
    if (!job.groups[g].estimated || !(fit.best().scatter[g] > most_scatter)) continue;
    sentences.push_back(fmt::format("\"{}\" would have to scatter by {} about the model: it does not describe them.",
                                    job.groups[g].name, page::rough_percent(fit.best().scatter[g])));
    any = true;
  }
  return any;
}

void add_what_is_at_a_bound(const JobFit& fit, std::vector<std::string>& sentences) {
  for (std::size_t k = 0; k < fit.problem.parameters.size(); ++k) {
    if (!fit.best().at_bound[k]) continue;
    const FreeParameter& parameter = fit.problem.parameters[k];
    const double value = parameter.natural(fit.best().searched[static_cast<Index>(k)]);
    const bool low = std::abs(value - parameter.low) < std::abs(value - parameter.high);
    sentences.push_back(fmt::format("{} is at the {} bound of its search: the data want it {}.", parameter.name,
                                    low ? "lower" : "upper", low ? "lower" : "higher"));
  }
}

void add_impossible_erosion(const CalibrationJob& job, int hypothesis, const JobModel& model, const JobFit& fit,
                            std::vector<std::string>& sentences) {
  const auto natural = natural_values(job, job.hypotheses[hypothesis], model.of_job, fit.at);
  for (std::size_t m = 0; m < job.materials.size(); ++m) {
    const double strain = material_at(job, job.hypotheses[hypothesis], static_cast<int>(m), natural).erosion_strain;
    if (strain > most_erosion_strain && has_fitted_depths(job, fit, static_cast<int>(m)))
      sentences.push_back(
          fmt::format("{}: an erosion strain of {} is a stretch of {}, which no such material survives.",
                      job.materials[m].name, page::shown(strain, 3), page::shown(1 + strain, 3)));
  }
}

}  // namespace

Verdict verdict_of(const CalibrationJob& job, int hypothesis, const JobModel& model, const JobFit& fit) {
  Verdict verdict;
  for (int m = 0; m < static_cast<int>(job.materials.size()); ++m)
    if (has_curves(job, m) && has_fitted_depths(job, fit, m))
      verdict.rate_factors.push_back(rate_factor(job, hypothesis, model, fit, m));
  if (verdict.rate_factors.empty())
    verdict.sentences.push_back(
        "Cannot tell: no material has both a curve and fitted depths, so that nothing can be contradicted.");
  else
    verdict.agreement = DataAgreement::agrees;
  for (const ImpliedRateFactor& rate : verdict.rate_factors) {
    verdict.agreement = std::max(verdict.agreement, rate.agreement);
    verdict.sentences.push_back(in_words(job, rate));
  }
  if (add_impossible_scatter(job, fit, verdict.sentences)) verdict.agreement = DataAgreement::disagrees;
  add_what_is_at_a_bound(fit, verdict.sentences);
  add_impossible_erosion(job, hypothesis, model, fit, verdict.sentences);
  return verdict;
}

DataAgreement least_contradicted(const std::vector<HypothesisResult>& hypotheses) {
  DataAgreement least = hypotheses.empty() ? DataAgreement::cannot_tell : DataAgreement::disagrees;
  for (const HypothesisResult& hypothesis : hypotheses) least = std::min(least, hypothesis.verdict.agreement);
  return least;
}

}  // namespace percal
