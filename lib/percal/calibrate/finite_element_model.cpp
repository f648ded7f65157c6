#include <algorithm>
#include <cmath>

#include "percal/calibrate/job_model.hpp"
#include "percal/calibrate/shot_problem.hpp"
#include "percal/fit/relaxation/relaxing_curves.hpp"
#include "percal/material/homogeneous.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// d natural / d searched of a parameter.
double natural_slope(const FreeParameter& parameter, double natural) { return parameter.logarithmic ? natural : 1; }

// Where a material's numbers stand among the fitted parameters; -1: not fitted.
struct Places {
  int mu = -1, alpha = -1, erosion_strain = -1, erosion_length = -1, rate_exponent = -1, size_exponent = -1,
      strain_below = -1;
  std::vector<int> relaxation = {};  // shares of the terms, then times
};

struct Context {
  CalibrationJob job;  // a copy: the model outlives its maker
  Hypothesis hypothesis;
  JobModel layout;  // parameters and of_job only
  std::vector<Places> places;
  std::vector<std::vector<RelaxingRow>> histories;  // of each curve; empty where its material does not relax

  std::vector<double> natural(const VectorXd& searched) const {
    return natural_values(job, hypothesis, layout.of_job, searched);
  }

  // d(ln mu_true, alpha, erosion strain, ln erosion length, rate exponent, size exponent, erosion strain below a cell)/d searched of a material, 7 x parameters.
  MatrixXd derivative(int material, const MaterialAt& at) const {
    MatrixXd d = MatrixXd::Zero(7, static_cast<Eigen::Index>(layout.parameters.size()));
    const Places& p = places[material];
    if (p.mu >= 0) d(0, p.mu) = natural_slope(layout.parameters[p.mu], at.mu_as_given) / at.mu_as_given;
    if (p.alpha >= 0) {
      const double slope = natural_slope(layout.parameters[p.alpha], at.alpha);
      d(1, p.alpha) = slope;
      if (hypothesis.convention == ModulusConvention::mu_over_alpha) d(0, p.alpha) += slope / at.alpha;
    }
    if (p.erosion_strain >= 0)
      d(2, p.erosion_strain) = natural_slope(layout.parameters[p.erosion_strain], at.erosion_strain);
    if (p.erosion_length >= 0)
      d(3, p.erosion_length) =
          natural_slope(layout.parameters[p.erosion_length], *at.erosion_length) / *at.erosion_length;
    if (p.rate_exponent >= 0) d(4, p.rate_exponent) = 1;
    if (p.size_exponent >= 0) d(5, p.size_exponent) = 1;
    if (p.strain_below >= 0)
      d(6, p.strain_below) = natural_slope(layout.parameters[p.strain_below], at.laws.erosion_strain_below);
    return d;
  }

  // d(share of each term of relaxation, then ln of each time)/d searched.
  MatrixXd relaxation_derivative(int material) const {
    const std::vector<int>& where = places[material].relaxation;
    MatrixXd d =
        MatrixXd::Zero(static_cast<Eigen::Index>(where.size()), static_cast<Eigen::Index>(layout.parameters.size()));
    for (std::size_t k = 0; k < where.size(); ++k)  // shares are searched themselves, times by their logarithms
      if (where[k] >= 0) d(static_cast<Eigen::Index>(k), where[k]) = 1;
    return d;
  }
};

int place_of(const MaterialNumber& number, const std::vector<int>& of_job) {
  const auto* shared = std::get_if<SharedParameter>(&number);
  if (!shared) return -1;
  const auto found = std::find(of_job.begin(), of_job.end(), shared->index);
  return found == of_job.end() ? -1 : static_cast<int>(found - of_job.begin());
}

std::vector<EmulatorOf> emulators_for(std::span<const MeasuredShot> shots) {
  std::vector<EmulatorOf> wanted;
  for (const MeasuredShot& shot : shots) wanted.push_back(emulator_for(shot));
  return wanted;
}

ModelAnswer emulated_depths(const Context& context, const Emulators& emulators, double h, const VectorXd& searched,
                            std::span<const MeasuredShot> shots, Want want) {
  const auto natural = context.natural(searched);
  std::vector<SphereInputs> at;
  std::vector<MatrixXd> chain;  // sphere_inputs x parameters
  for (const MeasuredShot& shot : shots) {
    const CalibrationTarget& target = context.job.targets[shot.target];
    const ShotInputs inputs = shot_inputs(shot, target_at(context.job, context.hypothesis, target, natural));
    at.push_back(inputs.at);
    const auto by_parameters = [&](std::size_t layer, int material) {
      const MaterialAt there = material_at(context.job, context.hypothesis, material, natural);
      MatrixXd by = inputs.by_material[layer] * context.derivative(material, there);
      if (const auto& relaxation = inputs.log_mu_by_relaxation[layer]; relaxation.size() > 0)
        by += inputs.by_material[layer].col(0) * (relaxation * context.relaxation_derivative(material));
      return by;
    };
    chain.push_back(by_parameters(0, target.material));
    for (std::size_t k = 0; k < target.covers.size(); ++k)
      chain.back() += by_parameters(k + 1, target.covers[k].material);
  }
  const DepthAnswers depths = emulators.answers(at, emulators_for(shots), h, want == Want::values_and_covariance);
  ModelAnswer answer;
  answer.value = depths.log_depth;
  answer.jacobian.resize(depths.log_depth.size(), searched.size());
  for (std::size_t k = 0; k < shots.size(); ++k) {
    answer.value[k] += std::log(shots[k].radius);
    answer.jacobian.row(k) = depths.gradient.row(k) * chain[k];
  }
  answer.covariance = depths.covariance;
  return answer;
}

VectorXd emulated_speed_exponents(const Context& context, const Emulators& emulators, double h,
                                  const VectorXd& searched, std::span<const MeasuredShot> shots) {
  const auto natural = context.natural(searched);
  std::vector<SphereInputs> at;
  MatrixXd along(static_cast<Eigen::Index>(shots.size()), sphere_inputs);
  for (std::size_t k = 0; k < shots.size(); ++k) {
    const ShotInputs inputs = shot_inputs(
        shots[k], target_at(context.job, context.hypothesis, context.job.targets[shots[k].target], natural));
    at.push_back(inputs.at);
    along.row(k) = inputs.by_log_speed.transpose();
  }
  return emulators.answers(at, emulators_for(shots), h, false).gradient.cwiseProduct(along).rowwise().sum();
}

// d nominal stress / d (ln mu, alpha) by the derivative-carrying form of the law: two numbers, done by hand with a small struct.
struct StressSlopes {
  double stress, by_alpha;
};
StressSlopes stress_and_slope(const Ogden& solid, const PrincipalPair& pair) {
  const auto [log_i, log_j, factor] = pair;
  const double x = solid.alpha * (log_i - log_j) / 2, mean = (log_i + log_j) / 2;
  const double stress = nominal_stress(solid, pair);
  // d ln(exp(alpha mean) sinh(x)/x)/d alpha = mean + (coth x - 1/x) (log_i - log_j)/2
  const double langevin = std::abs(x) < 1e-3 ? x / 3 : 1 / std::tanh(x) - 1 / x;
  return {stress, stress * (mean + langevin * (log_i - log_j) / 2)};
}

// Of a curve: Pa, and with respect to everything that is searched.
struct StressesWithSlopes {
  VectorXd stress;
  MatrixXd slope;  // points x parameters
};

// Of a material that does not relax.
StressesWithSlopes elastic_stresses(const Context& context, const MeasuredCurve& curve, const MaterialAt& material) {
  const MatrixXd derivative = context.derivative(curve.material, material);
  const double rate = curve.rate.value_or(material.laws.reference_rate);
  const double log_rate = std::log(rate / material.laws.reference_rate);
  const Ogden solid{material.mu_true * rate_factor(material.laws, rate) / curve.rate_factor, material.alpha};
  const auto count = static_cast<Eigen::Index>(curve.data.points.size());
  StressesWithSlopes found{VectorXd(count), MatrixXd(count, derivative.cols())};
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto [stress, by_alpha] =
        stress_and_slope(solid, principal_pair(curve.data.points[static_cast<std::size_t>(k)].strained));
    found.stress[k] = stress;
    found.slope.row(k) = stress * (derivative.row(0) + log_rate * derivative.row(4)) + by_alpha * derivative.row(1);
  }
  return found;
}

// Of one that relaxes, along the curve's history.                                                 docs/theory/relaxation.md (5)
StressesWithSlopes relaxed_stresses(const Context& context, std::size_t index, const MaterialAt& material) {
  const MeasuredCurve& curve = context.job.curves[index];
  const PronySeries& series = material.laws.relaxation;
  std::vector<double> times;
  for (const PronyTerm& term : series.terms) times.push_back(term.time);
  const UnitHistory unit = unit_history(context.histories[index], material.alpha, times);
  const double mu = material.mu_true / curve.rate_factor, lasting = lasting_share(series);
  const Eigen::Index terms = unit.convolved.cols();
  VectorXd stress = mu * lasting * unit.elastic, by_alpha = mu * lasting * unit.elastic_by_alpha;
  MatrixXd by_relaxation(stress.size(), 2 * terms);
  for (Eigen::Index k = 0; k < terms; ++k) {
    const double share = series.terms[static_cast<std::size_t>(k)].share;
    stress += mu * share * unit.convolved.col(k);
    by_alpha += mu * share * unit.convolved_by_alpha.col(k);
    by_relaxation.col(k) = mu * (unit.convolved.col(k) - unit.elastic);
    by_relaxation.col(terms + k) = mu * share * unit.convolved_by_log_time.col(k);
  }
  const MatrixXd derivative = context.derivative(curve.material, material);
  return {stress, stress * derivative.row(0) + by_alpha * derivative.row(1) +
                      by_relaxation * context.relaxation_derivative(curve.material)};
}

ModelAnswer stresses(const Context& context, const VectorXd& searched, Want want) {
  const auto natural = context.natural(searched);
  Eigen::Index rows = 0;
  for (const auto& curve : context.job.curves) rows += static_cast<Eigen::Index>(curve.data.points.size());
  ModelAnswer answer;
  answer.value.resize(rows);
  answer.jacobian.resize(rows, searched.size());
  if (want == Want::values_and_covariance) answer.covariance = MatrixXd::Zero(rows, rows);
  Eigen::Index row = 0;
  bool any_common = false;
  for (std::size_t c = 0; c < context.job.curves.size(); ++c) {
    const MeasuredCurve& curve = context.job.curves[c];
    const MaterialAt material = material_at(context.job, context.hypothesis, curve.material, natural);
    const StressesWithSlopes found = context.histories[c].empty() ? elastic_stresses(context, curve, material)
                                                                  : relaxed_stresses(context, c, material);
    const auto scales = stress_scales(curve);
    const Eigen::Index first = row;
    for (std::size_t k = 0; k < scales.size(); ++k, ++row) {
      answer.value[row] = found.stress[static_cast<Eigen::Index>(k)] / scales[k];
      answer.jacobian.row(row) = found.slope.row(static_cast<Eigen::Index>(k)) / scales[k];
    }
    if (curve.rate_factor_error == 0 || want == Want::values) continue;
    any_common = true;
    const VectorXd moved = answer.value.segment(first, row - first) * curve.rate_factor_error;
    answer.covariance.block(first, first, row - first, row - first) = moved * moved.transpose();
  }
  if (!any_common) answer.covariance.resize(0, 0);
  return answer;
}

ModelAnswer nothing(const VectorXd& searched) {
  return {.value = VectorXd(0), .jacobian = MatrixXd(0, searched.size()), .covariance = MatrixXd(0, 0)};
}

}  // namespace

std::vector<double> stress_scales(const MeasuredCurve& curve) {
  double largest = 0;
  for (const auto& point : curve.data.points) largest = std::max(largest, std::abs(point.nominal_stress));
  std::vector<double> scales;
  for (const auto& point : curve.data.points)
    scales.push_back(std::max(std::abs(point.nominal_stress), smallest_stress_share * largest));
  return scales;
}

std::vector<Datum> curve_data(const CalibrationJob& job) {
  std::vector<Datum> data;
  for (const auto& curve : job.curves) {
    const auto scales = stress_scales(curve);
    for (std::size_t k = 0; k < curve.data.points.size(); ++k) {
      const StressPoint& point = curve.data.points[k];
      data.push_back({.label = curve.name,
                      .value = point.nominal_stress / scales[k],
                      .error = point.standard_error ? *point.standard_error / scales[k] : curve.relative_error,
                      .group = curve.group});
    }
  }
  return data;
}

JobModel finite_element_model(const CalibrationJob& job, const Hypothesis& hypothesis,
                              std::optional<Emulators> emulators, double h) {
  auto context = std::make_shared<Context>();
  context->job = job;
  context->hypothesis = hypothesis;
  for (std::size_t k = 0; k < job.parameters.size(); ++k) {
    if (hypothesis.held.contains(static_cast<int>(k))) continue;
    context->layout.parameters.push_back(job.parameters[k].free);
    context->layout.of_job.push_back(static_cast<int>(k));
  }
  for (const auto& material : job.materials)
    context->places.push_back(
        {place_of(material.mu, context->layout.of_job), place_of(material.alpha, context->layout.of_job),
         place_of(material.erosion_strain, context->layout.of_job),
         material.erosion_length ? place_of(*material.erosion_length, context->layout.of_job) : -1,
         place_of(material.rate_exponent, context->layout.of_job),
         place_of(material.size_exponent, context->layout.of_job),
         place_of(material.erosion_strain_below, context->layout.of_job)});
  for (std::size_t m = 0; m < job.materials.size(); ++m) {
    for (const auto& term : job.materials[m].relaxation)
      context->places[m].relaxation.push_back(place_of(term.share, context->layout.of_job));
    for (const auto& term : job.materials[m].relaxation)
      context->places[m].relaxation.push_back(place_of(term.time, context->layout.of_job));
  }
  for (const MeasuredCurve& curve : job.curves)
    context->histories.push_back(job.materials[static_cast<std::size_t>(curve.material)].relaxation.empty()
                                     ? std::vector<RelaxingRow>{}
                                     : relaxing_rows(curve.data, histories_of(curve.data)));
  JobModel model = context->layout;  // its functions are still empty
  if (emulators) {
    const auto own = std::make_shared<const Emulators>(std::move(*emulators));
    model.log_depths = [context, own, h](const VectorXd& searched, std::span<const MeasuredShot> shots, Want want) {
      return emulated_depths(*context, *own, h, searched, shots, want);
    };
    model.speed_exponents = [context, own, h](const VectorXd& searched, std::span<const MeasuredShot> shots) {
      return emulated_speed_exponents(*context, *own, h, searched, shots);
    };
  } else {
    model.log_depths = [](const VectorXd& searched, std::span<const MeasuredShot>, Want) { return nothing(searched); };
    model.speed_exponents = [](const VectorXd&, std::span<const MeasuredShot>) { return VectorXd(0); };
  }
  if (!job.curves.empty())
    model.stresses = [context](const VectorXd& searched, Want want) { return stresses(*context, searched, want); };
  return model;
}

}  // namespace percal
