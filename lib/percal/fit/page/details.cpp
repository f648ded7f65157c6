// What the page of `percal fit` says below its answer.
#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "percal/fit/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page_of_fit {
namespace {

// mu true and 2 mu/alpha of every term, the exponents, with their intervals.
Table parameter_table(const Json& result) {
  const Json& parameters = at(about(result, 0), "parameters");
  const bool bootstrap = number_or(at(result, "uncertainty"), "bootstrap_replicates", 0) > 0;
  const auto errors = curve_errors(result);
  const Hyperelastic solid = solid_of(best(result));
  const bool single = solid.terms.size() == 1;
  Table table{.caption = "The best minimum", .rows = {{"", "value"}}, .notes = {}};
  if (has_intervals(result)) table.rows[0].push_back(level_of(result));
  if (bootstrap)
    for (const char* kind : {"points drawn anew", "residuals drawn anew", "points from the model"})
      table.rows[0].push_back(kind);
  const auto row = [&](const std::string& name, const std::string& key, double value, const Dimension& d) {
    const Json& parameter = maybe(parameters, key);
    std::vector<std::string> cells{name, quantity(value, d), region_of(result, key, d, 4)};
    if (parameter.is_object() && !yes(parameter, "identifiable")) cells[2] += ", not identifiable";
    for (const char* kind : {"points", "residuals", "parametric"})
      if (bootstrap) cells.push_back(interval_words(at(at(parameter, "bootstrap"), kind), d, 4));
    table.rows.push_back(cells);
  };
  for (std::size_t k = 0; k < solid.terms.size(); ++k) {
    const std::string suffix = single ? "" : fmt::format("_{}", k + 1), of = single ? "" : fmt::format(" {}", k + 1);
    row("mu" + of + ", true", "mu" + suffix + "_Pa", solid.terms[k].mu, dimension::pressure);
    const Mu1 mu1 = mu_over_alpha(solid.terms[k], errors);
    if (std::isfinite(mu1.value))
      table.rows.push_back({"2 mu" + of + "/alpha" + of, pressure(mu1.value),
                            mu1.half_width ? pressure(mu1.value - *mu1.half_width) + " to " +
                                                 pressure(mu1.value + *mu1.half_width) + " (linearised)"
                                           : absent});
    row("alpha" + of, "alpha" + suffix, solid.terms[k].alpha, dimension::none);
  }
  if (!single)
    table.rows.push_back({"small-strain modulus, the sum", pressure(number(best(result), "mu_Pa")),
                          region_of(result, "small_strain_mu_Pa", dimension::pressure, 4) +
                              (has_intervals(result) ? " (linearised)" : "")});
  for (const char* constant : {"C10_Pa", "C01_Pa"})
    if (const auto value = number(best(result), constant))
      table.rows.push_back({std::string(constant).substr(0, 3), pressure(value), absent});
  for (auto& cells : table.rows) cells.resize(table.rows[0].size());
  table.notes = {
      "mu is the small-strain shear modulus of W = sum (2 mu/alpha^2) (lambda_1^alpha + lambda_2^alpha + "
      "lambda_3^alpha - 3); "
      "2 mu/alpha is the number that LS-DYNA and others call MU1 or mu."};
  return table;
}

}  // namespace

const Json& best(const Json& result) {
  static const Json nothing = nullptr;
  const Json& minima = list(result, "minima");
  return minima.empty() ? nothing : minima[0];
}

// What the intervals say of the minimum with this index.
const Json& about(const Json& result, std::size_t minimum) {
  static const Json nothing = nullptr;
  for (const Json& one : list(at(result, "uncertainty"), "minima"))
    if (number_or(one, "minimum", -1) == static_cast<double>(minimum)) return one;
  return nothing;
}

std::string region_of(const Json& result, const std::string& key, const Dimension& dimension, int digits) {
  const Json& pieces = maybe(at(at(result, "uncertainty"), "region"), key);
  const Json& own = maybe(at(about(result, 0), "parameters"), key);
  const Json& interval = own.is_null() ? maybe(about(result, 0), key) : own;
  const bool all_of_it = pieces.size() == 1 && number(interval, "low") == number(pieces[0][0]) &&
                         number(interval, "high") == number(pieces[0][1]);
  return pieces.empty() || all_of_it ? interval_words(interval, dimension, digits)
                                     : region_words(pieces, dimension, digits);
}

bool has_intervals(const Json& result) { return !about(result, 0).is_null(); }

std::string level_of(const Json& result) { return level_words(at(result, "uncertainty")) + " interval"; }

Section parameters_section(const Json& result) {
  Section section{.id = "parameters", .title = "Every parameter", .blocks = {}};
  if (best(result).is_null()) return section;
  add(section, parameter_table(result));
  const Json& uncertainty = at(result, "uncertainty");
  if (uncertainty.is_null()) add_sentence(section, "Intervals were not asked for (--no-intervals).");
  if (has_intervals(result))
    add_sentence(
        section,
        fmt::format(
            "Where the error comes from: the points' {}, with a scatter of {} ({} degrees of freedom). The "
            "intervals are profile likelihoods.",
            text(uncertainty, "errors") == "residuals" ? "own scatter about the model" : "standard errors in the file",
            shown(number(uncertainty, "scatter"), 3), shown(number(uncertainty, "degrees_of_freedom"), 9)));
  return section;
}

Section minima_section(const Json& result) {
  Section section{.id = "minima", .title = "Every minimum", .blocks = {}};
  Table table{.caption = "All minima of the objective, with standard errors",
              .rows = {{"minimum", "mu true", "alpha", "correlation", "2 mu/alpha", "objective"}},
              .notes = {}};
  const Json& minima = list(result, "minima");
  for (std::size_t k = 0; k < minima.size(); ++k) {
    std::string mu, alpha, mu1;
    for (const Json& term : list(minima[k], "terms")) {
      const std::string comma = mu.empty() ? "" : "; ";
      const auto modulus = number(term, "mu_Pa"), exponent = number(term, "alpha");
      mu += comma + with_error(pressure(modulus), pressure(number(term, "mu_standard_error_Pa"), 2));
      alpha += comma + with_error(shown(exponent), shown(number(term, "alpha_standard_error"), 2));
      mu1 += comma + (modulus && exponent ? pressure(2 * *modulus / *exponent) : absent);
    }
    table.rows.push_back({std::to_string(k + 1), mu, alpha, shown(number(minima[k], "correlation")), mu1,
                          shown(number(minima[k], "objective"), 6)});
  }
  const Json& search = at(result, "search");
  const std::string loss = text(result, "loss");
  table.notes = {
      fmt::format("The objective is the sum of {}{}; alpha was searched from {} to {}: {} solids scanned, "
                  "{} started from.",
                  loss == "squares" ? "squared residuals" : "the loss " + loss + " of the residuals",
                  text(result, "objective_unit") == "1" ? "" : ", in " + text(result, "objective_unit"),
                  shown(number(search, "alpha_low")), shown(number(search, "alpha_high")),
                  shown(number(search, "scanned"), 9), shown(number(search, "starts"), 9))};
  add(section, table);
  return section;
}

Section stability_section(const Json& result) {
  Section section{.id = "stability", .title = "Where the solid is stable", .blocks = {}};
  const Json& stretches = at(at(result, "stability"), "stretches");
  Table table{.caption = "Stretches within which the solid is stable", .rows = {{"", "from", "to"}}, .notes = {}};
  for (const auto& [mode, range] : stretches.items())
    table.rows.push_back({mode, shown(number(range, "low")) + (yes(range, "low_is_searched_end") ? " or less" : ""),
                          shown(number(range, "high")) + (yes(range, "high_is_searched_end") ? " or more" : "")});
  add(section, table);
  return section;
}

// R2 of each test and the terms of every model that was compared.
Section solids_section(const Json& result) {
  Section section{.id = "solids", .title = "The solids of all models", .blocks = {}};
  Table table{.caption = "R2 of each test, and mu at alpha of each term", .rows = {{"model"}}, .notes = {}};
  for (const Json& test : list(result, "tests")) table.rows[0].push_back(text(test, "name"));
  table.rows[0].push_back("terms");
  for (const Json& model : list(result, "comparison")) {
    if (best(model).is_null()) continue;
    table.rows.push_back({text(model, "model")});
    for (const Json& test : list(result, "tests"))
      table.rows.back().push_back(shown(number(at(best(model), "r2_of_test"), text(test, "name"))));
    std::string terms;
    for (const Json& term : list(best(model), "terms"))
      terms += (terms.empty() ? "" : " + ") + pressure(number(term, "mu_Pa")) + " at " + shown(number(term, "alpha"));
    table.rows.back().push_back(terms);
  }
  add(section, table);
  return section;
}

Section warnings_section(const Json& result) {
  Section section{.id = "warnings", .title = "Read this first", .blocks = {}, .detail = Detail::answer};
  add(section, List{texts(at(result, "warnings")), Tone::warning});
  return section;
}

Table sources_table(const Json& result) {
  Table table{.caption = "The curves", .rows = {{"file", "x", "stress", "points", "SHA-256"}}, .notes = {}};
  for (const Json& source : list(result, "sources")) {
    const std::string error = text(source, "error"), digest = text(source, "sha256");
    table.rows.push_back(
        {std::filesystem::path(text(source, "file")).filename().string(), text(source, "x"),
         text(source, "y") +
             (text(source, "stress") == "nominal" ? "" : " (" + text(source, "stress") + ", made nominal)") +
             (error.empty() ? "" : ", errors " + error),
         shown(number(source, "points"), 9), digest.empty() ? absent : digest.substr(0, 16) + "..."});
  }
  return table;
}

Section sources_section(const Json& result) {
  Section section{.id = "asked", .title = "What was fitted", .blocks = {}};
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

Section left_out_points_section(const Json& result) {
  Section section{.id = "left-out", .title = "What was left out", .blocks = {}};
  List bullets;
  const auto say = [&](const char* key, const char* why) {
    if (const double count = number_or(result, key, 0); count > 0)
      bullets.items.push_back(counted(std::lround(count), "point") + ": " + why);
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

}  // namespace percal::page_of_fit
