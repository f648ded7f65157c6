#include "percal/fit/uncertainty_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace percal {
namespace {

using nlohmann::json;

json finite(double number) { return std::isfinite(number) ? json(number) : json(nullptr); }

json to_json(const Interval& interval) {
  return {{"low", finite(interval.low)},
          {"high", finite(interval.high)},
          {"low_open", interval.low_open},
          {"high_open", interval.high_open}};
}

std::string key(const ParameterUncertainty& parameter) {
  return parameter.unit.empty() ? parameter.name : parameter.name + "_" + parameter.unit;
}

json to_json(const ParameterUncertainty& parameter) {
  json result = to_json(parameter.interval);
  result["value"] = finite(parameter.value);
  result["identifiable"] = parameter.identifiable;
  result["bootstrap"] = nullptr;
  if (const auto& bootstrap = parameter.bootstrap)
    result["bootstrap"] = {{"points", to_json(bootstrap->points)},
                           {"residuals", to_json(bootstrap->residuals)},
                           {"parametric", to_json(bootstrap->parametric)}};
  return result;
}

json rows(const Eigen::MatrixXd& matrix) {
  json all = json::array();
  for (const auto& row : matrix.rowwise()) {
    json one = json::array();
    for (const double entry : row) one.push_back(finite(entry));
    all.push_back(one);
  }
  return all;
}

json to_json(const MinimumUncertainty& about) {
  json parameters = json::object(), order = json::array();
  for (const auto& parameter : about.parameters) {
    parameters[key(parameter)] = to_json(parameter);
    order.push_back(key(parameter));
  }
  return {{"minimum", about.minimum},
          {"parameters", parameters},
          {"order", order},
          {"correlation", rows(about.correlation)},
          {"small_strain_mu_Pa", about.small_strain_modulus ? to_json(*about.small_strain_modulus) : json(nullptr)},
          {"bootstrap_failed", about.bootstrap_failed}};
}

json to_json(const RateCurve& curve) {
  return {{"points", curve.points},
          {"errors", word(curve.errors)},
          {"scatter", finite(curve.scatter)},
          {"mu_alone_Pa", finite(curve.alone.mu)},
          {"alpha_alone", finite(curve.alone.alpha)}};
}

}  // namespace

json to_json(const Uncertainty& uncertainty) {
  json minima = json::array();
  for (const auto& about : uncertainty.minima) minima.push_back(to_json(about));
  const auto& neighbours = uncertainty.neighbour_correlation;
  return {{"level", uncertainty.options.level},
          {"errors", word(uncertainty.errors)},
          {"scatter", finite(uncertainty.scatter)},
          {"degrees_of_freedom", uncertainty.degrees_of_freedom},
          {"neighbour_correlation", neighbours ? finite(*neighbours) : json(nullptr)},
          {"bootstrap_replicates", uncertainty.options.bootstrap},
          {"seed", uncertainty.options.seed},
          {"minima", minima},
          {"findings", uncertainty.findings}};
}

json to_json(const RateFactor& rate) {
  return {{"level", rate.level},
          {"residual", word(rate.residual)},
          {"convention", "true"},
          {"rate_factor", to_json(rate.factor)},
          {"mu_slow_Pa", to_json(rate.mu_slow)},
          {"mu_fast_Pa", to_json(rate.mu_fast)},
          {"alpha", to_json(rate.alpha)},
          {"slow", to_json(rate.slow)},
          {"fast", to_json(rate.fast)},
          {"one_shape",
           {{"serves", rate.one_shape.serves},
            {"f", finite(rate.one_shape.f)},
            {"degrees_of_freedom", rate.one_shape.degrees_of_freedom},
            {"chance", finite(rate.one_shape.chance)}}},
          {"degrees_of_freedom", rate.degrees_of_freedom},
          {"converged", rate.converged},
          {"findings", rate.findings}};
}

}  // namespace percal
