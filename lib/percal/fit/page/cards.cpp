#include "percal/fit/page/cards.hpp"

#include <fmt/core.h>

#include <cmath>

#include "percal/units/words.hpp"

namespace percal {
namespace {

// All that the points allow. Of planar tension and simple shear, even in alpha, both signs fit the same: there it is this sign's.
Interval allowed(const Uncertainty& uncertainty, const std::string& name, const Interval& piece) {
  for (const ParameterRegion& region : uncertainty.region) {
    if (region.name != name) continue;
    const Interval all = hull(region.pieces);
    return region.pieces.size() > 1 && std::abs(all.low + all.high) < 1e-3 * all.high ? piece : all;
  }
  return piece;
}

// "mu" is mu_true_Pa on a card, "mu_2" mu_true_Pa_2.
std::optional<CardIntervals> intervals_of(const Uncertainty& uncertainty) {
  if (uncertainty.minima.empty()) return std::nullopt;
  const MinimumUncertainty& best = uncertainty.minima.front();
  CardIntervals intervals{uncertainty.options.level, {}};
  if (best.small_strain_modulus)
    intervals.of.push_back(
        card_interval("mu_true_Pa", allowed(uncertainty, "small_strain_mu", *best.small_strain_modulus)));
  for (const ParameterUncertainty& parameter : best.parameters) {
    const bool modulus = parameter.name.starts_with("mu");
    intervals.of.push_back(card_interval(modulus ? "mu_true_Pa" + parameter.name.substr(2) : parameter.name,
                                         allowed(uncertainty, parameter.name, parameter.interval)));
  }
  return intervals;
}

// The values that rows were chosen by, "fit" where there are none.
std::string name_of(const std::vector<std::string>& where) {
  std::vector<std::string> values;
  for (const std::string& condition : where)
    if (const auto equals = condition.find('='); equals != std::string::npos)
      values.push_back(trimmed(condition.substr(equals + 1)));
  return values.empty() ? "fit" : listed(values);
}

}  // namespace

CardInterval card_interval(const std::string& parameter, const Interval& interval) {
  const auto end = [](double value, bool open) {
    return open || !std::isfinite(value) ? std::nullopt : std::optional(value);
  };
  return {parameter, end(interval.low, interval.low_open), end(interval.high, interval.high_open)};
}

std::vector<CardMaterial> fit_cards(const CurveData& data, const CurveFit& fit, const Uncertainty& uncertainty,
                                    const std::vector<std::string>& where) {
  if (fit.minima.empty()) return {};
  const CurveMinimum& best = fit.minima.front();
  std::vector<std::string> files;
  for (const CurveSource& source : data.sources) files.push_back(source.file);
  CardMaterial card{.name = name_of(where),
                    .terms = best.solid.terms,
                    .comments = {"fitted by percal: model " + word(fit.options.model)},
                    .intervals = intervals_of(uncertainty),
                    .data = card_data(files)};
  if (!where.empty()) card.comments.push_back("rows where " + listed(where));
  if (best.r2 && std::isfinite(*best.r2))
    card.fit_error =
        fmt::format("R^2 {:.6g} in stress, residual {}, {} points", *best.r2, word(fit.options.residual), fit.points);
  return {card};
}

}  // namespace percal
