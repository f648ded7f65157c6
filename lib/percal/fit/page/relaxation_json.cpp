// What a fit of relaxation found, and the scene's lines that it comes to.                        docs/formats/fit.md
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "percal/fit/page/fit_json.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;

constexpr double smallest_alpha_of_a_scene = 1e-3;

Json json_of(const PronySeries& series) {
  Json terms = Json::array();
  for (const PronyTerm& term : series.terms) terms.push_back({{"share", term.share}, {"time_s", term.time}});
  return terms;
}

Json json_of(const RelaxingSolid& solid) {
  const double modulus = small_strain_modulus(solid.instantaneous);
  Json terms = Json::array();
  for (const Ogden& term : solid.instantaneous.terms) terms.push_back({{"mu_Pa", term.mu}, {"alpha", term.alpha}});
  return {{"mu_0_Pa", modulus},
          {"mu_inf_Pa", modulus * lasting_share(solid.series)},
          {"alpha", terms.size() == 1 ? Json(solid.instantaneous.terms[0].alpha) : Json(nullptr)},
          {"instantaneous", terms},
          {"series", json_of(solid.series)}};
}

Json minima_of(const RelaxationFit& fit) {
  Json all = Json::array();
  for (const RelaxationMinimum& minimum : fit.minima) {
    all.push_back(json_of(minimum.solid));
    all.back()["objective_above_best"] = finite(minimum.sum_of_squares() / fit.minima.front().sum_of_squares() - 1);
    all.back()["converged"] = minimum.minimum.converged;
  }
  return all;
}

Json rungs_of(const RelaxationFit& fit) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const RelaxationRung& rung : fit.rungs) lowest = std::min(lowest, rung.aicc.value_or(lowest));
  Json all = Json::array();
  for (const RelaxationRung& rung : fit.rungs)
    all.push_back({{"terms", rung.terms},
                   {"objective", rung.objective},
                   {"r2", finite(rung.r2)},
                   {"aicc", finite(rung.aicc)},
                   {"aicc_above_lowest", rung.aicc ? finite(*rung.aicc - lowest) : Json(nullptr)}});
  return all;
}

Json uncertainty_of(const RelaxationFit& fit) {
  if (fit.parameters.empty()) return nullptr;
  Json parameters = Json::object(), order = Json::array(), region = Json::object();
  for (std::size_t k = 0; k < fit.parameters.size(); ++k) {
    const ParameterUncertainty& parameter = fit.parameters[k];
    const std::string key = parameter.unit.empty() ? parameter.name : parameter.name + "_" + parameter.unit;
    parameters[key] = parameter_to_json(parameter);
    region[key] = region_to_json(fit.regions[k]);
    order.push_back(key);
  }
  return {{"level", fit.level},
          {"errors", word(fit.errors)},
          {"scatter", finite(fit.scatter)},
          {"degrees_of_freedom", fit.degrees_of_freedom},
          {"neighbour_correlation", finite(fit.neighbour_correlation)},
          {"parameters", parameters},
          {"order", order},
          {"region", region}};
}

Json histories_of(const CurveData& data, const RelaxationFit& fit) {
  Json all = Json::array();
  for (const FittedHistory& fitted : fit.histories) {
    Json time = Json::array(), amount = Json::array(), stress = Json::array();
    for (std::size_t i = fitted.history.begin; i < fitted.history.end; ++i) {
      time.push_back(*data.points[i].time);
      amount.push_back(data.points[i].strained.amount);
      stress.push_back(data.points[i].nominal_stress);
    }
    all.push_back({{"name", fitted.name},
                   {"deformation", word(fitted.history.deformation)},
                   {"start_s", fitted.history.start},
                   {"time_s", time},
                   {"amount", amount},
                   {"stress_Pa", stress},
                   {"model_Pa", fitted.model}});
  }
  return all;
}

}  // namespace

std::string target_of_scene(const RelaxingSolid& solid) {
  const auto& terms = solid.instantaneous.terms;
  if (terms.size() != 1 || std::abs(terms[0].alpha) < smallest_alpha_of_a_scene) return "";
  std::string text =
      fmt::format("[target]\nmu = \"{} Pa\"  # instantaneous\nalpha = {}\n", terms[0].mu, terms[0].alpha);
  for (const PronyTerm& term : solid.series.terms)
    if (term.share > 0)
      text += fmt::format("\n[[target.relaxation]]\nshare = {}\ntime = \"{} s\"\n", term.share, term.time);
  return text;
}

Json relaxation_to_json(const CurveData& data, const RelaxationFit& fit) {
  Json result = fit.minima.empty() ? json_of(RelaxingSolid{}) : json_of(fit.minima.front().solid);
  if (fit.minima.empty()) result["mu_0_Pa"] = result["mu_inf_Pa"] = nullptr;
  const std::string scene = fit.minima.empty() ? "" : target_of_scene(fit.minima.front().solid);
  result.update({{"asked", word(fit.choice)},
                 {"terms", fit.terms},
                 {"converged", !fit.minima.empty() && fit.minima.front().minimum.converged},
                 {"minima", minima_of(fit)},
                 {"rungs", rungs_of(fit)},
                 {"uncertainty", uncertainty_of(fit)},
                 {"shortest_interval_s", fit.scales.shortest_interval},
                 {"longest_record_s", fit.scales.longest_record},
                 {"histories", histories_of(data, fit)},
                 {"scene", scene.empty() ? Json(nullptr) : Json(scene)}});
  return result;
}

}  // namespace percal
