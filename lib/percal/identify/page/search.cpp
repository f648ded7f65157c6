// What an identification searched: the concentration law, alpha, the ridge, and what the mesh is worth.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "percal/identify/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page_of_identify {
namespace {

double largest(const Json& entries, const std::string& key) {
  double most = 0;
  for (const Json& entry : entries) most = std::max(most, std::abs(number_or(entry, key, 0)));
  return most;
}

}  // namespace

std::string sphere_words(const Json& sphere) {
  return fmt::format("{} of radius {} at {} m/s", text(sphere, "particle"), length(number(sphere, "radius_m")),
                     shown(number(sphere, "speed_m_s")));
}

Section law_section(const Json& result) {
  Section section{.id = "law", .title = "Modulus against concentration", .blocks = {}};
  const Json &model = at(result, "model"), &law = at(result, "gelatin_law");
  const Json& formulations = list(model, "formulations");
  const auto k = number(law, "k_Pa"), n = number(law, "n");
  if (formulations.empty() || !k || !n) return section;
  add_sentence(section, fmt::format("The modulus of {} is that of the formulation of {} in which {} goes as deep as in "
                                    "the system that is similar to the calibration's shot, carried over.",
                                    text(at(result, "skin"), "name"), text(model, "material"), sphere_words(model)));
  const ShownUnit unit = pressure_unit(largest(formulations, "mu_quasistatic_as_given_Pa"));
  Series fitted = series("measured", Mark::points, 0), others = series("not fitted", Mark::points, 1);
  double low = HUGE_VAL, high = 0, chosen = number_or(at(result, "similarity"), "formulation", nowhere), at_chosen = 0;
  for (const Json& one : formulations) {
    const double c = number_or(one, "concentration", nowhere);
    add_point(yes(one, "in_law") ? fitted : others, c,
              number_or(one, "mu_quasistatic_as_given_Pa", nowhere) / unit.size);
    low = std::min(low, c);
    high = std::max(high, c);
    if (c == chosen) at_chosen = *k * std::pow(c, *n) / unit.size;
  }
  Series line = series(fmt::format("k c^{:.3g}", *n), Mark::line, 0);
  for (const double c : spaced(low, high)) add_point(line, c, *k * std::pow(c, *n) / unit.size);
  Chart chart{.title = "Quasi-static modulus of " + text(model, "material"),
              .x = {.label = "concentration"},
              .y = {.label = "mu as given, " + unit.name}};
  add(chart, line);
  add(chart, fitted);
  add(chart, others);
  Figure figure{.name = "law",
                .caption = fmt::format("mu = k c^n with k = {} and n = {:.3g}. The identification takes concentration "
                                       "{}, for which the law says {:.4g} {}.",
                                       with_error(pressure(k), pressure(number(law, "k_standard_error_Pa"), 2)), *n,
                                       shown(chosen), at_chosen, unit.name),
                .alt = fmt::format("Modulus against concentration: {} measured points and the power law through them, "
                                   "from {:.3g} to {:.3g}.",
                                   formulations.size(), low, high),
                .chart = chart};
  add(section, std::move(figure));
  return section;
}

Section alpha_section(const Json& result) {
  Section section{.id = "alpha", .title = "The exponent alpha", .blocks = {}};
  const Json& alpha = at(result, "alpha");
  const auto value = number(alpha, "value");
  if (text(alpha, "from") != "scan") {
    if (value) add_sentence(section, "alpha is given: " + shown(value) + ".");
    return section;
  }
  const double target = number_or(at(result, "calibration"), "penetration_m", nowhere);
  std::map<double, std::vector<double>> deviations;
  for (const Json& trial : list(alpha, "trials"))
    if (const auto depth = number(trial, "depth_m"))
      deviations[number_or(trial, "alpha", nowhere)].push_back(100 * std::abs(*depth / target - 1));
  Series trials = series("as run", Mark::points, 0), smoothed = series("smoothed over alpha", Mark::line, 0),
         taken = series("taken", Mark::points, 1);
  for (const auto& [at_alpha, all] : deviations) {
    double sum = 0;
    for (const double one : all) sum += one;
    add_point(trials, at_alpha, sum / static_cast<double>(all.size()));
  }
  for (const Json& score : list(alpha, "scores"))
    add_point(smoothed, number_or(score, "alpha", nowhere), 100 * number_or(score, "mean_deviation", nowhere));
  add_point(taken, *value, 100 * number_or(alpha, "mean_deviation", nowhere));
  const double limit =
      100 * (number_or(alpha, "best_mean_deviation", nowhere) + number_or(alpha, "standard_error", nowhere));
  Series within = series("one standard error above the best", Mark::dashes, -1);
  if (!smoothed.x.empty())
    for (const double x : {smoothed.x.front(), smoothed.x.back()}) add_point(within, x, limit);
  Chart chart{.title = "Scan of alpha over the known pairs",
              .x = {.label = "alpha"},
              .y = {.label = "mean deviation of the depths, %", .low = 0}};
  for (const Series& one : {smoothed, trials, within, taken}) add(chart, one);
  const std::string range = fmt::format("{} to {}", shown(number(alpha, "indistinguishable_from")),
                                        shown(number(alpha, "indistinguishable_to")));
  add(section,
      Figure{.name = "alpha",
             .caption = fmt::format("The depths at the known pairs are nearest to the measured one at alpha {} "
                                    "({} away in the mean), but no alpha from {} is worse by more than a "
                                    "standard error. The mildest of them, {}, is taken.",
                                    shown(number(alpha, "best")), percent(number(alpha, "best_mean_deviation")), range,
                                    shown(value)),
             .alt = fmt::format("Mean deviation of depths against alpha: a valley whose floor reaches from {}.", range),
             .chart = chart});
  return section;
}

Table ridge_table(const Json& result) {
  Table table{.caption = "Pairs of modulus and erosion strain that give the calibration's depth",
              .rows = {{"strain", "mu as given", "mu true", "error: solver", "data", "published", "outcome"}},
              .notes = {}};
  for (const Json& point : list(result, "ridge"))
    table.rows.push_back({shown(number(point, "erosion_strain")), pressure(number(point, "mu_as_given_Pa")),
                          pressure(number(point, "mu_true_Pa")), percent(number(point, "relative_error_solver")),
                          percent(number(point, "relative_error_data")),
                          pressure(number(point, "table_mu_as_given_Pa")), text(point, "outcome")});
  return table;
}

Section ridge_section(const Json& result) {
  Section section{.id = "ridge", .title = "The ridge", .blocks = {}};
  const Json &ridge = list(result, "ridge"), &tissue = at(result, "skin");
  const ShownUnit unit = pressure_unit(largest(ridge, "mu_as_given_Pa"));
  Series line = series("", Mark::line, 0), ours = series("percal", Mark::points_with_bars, 0),
         published = series("published pairs", Mark::points, 1), found = series("identified", Mark::points, 2);
  double softest = HUGE_VAL, stiffest = 0;
  for (const Json& point : ridge) {
    const double strain = number_or(point, "erosion_strain", nowhere);
    const double mu = number_or(point, "mu_as_given_Pa", nowhere) / unit.size;
    const double error =
        mu * std::hypot(number_or(point, "relative_error_solver", 0), number_or(point, "relative_error_data", 0));
    add_bar(ours, strain, mu, mu - error, mu + error);
    add_point(line, strain, mu);
    add_point(published, strain, number_or(point, "table_mu_as_given_Pa", nowhere) / unit.size);
    if (!std::isfinite(mu)) continue;
    softest = std::min(softest, mu);
    stiffest = std::max(stiffest, mu);
  }
  add_point(found, number_or(tissue, "erosion_strain", nowhere),
            number_or(tissue, "mu_highrate_as_given_Pa", nowhere) / unit.size);
  Chart chart{.title = "Pairs that give the calibration's depth",
              .x = {.label = "erosion strain (" + text(tissue, "strain_measure") + ")"},
              .y = {.label = "mu as given, " + unit.name, .logarithmic = true}};
  for (const Series& one : {line, ours, published, found}) add(chart, one);
  std::string caption = fmt::format(
      "One depth does not tell modulus and erosion strain apart: every pair on this line gives it, "
      "from {:.3g} to {:.3g} {}.",
      stiffest, softest, unit.name);
  if (yes(result, "complete"))
    caption += fmt::format(
        " The modulus from the model material, {}, picks the strain {}.",
        pressure(number(tissue, "mu_highrate_as_given_Pa"), 3),
        with_error(shown(number(tissue, "erosion_strain"), 3), shown(number(tissue, "erosion_strain_error"), 2)));
  add(section, Figure{.name = "ridge",
                      .caption = caption + " Bars: standard errors of solver noise and measured depth.",
                      .alt = fmt::format("Modulus against erosion strain, falling from {:.3g} to {:.3g} {}, with {} "
                                         "published pairs beside it.",
                                         stiffest, softest, unit.name, published.x.size()),
                      .chart = chart});
  return section;
}

Section mesh_section(const Json& result) {
  Section section{.id = "mesh", .title = "What the mesh is worth", .blocks = {}};
  const Json& study = list(result, "mesh_study");
  if (study.empty()) return section;
  std::map<double, double> seconds;
  for (const Json& one : list(at(result, "cost"), "mesh_study"))
    seconds[number_or(one, "elements_per_radius", 0)] = number_or(one, "cpu_s", nowhere);
  const double measured = number_or(at(result, "calibration"), "penetration_m", nowhere);
  const double finest = number_or(study.back(), "depth_m", nowhere);
  const ShownUnit unit = length_unit(finest);
  Series depths = series("percal", Mark::points_with_bars, 0), line = series("", Mark::line, 0),
         target = series("measured", Mark::dashes, 1), errors = series("", Mark::points_with_bars, 0);
  double largest_error = 0;
  for (const Json& one : study) {
    const double n = number_or(one, "elements_per_radius", nowhere), depth = number_or(one, "depth_m", nowhere),
                 spread = number_or(one, "depth_spread_m", 0);
    add_bar(depths, n, depth / unit.size, (depth - spread) / unit.size, (depth + spread) / unit.size);
    add_point(line, n, depth / unit.size);
    const double error = 100 * (depth / finest - 1), noise = 100 * spread / finest;
    if (std::isfinite(error)) largest_error = std::max(largest_error, std::abs(error));
    if (const auto cost = seconds.find(n); cost != seconds.end() && cost->second > 0)
      add_bar(errors, cost->second, error, error - noise, error + noise);
  }
  if (!depths.x.empty())
    for (const double n : {depths.x.front(), depths.x.back()}) add_point(target, n, measured / unit.size);
  Chart chart{.title = "The calibration impact at the identified pair",
              .x = {.label = "elements per radius"},
              .y = {.label = "depth, " + unit.name}};
  for (const Series& one : {line, depths, target}) add(chart, one);
  add(section,
      Figure{.name = "mesh",
             .caption = fmt::format("From {} to {} elements per radius the depth changes by up to {:.2g} %. Bars: "
                                    "spread of the replicates.",
                                    shown(number(study.front(), "elements_per_radius")),
                                    shown(number(study.back(), "elements_per_radius")), largest_error),
             .alt = fmt::format("Depth against elements per radius: {} meshes, all within {:.2g} % of the finest.",
                                study.size(), largest_error),
             .chart = chart});
  Chart cost{.title = "Deviation from the finest mesh against run time",
             .x = {.label = "processor time of the replicates, s", .logarithmic = true},
             .y = {.label = "depth over the finest mesh's, less 1, %"}};
  if (errors.x.size() > 1) add(cost, errors);
  if (drawable(cost))
    add(section, Figure{.name = "mesh_cost",
                        .caption = fmt::format("The finest mesh costs {:.2g} times the coarsest. Bars: spread of the "
                                               "replicates; a deviation inside of them is not told from none.",
                                               errors.x.back() / errors.x.front()),
                        .alt = "Deviation of the depth from the finest mesh's against processor time.",
                        .chart = cost});
  return section;
}

}  // namespace percal::page_of_identify
