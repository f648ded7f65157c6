// The page of `percal fit`.
#include "percal/fit/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "percal/fit/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal {

using namespace page_of_fit;

namespace {

std::string model_words(const Json& result) {
  const std::string model = text(result, "model");
  if (model == "ogden") return "the one-term Ogden solid";
  if (model == "ogden2") return "the two-term Ogden solid";
  if (model == "ogden3") return "the three-term Ogden solid";
  return model == "mooney-rivlin" ? "the Mooney-Rivlin solid" : "the neo-Hookean solid";
}

// Of the small-strain modulus: the only one, or the sum of all.
const Json& interval_of_mu(const Json& about) {
  const Json& parameters = at(about, "parameters");
  const Json& only = maybe(parameters, "mu_Pa");
  return only.is_null() ? at(about, "small_strain_mu_Pa") : only;
}

// --- the answer -----------------------------------------------------------------------------------------------------

std::string summary_of(const Json& result) {
  const Json& minimum = best(result);
  if (minimum.is_null()) return "No solid with the signs asked for fits better than none: there is no result.";
  std::string summary = "Small-strain shear modulus " + pressure(number(minimum, "mu_Pa"));
  const bool intervals = has_intervals(result), single = number(minimum, "alpha") || list(minimum, "terms").size() == 1;
  if (intervals)
    summary += " (" + level_of(result) + " " +
               region_of(result, single ? "mu_Pa" : "small_strain_mu_Pa", dimension::pressure) + ")";
  if (const auto alpha = number(minimum, "alpha")) {
    summary += ", alpha " + shown(alpha);
    const Json& parameter = maybe(at(about(result, 0), "parameters"), "alpha");
    if (parameter.is_object()) summary += " (" + region_of(result, "alpha", dimension::none) + ")";
  }
  return summary + fmt::format("; R2 {}{}.", shown(number(minimum, "r2")),
                               yes(minimum, "converged") ? "" : ", but the fit did not converge");
}

// "53 points (24 uniaxial, 29 planar), relative residuals; 3 of zero stress left out."
std::string asked_words(const Json& result) {
  std::string modes, words;
  for (const auto& [mode, points] : at(result, "points_of_mode").items())
    modes += (modes.empty() ? "" : ", ") + shown(number(points), 9) + " " + mode;
  words =
      fmt::format("{} points ({}), {} residuals", shown(number(result, "points"), 9), modes, text(result, "residual"));
  if (text(result, "loss") != "squares") words += ", the robust loss " + text(result, "loss");
  if (text(result, "signs") == "free") words += ", single moduli of either sign";
  const std::string weights = text(at(result, "input"), "weights");
  if (weights == "tests") words += ", every test counting the same";
  if (weights != "tests" && weights != "points") words += ", tests counting as " + weights;
  for (const auto& [key, what] :
       {std::pair{"left_out_zero_stress", "of zero stress"}, {"left_out_no_error", "without a standard error"}})
    if (const double count = number_or(result, key, 0); count > 0)
      words += fmt::format("; {:g} {} left out", count, what);
  return words + ".";
}

// In a table whose header has the unit.
std::string interval_in(const ShownUnit& unit, const Json& interval) {
  if (!interval.is_object()) return absent;
  Json scaled = interval;
  for (const char* end : {"low", "high"})
    if (const auto value = number(interval, end)) scaled[end] = *value / unit.size;
  return interval_words(scaled, dimension::none);
}

std::string number_in(const ShownUnit& unit, const Json& object, const std::string& key) {
  const auto value = number(object, key);
  return value ? shown(*value / unit.size) : absent;
}

std::string value_and_error(const ShownUnit& unit, const Json& object, const char* key, const char* error) {
  const auto size = number(object, error);
  return with_error(number_in(unit, object, key), size ? shown(*size / unit.size, 2) : absent);
}

std::string remark_on(const Json& minimum) {
  const bool converged = yes(minimum, "converged"), at_bound = yes(minimum, "at_bound");
  return std::string(at_bound ? "at the bound" : "") + (at_bound && !converged ? ", " : "") +
         (converged ? "" : "not converged");
}

// Each with its interval or, where intervals were not asked for, its standard error; the terms of a sum below it.
Table minima_table(const Json& result) {
  const Json& minima = list(result, "minima");
  const bool intervals = has_intervals(result);
  const bool remarks = std::any_of(minima.begin(), minima.end(), [](const Json& m) { return !remark_on(m).empty(); });
  const ShownUnit unit = pressure_unit(number_or(best(result), "mu_Pa", 1)), one{"", 1};
  Table table{.caption = "", .rows = {{"minimum", "mu, " + unit.name, "alpha", "R2", "above best"}}, .notes = {}};
  const auto row = [&](const std::string& name, const Json& solid, const Json& mu, const Json& alpha) {
    std::vector<std::string> cells{name};
    if (intervals)
      cells.insert(cells.end(), {number_in(unit, solid, "mu_Pa"), interval_in(unit, mu), number_in(one, solid, "alpha"),
                                 interval_in(one, alpha)});
    else
      cells.insert(cells.end(), {value_and_error(unit, solid, "mu_Pa", "mu_standard_error_Pa"),
                                 value_and_error(one, solid, "alpha", "alpha_standard_error")});
    table.rows.push_back(cells);
  };
  if (intervals)
    for (const int after : {2, 4}) table.rows[0].insert(table.rows[0].begin() + after, level_of(result));
  if (remarks) table.rows[0].push_back("remark");
  for (std::size_t k = 0; k < minima.size(); ++k) {
    const Json &minimum = minima[k], &parameters = at(about(result, k), "parameters"), &terms = list(minimum, "terms");
    row(std::to_string(k + 1), minimum, interval_of_mu(about(result, k)), maybe(parameters, "alpha"));
    const auto above = number(minimum, "objective_above_best");
    auto& cells = table.rows.back();
    cells.insert(cells.end(), {shown(number(minimum, "r2")), above ? shown(100 * *above, 3) + " %" : absent});
    if (remarks) cells.push_back(remark_on(minimum));
    for (std::size_t i = 0; i < terms.size() && terms.size() > 1; ++i) {
      const std::string suffix = fmt::format("_{}", i + 1);
      row(fmt::format("term {}", i + 1), terms[i], maybe(parameters, "mu" + suffix + "_Pa"),
          maybe(parameters, "alpha" + suffix));
      table.rows.back().resize(table.rows[0].size());
    }
  }
  return table;
}

// Which of the numbers that go by the name of mu is printed; the formula is among the details.
std::string which_mu(const Json& result) {
  const Json& terms = list(best(result), "terms");
  const auto mu = number(terms.at(0), "mu_Pa"), alpha = number(terms.at(0), "alpha");
  if (terms.size() == 1 && mu && alpha && *alpha != 0)
    return "mu is the small-strain shear modulus of W; LS-DYNA's MU1 would be " + pressure(2 * *mu / *alpha) + ".";
  return "mu is the small-strain shear modulus of W, of each term its own; LS-DYNA's MU1 is another number "
         "(--details).";
}

Section result_section(const Json& result) {
  Section section{.id = "result", .title = "What came out", .blocks = {}, .detail = Detail::answer};
  add_sentence(section, asked_words(result));
  if (best(result).is_null()) return section;
  Table minima = minima_table(result);
  minima.notes.push_back(which_mu(result));
  add(section, minima);
  std::string tests;
  for (const Json& test : list(result, "tests"))
    tests += (tests.empty() ? "R2 of the best by test: " : ", ") + text(test, "name") + " " +
             shown(number(at(best(result), "r2_of_test"), text(test, "name")));
  if (list(result, "tests").size() > 1) add_sentence(section, tests + ".");
  if (const std::string stable = text(at(result, "stability"), "card_comment"); !stable.empty())
    add_sentence(section, stable + ".");
  return section;
}

std::string missing_words(const Json& model) {
  if (!text(model, "not_fitted").empty()) return "too few points";
  return best(model).is_null() ? "no positive modulus fits" : "";
}

Section models_section(const Json& result) {
  Section section{.id = "models", .title = "All models on the same points", .blocks = {}, .detail = Detail::answer};
  Table table{
      .caption = "",
      .rows = {{"model", "parameters", "mu", "R2", "AICc", "left out", "stable"}},
      .notes = {"AICc weighs the fit against the number of parameters: lower is better, the lowest is taken as 0. "
                "Left out: by how much, in the mean, a fit to the other tests misses a test. Stable: at all "
                "stretches asked for."}};
  for (const Json& model : list(result, "comparison")) {
    const Json& stability = at(model, "stability");
    const std::string missing = missing_words(model), name = text(model, "model");
    if (!missing.empty()) table.notes.push_back(name + ": " + missing + ".");
    if (const std::string why = text(model, "not_ranked"); !why.empty())
      table.notes.push_back(name + " is not ranked: " + why + ".");
    table.rows.push_back({name, shown(number(model, "parameters"), 9), pressure(number(best(model), "mu_Pa")),
                          shown(number(best(model), "r2")), shown(number(model, "aicc_above_lowest"), 3),
                          percent(number(model, "left_out_mean_relative_deviation")),
                          stability.is_null()                   ? absent
                          : yes(stability, "stable_throughout") ? "yes"
                                                                : "in part"});
  }
  add(section, table);
  return section;
}

Section curves_section(const Json& result) {
  Section section{.id = "curves", .title = "The curve over its points", .blocks = {}};
  const Hyperelastic solid = solid_of(best(result));
  if (solid.terms.empty()) return section;
  const auto errors = curve_errors(result);
  std::vector<PageCurve> curves;
  for (const PagePoints& test : points_of(result))
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

std::string file_words(const Json& result) {
  std::string files;
  for (const Json& source : list(result, "sources"))
    files += (files.empty() ? "" : ", ") + std::filesystem::path(text(source, "file")).filename().string();
  return files;
}

}  // namespace

Page fit_page(const Json& result) {
  if (at(result, "rate_factor").is_object()) return rate_factor_page(result);
  if (relaxes(result))
    return relaxation_page(result, "Fit of " + model_words(result) + ", relaxing, to " + file_words(result));
  Page page{.title = "Fit of " + model_words(result) + " to " + file_words(result),
            .summary = summary_of(result),
            .sections = {}};
  for (auto section : {warnings_section, result_section, taken_section, peaks_section, findings_section, models_section,
                       curves_section, parameters_section, minima_section, stability_section, solids_section,
                       sources_section, left_out_points_section, provenance_section, input_section})
    add(page, section(result));
  return page;
}

Page read_page(const Json& read) {
  Section section{.id = "curves", .title = "What would be fitted", .blocks = {}, .detail = Detail::answer};
  add(section, sources_table(read));
  Page page{.title = file_words(read), .summary = "", .sections = {}};
  add(page, warnings_section(read));
  add(page, taken_section(read));
  add(page, section);
  return page;
}

}  // namespace percal
