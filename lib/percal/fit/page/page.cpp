// The page of `percal fit`.
#include "percal/fit/page/page.hpp"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "percal/fit/page/parts.hpp"
#include "percal/page/numbers.hpp"

namespace percal {

using namespace page;

namespace {

std::string model_words(const Json& result) {
  const std::string model = text(result, "model");
  if (model == "ogden") return "the one-term Ogden solid";
  if (model == "ogden2") return "the two-term Ogden solid";
  if (model == "ogden3") return "the three-term Ogden solid";
  return model == "mooney-rivlin" ? "the Mooney-Rivlin solid" : "the neo-Hookean solid";
}

const Json& best(const Json& result) {
  static const Json nothing = nullptr;
  const Json& minima = list(result, "minima");
  return minima.empty() ? nothing : minima[0];
}

// What the intervals say of the minimum with this index.
const Json& uncertainty_of(const Json& result, std::size_t minimum) {
  static const Json nothing = nullptr;
  for (const Json& about : list(at(result, "uncertainty"), "minima"))
    if (number_or(about, "minimum", -1) == static_cast<double>(minimum)) return about;
  return nothing;
}

std::string summary_of(const Json& result) {
  const Json& minimum = best(result);
  if (minimum.is_null()) return "No solid with the signs asked for fits better than none: there is no result.";
  std::string summary = "Small-strain shear modulus " + pressure(number(minimum, "mu_Pa"));
  const Json& about = at(uncertainty_of(result, 0), "parameters");
  const Json& mu = at(about, "mu_Pa");
  if (mu.is_object())
    summary += " (" + level_words(at(result, "uncertainty")) + " interval " + interval_words(mu, dimension::pressure) + ")";
  if (const auto alpha = number(minimum, "alpha")) {
    summary += ", alpha " + shown(alpha);
    const Json& parameter = at(about, "alpha");
    if (parameter.is_object()) summary += " (" + interval_words(parameter, dimension::none) + ")";
  }
  return summary + fmt::format("; R2 {}{}.", shown(number(minimum, "r2")),
                               yes(minimum, "converged") ? "" : ", but the fit did not converge");
}

Section asked_section(const Json& result) {
  Section section{.id = "asked", .title = "What was asked", .blocks = {}};
  const std::string loss = text(result, "loss");
  List bullets;
  bullets.items = {fmt::format("Fit {} to {} points, {} residuals{}{}.", model_words(result),
                               shown(number(result, "points"), 9), text(result, "residual"),
                               loss == "squares" ? "" : ", the robust loss " + loss,
                               text(result, "signs") == "free" ? ", single moduli of either sign" : "")};
  if (const std::string weights = text(at(result, "input"), "weights"); !weights.empty() && weights != "points")
    bullets.items.push_back("Weights: " + weights + ".");
  section.blocks.push_back(bullets);
  add(section, sources_table(result));
  Table tests{.caption = "The tests in them",
              .rows = {{"test", "deformation", "points", "weight of a point", "R2"}},
              .notes = {}};
  for (const Json& test : list(result, "tests"))
    tests.rows.push_back({text(test, "name"), text(test, "deformation"), shown(number(test, "points"), 9),
                          shown(number(test, "weight_of_point"), 3),
                          shown(number(at(best(result), "r2_of_test"), text(test, "name")))});
  add(section, tests);
  return section;
}

void add_bootstraps(std::vector<std::string>& row, const Json& parameter, const Dimension& dimension) {
  for (const char* kind : {"points", "residuals", "parametric"})
    row.push_back(interval_words(at(at(parameter, "bootstrap"), kind), dimension));
}

// mu true and 2 mu/alpha of every term, the exponents, with their intervals.
Table parameter_table(const Json& result) {
  const Json& about = uncertainty_of(result, 0);
  const bool bootstrap = number_or(at(result, "uncertainty"), "bootstrap_replicates", 0) > 0;
  const auto errors = curve_errors(result);
  const Hyperelastic solid = solid_of(best(result));
  const bool single = solid.terms.size() == 1;
  Table table{.caption = "The best minimum", .rows = {{"", "value", level_words(at(result, "uncertainty")) + " interval"}}, .notes = {}};
  if (bootstrap)
    for (const char* kind : {"bootstrap: points", "bootstrap: residuals", "bootstrap: parametric"})
      table.rows[0].push_back(kind);
  const auto row = [&](const std::string& name, const std::string& key, std::optional<double> value,
                       const Dimension& d) {
    const Json& parameter = at(at(about, "parameters"), key);
    std::vector<std::string> cells{name, quantity(value, d), interval_words(parameter, d)};
    if (parameter.is_object() && !yes(parameter, "identifiable")) cells[2] += ", not identifiable";
    if (bootstrap) add_bootstraps(cells, parameter, d);
    table.rows.push_back(cells);
  };
  for (std::size_t k = 0; k < solid.terms.size(); ++k) {
    const std::string suffix = single ? "" : fmt::format("_{}", k + 1), of = single ? "" : fmt::format(" {}", k + 1);
    row("mu" + of + ", true", "mu" + suffix + "_Pa", solid.terms[k].mu, dimension::pressure);
    const Mu1 mu1 = mu_over_alpha(solid.terms[k], errors);
    if (std::isfinite(mu1.value)) {
      table.rows.push_back({"2 mu" + of + "/alpha" + of, pressure(mu1.value),
                            mu1.half_width ? pressure(mu1.value - *mu1.half_width) + " to " +
                                                 pressure(mu1.value + *mu1.half_width) + " (linearised)"
                                           : "-"});
    }
    row("alpha" + of, "alpha" + suffix, solid.terms[k].alpha, dimension::none);
  }
  if (!single)
    table.rows.push_back({"small-strain modulus, the sum", pressure(number(best(result), "mu_Pa")),
                          interval_words(at(about, "small_strain_mu_Pa"), dimension::pressure)});
  for (const char* constant : {"C10_Pa", "C01_Pa"})
    if (const auto value = number(best(result), constant))
      table.rows.push_back({std::string(constant).substr(0, 3), pressure(value), "-"});
  table.notes = {
      "mu is the small-strain shear modulus of W = sum (2 mu/alpha^2) (lambda_1^alpha + lambda_2^alpha + "
      "lambda_3^alpha - 3); "
      "2 mu/alpha is the number that LS-DYNA and others call MU1 or mu."};
  return table;
}

Section result_section(const Json& result) {
  Section section{.id = "result", .title = "What came out", .blocks = {}};
  if (best(result).is_null()) {
    add_sentence(section, summary_of(result));
    return section;
  }
  add(section, parameter_table(result));
  const Json& uncertainty = at(result, "uncertainty");
  if (uncertainty.is_null()) add_sentence(section, "Intervals were not asked for (--no-intervals).");
  if (uncertainty.is_object())
    add_sentence(
        section,
        fmt::format(
            "Where the error comes from: the points' {}, with a scatter of {} ({} degrees of "
            "freedom). The intervals are profile likelihoods{}.",
            text(uncertainty, "errors") == "residuals" ? "own scatter about the model" : "standard errors in the file",
            shown(number(uncertainty, "scatter"), 3), shown(number(uncertainty, "degrees_of_freedom"), 9),
            number(best(result), "correlation")
                ? "; mu and alpha are correlated by " + shown(number(best(result), "correlation"), 3)
                : std::string()));
  const auto findings = texts(at(result, "findings")), about = texts(at(uncertainty, "findings"));
  List bullets{findings};
  bullets.items.insert(bullets.items.end(), about.begin(), about.end());
  if (!bullets.items.empty()) section.blocks.push_back(bullets);
  return section;
}

Section curves_section(const Json& result) {
  Section section{.id = "curves", .title = "The curve over its points", .blocks = {}};
  const Hyperelastic solid = solid_of(best(result));
  const auto points = points_of(result);
  if (points.empty() || solid.terms.empty()) {
    if (!solid.terms.empty())
      add_sentence(section, "This result keeps no points. `percal fit ... --out` of this version writes them.");
    return section;
  }
  const auto errors = curve_errors(result);
  std::vector<PageCurve> curves;
  for (const PagePoints& test : points)
    curves.push_back({"fit", test, [solid](const Strained& at) { return nominal_stress(solid, at); },
                      [solid, errors](const Strained& at) { return errors ? half_width(solid, *errors, at) : NAN; }});
  add_curve_figures(section, curves,
                    errors ? fmt::format("The band is the {:g} % confidence band of the curve, from the linearised "
                                         "covariance of the parameters; single points scatter more.",
                                         100 * errors->level)
                           : "No band: the fit gives no standard errors.");
  add(section, residual_figure(curves, text(result, "residual")));
  return section;
}

Section minima_section(const Json& result) {
  Section section{.id = "minima", .title = "Every minimum", .blocks = {}};
  Table table{.caption = "All minima of the objective",
              .rows = {{"", "mu true", "alpha", "2 mu/alpha", "objective", "above the best", "R2", "remark"}},
              .notes = {}};
  const Json& minima = list(result, "minima");
  for (std::size_t k = 0; k < minima.size(); ++k) {
    const Hyperelastic solid = solid_of(minima[k]);
    std::string mu, alpha, mu1;
    for (const Ogden& term : solid.terms) {
      const std::string comma = mu.empty() ? "" : "; ";
      mu += comma + pressure(term.mu);
      alpha += comma + shown(term.alpha);
      mu1 += comma + pressure(2 * term.mu / term.alpha);
    }
    std::string remark = yes(minima[k], "converged") ? "" : "not converged";
    if (yes(minima[k], "at_bound")) remark += remark.empty() ? "at a bound" : ", at a bound";
    table.rows.push_back({std::to_string(k + 1), mu, alpha, mu1, shown(number(minima[k], "objective")),
                          percent(number(minima[k], "objective_above_best")), shown(number(minima[k], "r2")),
                          remark.empty() ? "-" : remark});
  }
  table.notes = {"The objective is in " + text(result, "objective_unit") + "."};
  add(section, table);
  return section;
}

Table stability_table(const Json& stability) {
  Table table{.caption = "Stretches within which the solid is stable", .rows = {{"", "from", "to"}}, .notes = {}};
  for (const auto& [mode, range] : at(stability, "stretches").items())
    table.rows.push_back({mode, shown(number(range, "low")) + (yes(range, "low_is_searched_end") ? " or less" : ""),
                          shown(number(range, "high")) + (yes(range, "high_is_searched_end") ? " or more" : "")});
  return table;
}

Section stability_section(const Json& result) {
  Section section{.id = "stability", .title = "Where the solid is stable", .blocks = {}};
  const Json& stability = at(result, "stability");
  if (!stability.is_object()) return section;
  add(section, stability_table(stability));
  add_sentence(section, text(stability, "card_comment"));
  return section;
}

Section comparison_section(const Json& result) {
  Section section{.id = "models", .title = "Other models", .blocks = {}};
  Table table{
      .caption = "All models on the same points",
      .rows = {{"", "parameters", "mu true", "R2", "AICc above the lowest", "misses tests left out by", "stable"}},
      .notes = {"AICc weighs the fit against the number of parameters: lower is better. Tests left out are "
                "predicted by a fit to the others; the figure is the mean relative deviation."}};
  for (const Json& model : list(result, "comparison")) {
    const Json& fit = best(model);
    const std::string why = text(model, "not_fitted");
    table.rows.push_back({text(model, "model"), shown(number(model, "parameters"), 9),
                          why.empty() ? pressure(number(fit, "mu_Pa")) : why, shown(number(fit, "r2")),
                          shown(number(model, "aicc_above_lowest"), 3),
                          percent(number(model, "left_out_mean_relative_deviation")),
                          !at(model, "stability").is_object()                ? "-"
                          : yes(at(model, "stability"), "stable_throughout") ? "yes"
                                                                             : "in part"});
  }
  add(section, table);
  return section;
}

Section left_out_points(const Json& result) {
  Section section{.id = "left-out", .title = "What was left out", .blocks = {}};
  List bullets;
  const auto say = [&](const char* key, const char* why) {
    if (const double count = number_or(result, key, 0); count > 0)
      bullets.items.push_back(fmt::format("{:g} point{}: {}", count, count == 1 ? "" : "s", why));
  };
  say("left_out_zero_stress", "their stress is zero, and relative residuals divide by it");
  say("left_out_no_error", "they have no standard error above zero");
  const auto where = texts(at(at(result, "input"), "where"));
  for (const std::string& condition : where) bullets.items.push_back("rows without " + condition);
  if (bullets.items.empty()) bullets.items.push_back("No point.");
  bullets.items.push_back("Compressibility, rate and temperature: the solid is incompressible and elastic.");
  section.blocks.push_back(bullets);
  return section;
}

}  // namespace

page::Page fit_page(const page::Json& result) {
  if (at(result, "rate_factor").is_object()) return rate_factor_page(result);
  Page page;
  std::string files;
  for (const Json& source : list(result, "sources"))
    files += (files.empty() ? "" : ", ") + std::filesystem::path(text(source, "file")).filename().string();
  page.title = "Fit of " + model_words(result) + " to " + (files.empty() ? "curves" : files);
  page.summary = summary_of(result);
  for (auto section : {asked_section, result_section, curves_section, minima_section, stability_section,
                       comparison_section, left_out_points, provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal
