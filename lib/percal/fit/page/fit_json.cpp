#include "percal/fit/page/fit_json.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>

#include "percal/card/card_json.hpp"
#include "percal/fit/interval/findings.hpp"
#include "percal/fit/interval/rulers.hpp"
#include "percal/fit/page/cards.hpp"
#include "percal/fit/shape/peaks.hpp"
#include "percal/material/plausible.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;

// What the peaks say of the strain at which an element goes: next to nothing, so that the error is wide.
Json erosion_prior(const std::vector<CurveSource>& sources) {
  const auto prior = prior_of_peaks(sources);
  if (!prior) return nullptr;
  return {{"strain", prior->strain}, {"measure", "engineering"}, {"error", prior->error}, {"curves", prior->curves}};
}

// --- the points -----------------------------------------------------------------------------------------------------

Json empty_list(const std::string& name, Deformation deformation) {
  return {{"name", name},
          {"deformation", word(deformation)},
          {"amount", Json::array()},
          {"across", Json::array()},
          {"stress_Pa", Json::array()},
          {"error_Pa", Json::array()}};
}

void add_point(Json& list, const StressPoint& point) {
  const bool biaxial = point.strained.deformation == Deformation::biaxial;
  list["amount"].push_back(point.strained.amount);
  list["across"].push_back(biaxial ? Json(point.strained.across) : Json(nullptr));
  list["stress_Pa"].push_back(point.nominal_stress);
  list["error_Pa"].push_back(finite(point.standard_error));
}

Json points_of_tests(const CurveData& data, const std::vector<CurveTest>& tests) {
  Json lists = Json::array();
  for (const CurveTest& test : tests) {
    lists.push_back(empty_list(test.name, test.deformation));
    for (const StressPoint& point : data.points)
      if (belongs(point, data, test)) add_point(lists.back(), point);
  }
  return lists;
}

// Of one curve, a list for each deformation in it.
void add_points_of_curve(Json& lists, const std::string& name, const CurveData& data) {
  std::map<Deformation, Json> of;
  for (const StressPoint& point : data.points) {
    const Deformation deformation = point.strained.deformation;
    add_point(of.try_emplace(deformation, empty_list(name, deformation)).first->second, point);
  }
  for (const auto& [deformation, list] : of) lists.push_back(list);
}

// --- minima and models ----------------------------------------------------------------------------------------------

Json terms_of(const CurveMinimum& minimum) {
  Json terms = Json::array();
  for (std::size_t k = 0; k < minimum.solid.terms.size(); ++k)
    terms.push_back({{"mu_Pa", minimum.solid.terms[k].mu},
                     {"alpha", minimum.solid.terms[k].alpha},
                     {"mu_standard_error_Pa", finite(minimum.errors[k].mu)},
                     {"alpha_standard_error", finite(minimum.errors[k].alpha)}});
  return terms;
}

// C10 belongs to alpha = 2 and C01 to alpha = -2.
Json mooney_constant(const CurveMinimum& minimum, const CurveFit& fit, double alpha) {
  if (fit.options.model != Model::mooney_rivlin) return nullptr;
  for (const auto& term : minimum.solid.terms)
    if (term.alpha == alpha) return term.mu / 2;
  return 0.0;
}

Json to_json(const CurveMinimum& minimum, const CurveFit& fit) {
  const bool single = minimum.solid.terms.size() == 1;
  const TermErrors errors = single ? minimum.errors[0] : TermErrors{};
  Json r2_of_test = Json::object();
  for (std::size_t i = 0; i < fit.tests.size(); ++i) r2_of_test[fit.tests[i].name] = finite(minimum.r2_of_test[i]);
  return {{"mu_Pa", small_strain_modulus(minimum.solid)},
          {"alpha", single ? Json(minimum.solid.terms[0].alpha) : Json(nullptr)},
          {"terms", terms_of(minimum)},
          {"C10_Pa", mooney_constant(minimum, fit, 2)},
          {"C01_Pa", mooney_constant(minimum, fit, -2)},
          {"objective", minimum.objective},
          {"objective_above_best", finite(minimum.above_best)},
          {"r2", finite(minimum.r2)},
          {"r2_of_test", r2_of_test},
          {"mu_standard_error_Pa", finite(errors.mu)},
          {"alpha_standard_error", finite(errors.alpha)},
          {"correlation", finite(minimum.correlation)},
          {"converged", minimum.converged},
          {"at_bound", minimum.at_bound},
          {"iterations", minimum.iterations}};
}

Json minima_of(const CurveFit& fit) {
  Json minima = Json::array();
  for (const auto& minimum : fit.minima) minima.push_back(to_json(minimum, fit));
  return minima;
}

Json tests_of(const CurveFit& fit) {
  Json tests = Json::array();
  for (const auto& test : fit.tests)
    tests.push_back({{"name", test.name},
                     {"file", test.file},
                     {"deformation", word(test.deformation)},
                     {"points", test.points},
                     {"weight_of_point", test.weight}});
  return tests;
}

Json stability_of(const CurveFit& fit, const StretchRange& searched) {
  if (fit.minima.empty()) return nullptr;
  const auto ranges = stable_ranges(fit.minima[0].solid, searched);
  Json of_mode = Json::object();
  for (const auto& range : ranges)
    of_mode[word(range.deformation)] = {{"low", range.low},
                                        {"high", range.high},
                                        {"low_is_searched_end", range.low_open},
                                        {"high_is_searched_end", range.high_open}};
  return {{"searched_low", searched.low},
          {"searched_high", searched.high},
          {"stable_throughout", stable_throughout(ranges)},
          {"stretches", of_mode},
          {"card_comment", stability_sentence(ranges, searched)}};
}

double lowest_aicc(const std::vector<ComparedModel>& models) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& model : models)
    if (model.fit && model.fit->aicc && model.not_ranked.empty()) lowest = std::min(lowest, *model.fit->aicc);
  return lowest;
}

Json left_out_of(const ComparedModel& model) {
  Json tests = Json::array();
  for (const auto& test : model.left_out)
    tests.push_back({{"name", test.name},
                     {"mean_relative_deviation", finite(test.mean_relative_deviation)},
                     {"relative_to_sum", finite(test.relative_to_sum)}});
  return tests;
}

Json to_json(const ComparedModel& model, double lowest, const StretchRange& stretches) {
  const CurveFit fit = model.fit.value_or(CurveFit{});
  const bool ranked = fit.aicc && model.not_ranked.empty();
  return {{"model", word(model.model)},
          {"parameters", parameters_of(model.model)},
          {"not_fitted", model.fit ? Json(nullptr) : Json(model.why_not)},
          {"minima", minima_of(fit)},
          {"aicc", finite(fit.aicc)},
          {"aicc_above_lowest", ranked ? finite(*fit.aicc - lowest) : Json(nullptr)},
          {"not_ranked", model.not_ranked.empty() ? Json(nullptr) : Json(model.not_ranked)},
          {"stability", stability_of(fit, stretches)},
          {"findings", model.fit ? findings(fit) : std::vector<std::string>{}},
          {"left_out", left_out_of(model)},
          {"left_out_mean_relative_deviation", finite(model.mean_relative_deviation)},
          {"left_out_relative_to_sum", finite(model.relative_to_sum)}};
}

// --- intervals ------------------------------------------------------------------------------------------------------

Json to_json(const Interval& interval) {
  return {{"low", finite(interval.low)},
          {"high", finite(interval.high)},
          {"low_open", interval.low_open},
          {"high_open", interval.high_open}};
}

Json rows_of(const Eigen::MatrixXd& matrix) {
  Json all = Json::array();
  for (const auto& row : matrix.rowwise()) {
    all.push_back(Json::array());
    for (const double entry : row) all.back().push_back(finite(entry));
  }
  return all;
}

Json to_json(const MinimumUncertainty& about) {
  Json parameters = Json::object(), order = Json::array();
  for (const auto& parameter : about.parameters) {
    const std::string key = parameter.unit.empty() ? parameter.name : parameter.name + "_" + parameter.unit;
    parameters[key] = parameter_to_json(parameter);
    order.push_back(key);
  }
  return {{"minimum", about.minimum},
          {"parameters", parameters},
          {"order", order},
          {"correlation", rows_of(about.correlation)},
          {"small_strain_mu_Pa", about.small_strain_modulus ? to_json(*about.small_strain_modulus) : Json(nullptr)},
          {"bootstrap_failed", about.bootstrap_failed}};
}

Json to_json(const Uncertainty& uncertainty) {
  Json minima = Json::array(), region = Json::object();
  for (const auto& [name, unit, pieces] : uncertainty.region)
    region[unit.empty() ? name : name + "_" + unit] = region_to_json(pieces);
  for (const auto& about : uncertainty.minima) minima.push_back(to_json(about));
  return {{"level", uncertainty.options.level},
          {"errors", word(uncertainty.errors)},
          {"scatter", finite(uncertainty.scatter)},
          {"degrees_of_freedom", uncertainty.degrees_of_freedom},
          {"neighbour_correlation", finite(uncertainty.neighbour_correlation)},
          {"bootstrap_replicates", uncertainty.options.bootstrap},
          {"minima", minima},
          {"region", region}};
}

Json to_json(const RateCurve& curve) {
  return {{"points", curve.points},
          {"errors", word(curve.errors)},
          {"scatter", finite(curve.scatter)},
          {"mu_alone_Pa", finite(curve.alone.mu)},
          {"alpha_alone", finite(curve.alone.alpha)}};
}

void add_warnings(Json& result, const std::vector<std::string>& sentences) {
  for (const auto& sentence : sentences) result["warnings"].push_back(sentence);
}

}  // namespace

Json parameter_to_json(const ParameterUncertainty& parameter) {
  Json result = to_json(parameter.interval);
  result["value"] = finite(parameter.value);
  result["identifiable"] = parameter.identifiable;
  result["bootstrap"] = nullptr;
  if (const auto& bootstrap = parameter.bootstrap)
    result["bootstrap"] = {{"points", to_json(bootstrap->points)},
                           {"residuals", to_json(bootstrap->residuals)},
                           {"parametric", to_json(bootstrap->parametric)}};
  return result;
}

Json region_to_json(const Region& region) {
  Json pieces = Json::array();
  for (const Interval& piece : region) pieces.push_back({finite(piece.low), finite(piece.high)});
  return pieces;
}

Json fit_to_json(const FitRequest& request, const FinishedFit& found, const page::Cost& cost) {
  const auto& [data, fit, uncertainty, comparison, relaxation] = found;
  const CurveOptions& options = fit.options;
  Json modes = Json::object(), models = nullptr;
  for (const auto& [deformation, points] : fit.points_of_mode) modes[word(deformation)] = points;
  if (comparison) models = Json::array();
  for (const ComparedModel& model : comparison.value_or(std::vector<ComparedModel>{}))
    models.push_back(to_json(model, lowest_aicc(*comparison), request.stretches));
  const bool relaxes = relaxation && relaxation->terms > 0;  // the fit that knows no time is then beside the point
  std::vector<std::string> sentences = relaxes ? std::vector<std::string>{} : findings(fit);
  if (relaxation) sentences.insert(sentences.end(), relaxation->findings.begin(), relaxation->findings.end());
  if (uncertainty) sentences.insert(sentences.end(), uncertainty->findings.begin(), uncertainty->findings.end());
  Json result = read_to_json(request, data.sources);
  result.update({{"model", word(options.model)},
                 {"minima", minima_of(fit)},
                 {"residual", word(options.residual)},
                 {"objective_unit", options.residual == Residual::absolute ? "Pa^2" : "1"},
                 {"loss", word(options.loss)},
                 {"loss_scale", finite(fit.loss_scale)},
                 {"signs", options.signs == Signs::free ? "free" : "positive"},
                 {"convention", "true"},
                 {"aicc", finite(fit.aicc)},
                 {"points", fit.points},
                 {"points_of_mode", modes},
                 {"tests", tests_of(fit)},
                 {"left_out_zero_stress", fit.left_out_zero_stress},
                 {"left_out_no_error", fit.left_out_no_error},
                 {"search",
                  {{"alpha_low", -largest_alpha},
                   {"alpha_high", largest_alpha},
                   {"scanned", fit.scanned},
                   {"starts", fit.starts}}},
                 {"stability", stability_of(fit, request.stretches)},
                 {"uncertainty", uncertainty ? to_json(*uncertainty) : Json(nullptr)},
                 {"comparison", models},
                 {"relaxation", relaxation ? relaxation_to_json(data, *relaxation) : Json(nullptr)},
                 {"cards", relaxes ? Json::array()
                                   : cards_to_json(fit_cards(data, fit, uncertainty.value_or(Uncertainty{}),
                                                             request.columns.where))},
                 {"rate_factor", nullptr},
                 {"erosion_prior", erosion_prior(data.sources)},
                 {"data", points_of_tests(data, fit.tests)},
                 {"findings", sentences},
                 {"seed", uncertainty ? Json(uncertainty->options.seed) : Json(nullptr)},
                 {"cost", page::cost_to_json(cost)}});
  if (relaxes) {
    add_warnings(result, implausible_modulus(small_strain_modulus(relaxation->minima[0].solid.instantaneous)));
    return result;
  }
  add_warnings(result, rulers(data, fit));
  if (!fit.minima.empty()) add_warnings(result, implausible_modulus(small_strain_modulus(fit.minima[0].solid)));
  return result;
}

Json rate_factor_to_json(const FitRequest& request, const RatePair& pair, const RateFactor& found,
                         const page::Cost& cost) {
  Json data = Json::array();
  add_points_of_curve(data, "low rate", pair.slow);
  add_points_of_curve(data, "high rate", pair.fast);
  Json result = read_to_json(request, {pair.slow.sources.at(0), pair.fast.sources.at(0)});
  result.update({{"level", found.level},
                 {"residual", word(found.residual)},
                 {"convention", "true"},
                 {"rate_factor", parameter_to_json(found.factor)},
                 {"mu_slow_Pa", parameter_to_json(found.mu_slow)},
                 {"mu_fast_Pa", parameter_to_json(found.mu_fast)},
                 {"alpha", parameter_to_json(found.alpha)},
                 {"slow", to_json(found.slow)},
                 {"fast", to_json(found.fast)},
                 {"one_shape",
                  {{"serves", found.one_shape.serves},
                   {"f", finite(found.one_shape.f)},
                   {"degrees_of_freedom", found.one_shape.degrees_of_freedom},
                   {"chance", finite(found.one_shape.chance)}}},
                 {"degrees_of_freedom", found.degrees_of_freedom},
                 {"converged", found.converged},
                 {"data", data},
                 {"findings", found.findings},
                 {"cost", page::cost_to_json(cost)}});
  add_warnings(result, implausible_modulus(found.mu_slow.value));
  return result;
}

page::Cost Stopwatch::cost() const {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - wall;
  return {.cpu_seconds = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC,
          .wall_seconds = passed.count()};
}

}  // namespace percal
