// One hypothesis's result, and the closed form's.
#include "percal/calibrate/json_parts.hpp"

namespace percal::calibration_json {
namespace {

std::vector<FreeParameter> fitted_parameters(const CalibrationJob& job, const HypothesisResult& hypothesis) {
  std::vector<FreeParameter> parameters;
  for (const int k : hypothesis.parameters) parameters.push_back(job.parameters[k].free);
  return parameters;
}

Json held_of(const CalibrationJob& job, const Hypothesis& hypothesis) {
  Json all = Json::array();
  for (const auto& [k, value] : hypothesis.held)
    all.push_back({{"name", job.parameters[k].free.name}, {with_unit("value", job.parameters[k].free), value}});
  return all;
}

Json combinations_of(const std::vector<FreeParameter>& parameters, const std::vector<Combination>& combinations) {
  Json all = Json::array();
  for (const Combination& combination : combinations) {
    Json weights = Json::array();
    for (std::size_t k = 0; k < parameters.size(); ++k)
      weights.push_back(
          {{"name", parameters[k].name}, {"weight", number(combination.weight[static_cast<Eigen::Index>(k)])}});
    all.push_back({{"weights", weights},
                   {"standard_deviation", number(combination.standard_deviation)},
                   {"determined", combination.determined}});
  }
  return all;
}

// Rows and columns in the order of the parameters.
Json correlation_of(const HypothesisResult& hypothesis) {
  const Eigen::MatrixXd matrix = correlation(hypothesis.minima.front());
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) row.push_back(number(matrix(i, j)));
    rows.push_back(row);
  }
  return rows;
}

Json ridge_to_json(const std::vector<FreeParameter>& parameters, const RidgeMap& map) {
  const FreeParameter &first = parameters[map.first], &second = parameters[map.second];
  Json rise = Json::array(), contours = Json::array();
  for (Eigen::Index i = 0; i < map.rise.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < map.rise.cols(); ++j) row.push_back(number(map.rise(i, j)));
    rise.push_back(row);
  }
  for (const auto& line : map.contours) {
    std::vector<double> x, y;
    for (const auto& [at_x, at_y] : line) {
      x.push_back(at_x);
      y.push_back(at_y);
    }
    contours.push_back({{with_unit("x", first), numbers(x)}, {with_unit("y", second), numbers(y)}});
  }
  return {{"x_parameter", first.name},
          {"y_parameter", second.name},
          {with_unit("x", first), numbers(map.x)},
          {with_unit("y", second), numbers(map.y)},
          {"rise", rise},
          {"threshold", number(map.threshold)},
          {"contours", contours}};
}

Json ridges_to_json(const std::vector<FreeParameter>& parameters, const std::vector<RidgeMap>& maps) {
  Json all = Json::array();
  for (const RidgeMap& map : maps) all.push_back(ridge_to_json(parameters, map));
  return all;
}

Json deviations_to_json(const std::vector<Deviation>& deviations) {
  Json all = Json::array();
  for (const Deviation& deviation : deviations) all.push_back(deviation_to_json(deviation));
  return all;
}

Json curves_to_json(const CalibrationJob& job, const std::vector<CurveStresses>& curves) {
  Json all = Json::array();
  for (const CurveStresses& curve : curves)
    all.push_back({{"curve", curve.curve},
                   {"name", job.curves[curve.curve].name},
                   {"stress_Pa", numbers(curve.stress)},
                   {"low_Pa", numbers(curve.low)},
                   {"high_Pa", numbers(curve.high)}});
  return all;
}

Json fresh_to_json(const CalibrationJob& job, const std::vector<FreshRun>& runs) {
  Json all = Json::array();
  for (const FreshRun& run : runs)
    all.push_back({{"shot", run.shot},
                   {"label", job.shots[run.shot].label},
                   {"elements_per_radius", run.elements_per_radius},
                   {"outcome", run.outcome},
                   {"depth_m", number(run.depth)},
                   {"emulated_m", number(run.emulated)},
                   {"standardised_difference", run.depth ? number(run.standardised) : Json(nullptr)}});
  return all;
}

Json moduli_to_json(const std::vector<MaterialModuli>& moduli) {
  const auto maybe = [](const std::optional<Estimate>& estimate) {
    return estimate ? estimate_to_json(*estimate, "Pa") : Json(nullptr);
  };
  Json all = Json::array();
  for (const MaterialModuli& one : moduli)
    all.push_back({{"material", one.material},
                   {"mu_true", estimate_to_json(one.mu_true, "Pa")},
                   {"mu_over_alpha", estimate_to_json(one.mu_over_alpha, "Pa")},
                   {"youngs_quasi_static_true", maybe(one.youngs_quasi_static_true)},
                   {"youngs_quasi_static_over_alpha", maybe(one.youngs_quasi_static_over_alpha)},
                   {"curve_mu_true_Pa", number(one.curve_modulus)}});
  return all;
}

Json budgets_to_json(const std::vector<ErrorBudget>& budgets) {
  Json all = Json::array();
  for (const ErrorBudget& budget : budgets) {
    Json sources = Json::array();
    for (const ErrorShare& source : budget.sources)
      sources.push_back({{"name", source.name},
                         {"standard_deviation", number(source.standard_deviation)},
                         {"share", number(source.share)}});
    const bool known = !budget.most_influential.empty();
    all.push_back({{"quantity", budget.quantity},
                   {"total", estimate_to_json(budget.total, "Pa")},
                   {"standard_deviation", number(budget.standard_deviation)},
                   {"sources", sources},
                   {"most_influential", known ? Json(budget.most_influential) : Json(nullptr)},
                   {"influence", known ? number(budget.influence) : Json(nullptr)}});
  }
  return all;
}

Json advice_to_json(const std::vector<Advice>& advice) {
  Json all = Json::array();
  for (const Advice& one : advice)
    all.push_back({{"measurement", one.label}, {"interval_width_ratio", number(one.width_ratio)}});
  return all;
}

}  // namespace

Json hypothesis_to_json(const CalibrationJob& job, const HypothesisResult& result) {
  const Hypothesis& hypothesis = job.hypotheses[result.index];
  const auto parameters = fitted_parameters(job, result);
  Json minima = Json::array();
  for (const Minimum& minimum : result.minima) minima.push_back(minimum_to_json(job, parameters, minimum));
  Json json{{"name", hypothesis.name},
            {"convention", word(hypothesis.convention)},
            {"strain_measure", word(hypothesis.measure)},
            {"contact_stiffness", hypothesis.contact_stiffness},
            {"held", held_of(job, hypothesis)},
            {"minima", minima},
            {"parameters", nullptr},
            {"correlation", nullptr},
            {"bootstrap", nullptr},
            {"combinations", combinations_of(parameters, result.combinations)},
            {"ridges", ridges_to_json(parameters, result.ridges)},
            {"shots", shot_depths_to_json(job, result.shots)},
            {"curves", curves_to_json(job, result.curves)},
            {"sets", deviations_to_json(result.sets)},
            {"cross_validations", cross_validations_to_json(job, result.cross_validations)},
            {"leave_one_out", cross_validations_to_json(job, result.leave_one_out)},
            {"fresh_runs", fresh_to_json(job, result.fresh)},
            {"fresh_mean_deviation", result.fresh.empty() ? Json(nullptr) : number(result.fresh_deviation)},
            {"mesh_error", number(result.mesh_error)},
            {"moduli", moduli_to_json(result.moduli)},
            {"error_budgets", budgets_to_json(result.budgets)},
            {"advice", advice_to_json(result.advice)},
            {"findings", result.findings}};
  if (result.minima.empty()) return json;
  json["parameters"] = parameters_to_json(parameters, result.minima.front(), result.intervals, result.bootstrap);
  json["correlation"] = correlation_of(result);
  if (result.bootstrap)
    json["bootstrap"] = {{"replicates", result.bootstrap->searched.rows()}, {"failed", result.bootstrap->failed}};
  return json;
}

Json dehn_to_json(const CalibrationJob& job, const DehnResult& dehn) {
  return {{"minimum", minimum_to_json(job, dehn.parameters, dehn.minimum)},
          {"parameters", parameters_to_json(dehn.parameters, dehn.minimum, dehn.intervals, {})},
          {"shots", shot_depths_to_json(job, dehn.shots)},
          {"sets", deviations_to_json(dehn.sets)},
          {"cross_validations", cross_validations_to_json(job, dehn.cross_validations)},
          {"leave_one_out", cross_validations_to_json(job, dehn.leave_one_out)}};
}

}  // namespace percal::calibration_json
