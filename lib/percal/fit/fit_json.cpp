#include "percal/fit/fit_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace percal {
namespace {

using nlohmann::json;

json number_or_null(const std::optional<double>& number) {
  return number && std::isfinite(*number) ? json(*number) : json(nullptr);
}

json to_json(const OgdenMinimum& minimum) {
  return {{"mu_Pa", minimum.solid.mu},
          {"alpha", minimum.solid.alpha},
          {"objective", minimum.objective},
          {"objective_above_best", number_or_null(minimum.above_best)},
          {"r2", number_or_null(minimum.r2)},
          {"mu_standard_error_Pa", number_or_null(minimum.mu_standard_error)},
          {"alpha_standard_error", number_or_null(minimum.alpha_standard_error)},
          {"correlation", number_or_null(minimum.correlation)},
          {"converged", minimum.converged},
          {"at_bound", minimum.at_bound},
          {"iterations", minimum.iterations}};
}

}  // namespace

json to_json(const CurveData& data) {
  json sources = json::array();
  for (const auto& source : data.sources)
    sources.push_back({{"file", source.file},
                       {"x", source.x},
                       {"y", source.y},
                       {"stress", source.cauchy ? "cauchy" : "nominal"},
                       {"points", source.points}});
  return sources;
}

json to_json(const OgdenFit& fit, const CurveData& data) {
  json minima = json::array(), modes = json::object();
  for (const auto& minimum : fit.minima) minima.push_back(to_json(minimum));
  for (const auto& [deformation, points] : fit.points_of_mode) modes[word(deformation)] = points;
  return {{"minima", minima},
          {"residual", word(fit.residual)},
          {"objective_unit", fit.residual == Residual::absolute ? "Pa^2" : "1"},
          {"convention", "true"},
          {"points", fit.points},
          {"points_of_mode", modes},
          {"left_out_zero_stress", fit.left_out_zero_stress},
          {"sources", to_json(data)},
          {"search",
           {{"alpha_low", -largest_alpha},
            {"alpha_high", largest_alpha},
            {"scanned", fit.scanned},
            {"starts", fit.starts}}},
          {"findings", findings(fit)}};
}

}  // namespace percal
