#include "percal/fit/fit_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "percal/text/sha256.hpp"

namespace percal {
namespace {

using nlohmann::json;

json number_or_null(const std::optional<double>& number) {
  return number && std::isfinite(*number) ? json(*number) : json(nullptr);
}

json terms_of(const CurveMinimum& minimum) {
  json terms = json::array();
  for (std::size_t k = 0; k < minimum.solid.terms.size(); ++k)
    terms.push_back({{"mu_Pa", minimum.solid.terms[k].mu},
                     {"alpha", minimum.solid.terms[k].alpha},
                     {"mu_standard_error_Pa", number_or_null(minimum.errors[k].mu)},
                     {"alpha_standard_error", number_or_null(minimum.errors[k].alpha)}});
  return terms;
}

// C10 belongs to alpha = 2 and C01 to alpha = -2.
double mooney_constant(const CurveMinimum& minimum, double alpha) {
  for (const auto& term : minimum.solid.terms)
    if (term.alpha == alpha) return term.mu / 2;
  return 0;
}

json to_json(const CurveMinimum& minimum, const CurveFit& fit) {
  const bool single = minimum.solid.terms.size() == 1;
  const TermErrors errors = single ? minimum.errors[0] : TermErrors{};
  json r2_of_test = json::object();
  for (std::size_t i = 0; i < fit.tests.size(); ++i)
    r2_of_test[fit.tests[i].name] = number_or_null(minimum.r2_of_test[i]);
  json result = {{"mu_Pa", small_strain_modulus(minimum.solid)},
                 {"alpha", single ? json(minimum.solid.terms[0].alpha) : json(nullptr)},
                 {"terms", terms_of(minimum)},
                 {"objective", minimum.objective},
                 {"objective_above_best", number_or_null(minimum.above_best)},
                 {"r2", number_or_null(minimum.r2)},
                 {"r2_of_test", r2_of_test},
                 {"mu_standard_error_Pa", number_or_null(errors.mu)},
                 {"alpha_standard_error", number_or_null(errors.alpha)},
                 {"correlation", number_or_null(minimum.correlation)},
                 {"converged", minimum.converged},
                 {"at_bound", minimum.at_bound},
                 {"iterations", minimum.iterations}};
  if (fit.options.model == Model::mooney_rivlin) {
    result["C10_Pa"] = mooney_constant(minimum, 2);
    result["C01_Pa"] = mooney_constant(minimum, -2);
  }
  return result;
}

json stability_of(const CurveFit& fit, const StretchRange& searched) {
  if (fit.minima.empty()) return nullptr;
  const auto ranges = stable_ranges(fit.minima[0].solid, searched);
  json of_mode = json::object();
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

json tests_of(const CurveFit& fit) {
  json tests = json::array();
  for (const auto& test : fit.tests)
    tests.push_back({{"name", test.name},
                     {"file", test.file},
                     {"deformation", word(test.deformation)},
                     {"points", test.points},
                     {"weight_of_point", test.weight}});
  return tests;
}

json minima_of(const CurveFit& fit) {
  json minima = json::array();
  for (const auto& minimum : fit.minima) minima.push_back(to_json(minimum, fit));
  return minima;
}

std::optional<double> lowest_aicc(const std::vector<ComparedModel>& models) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& model : models)
    if (model.fit && model.fit->aicc) lowest = std::min(lowest, *model.fit->aicc);
  return std::isfinite(lowest) ? std::optional(lowest) : std::nullopt;
}

json left_out_of(const ComparedModel& model) {
  json tests = json::array();
  for (const auto& test : model.left_out)
    tests.push_back({{"name", test.name},
                     {"mean_relative_deviation", number_or_null(test.mean_relative_deviation)},
                     {"relative_to_sum", number_or_null(test.relative_to_sum)}});
  return tests;
}

}  // namespace

json to_json(const CurveData& data) {
  json sources = json::array();
  for (const auto& source : data.sources) {
    const auto digest = sha256_of_file(source.file);
    sources.push_back({{"file", source.file},
                       {"sha256", digest ? json(*digest) : json(nullptr)},
                       {"x", source.x},
                       {"y", source.y},
                       {"error", source.error.empty() ? json(nullptr) : json(source.error)},
                       {"stress", source.cauchy ? "cauchy" : "nominal"},
                       {"points", source.points}});
  }
  return sources;
}

json to_json(const CurveFit& fit, const CurveData& data, const StretchRange& stretches) {
  json modes = json::object();
  for (const auto& [deformation, points] : fit.points_of_mode) modes[word(deformation)] = points;
  const CurveOptions& options = fit.options;
  return {{"model", word(options.model)},
          {"minima", minima_of(fit)},
          {"residual", word(options.residual)},
          {"objective_unit", options.residual == Residual::absolute ? "Pa^2" : "1"},
          {"loss", word(options.loss)},
          {"loss_scale", number_or_null(fit.loss_scale)},
          {"signs", options.signs == Signs::free ? "free" : "positive"},
          {"convention", "true"},
          {"aicc", number_or_null(fit.aicc)},
          {"points", fit.points},
          {"points_of_mode", modes},
          {"tests", tests_of(fit)},
          {"left_out_zero_stress", fit.left_out_zero_stress},
          {"left_out_no_error", fit.left_out_no_error},
          {"sources", to_json(data)},
          {"search",
           {{"alpha_low", -largest_alpha},
            {"alpha_high", largest_alpha},
            {"scanned", fit.scanned},
            {"starts", fit.starts}}},
          {"stability", stability_of(fit, stretches)},
          {"findings", findings(fit)}};
}

json to_json(const std::vector<ComparedModel>& models, const StretchRange& stretches) {
  const auto lowest = lowest_aicc(models);
  json all = json::array();
  for (const auto& model : models) {
    json one = {{"model", word(model.model)},
                {"parameters", parameters_of(model.model)},
                {"not_fitted", model.fit ? json(nullptr) : json(model.why_not)},
                {"left_out", left_out_of(model)},
                {"left_out_mean_relative_deviation", number_or_null(model.mean_relative_deviation)},
                {"left_out_relative_to_sum", number_or_null(model.relative_to_sum)}};
    if (model.fit) {
      one["minima"] = minima_of(*model.fit);
      one["aicc"] = number_or_null(model.fit->aicc);
      one["aicc_above_lowest"] = model.fit->aicc && lowest ? json(*model.fit->aicc - *lowest) : json(nullptr);
      one["stability"] = stability_of(*model.fit, stretches);
      one["findings"] = findings(*model.fit);
    }
    all.push_back(one);
  }
  return all;
}

}  // namespace percal
