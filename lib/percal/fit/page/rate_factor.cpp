// The page of `percal fit --rate-factor`: one factor between the curves of one solid at two rates.
#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "percal/fit/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page_of_fit {
namespace {

Table moduli_table(const Json& result) {
  Table table{
      .caption = "", .rows = {{"one alpha for both rates", "value", level_words(result) + " interval"}}, .notes = {}};
  const auto row = [&](const char* name, const char* key, const Dimension& dimension) {
    const Json& parameter = at(result, key);
    table.rows.push_back(
        {name, quantity(number(parameter, "value"), dimension),
         interval_words(parameter, dimension, 4) + (yes(parameter, "identifiable") ? "" : ", not identifiable")});
  };
  row("rate factor", "rate_factor", dimension::none);
  row("mu at the low rate", "mu_slow_Pa", dimension::pressure);
  row("mu at the high rate", "mu_fast_Pa", dimension::pressure);
  row("alpha", "alpha", dimension::none);
  return table;
}

Section factor_section(const Json& result) {
  Section section{.id = "result", .title = "What came out", .blocks = {}, .detail = Detail::answer};
  const Json& sources = list(result, "sources");
  const auto curve_words = [&](std::size_t k, const char* key, const char* rate) {
    return fmt::format("{} points at the {} rate ({})", shown(number(at(result, key), "points"), 9), rate,
                       std::filesystem::path(text(sources.at(k), "file")).filename().string());
  };
  add_sentence(section,
               fmt::format("{} and {}; one factor between their stresses, the one-term Ogden solid with one alpha and "
                           "two moduli, {} residuals.",
                           curve_words(0, "slow", "low"), curve_words(1, "fast", "high"), text(result, "residual")));
  add(section, moduli_table(result));
  return section;
}

Section pair_section(const Json& result) {
  Section section{.id = "curves", .title = "The curves over their points", .blocks = {}};
  const double alpha = number_or(at(result, "alpha"), "value", NAN);
  std::vector<PageCurve> curves;
  for (const PagePoints& points : points_of(result)) {
    const char* const key = points.name == "low rate" ? "mu_slow_Pa" : "mu_fast_Pa";
    const Hyperelastic solid{std::vector<Ogden>{{number_or(at(result, key), "value", NAN), alpha}}};
    curves.push_back({"fit, " + points.name, points,
                      [solid](const Strained& strained) { return nominal_stress(solid, strained); },
                      [](const Strained&) { return NAN; }});
  }
  if (curves.empty() || !std::isfinite(alpha)) return section;
  add_curve_figures(section, curves, "No band: the intervals are of the factor and the parameters, in the table.");
  add(section, residual_figure(curves, text(result, "residual")));
  return section;
}

Section alone_section(const Json& result) {
  Section section{.id = "alone", .title = "Each curve alone", .blocks = {}};
  Table table{
      .caption = "", .rows = {{"", "points", "mu true", "alpha", "2 mu/alpha", "errors from the"}}, .notes = {}};
  const auto twice_over = [](const std::optional<double>& mu, const std::optional<double>& alpha) {
    return mu && alpha ? pressure(2 * *mu / *alpha) : absent;
  };
  for (const auto& [name, key] : {std::pair{"low rate", "slow"}, {"high rate", "fast"}}) {
    const Json& curve = at(result, key);
    const auto mu = number(curve, "mu_alone_Pa"), alpha = number(curve, "alpha_alone");
    table.rows.push_back({name, shown(number(curve, "points"), 9), pressure(mu), shown(alpha), twice_over(mu, alpha),
                          text(curve, "errors")});
  }
  const Json& shape = at(result, "one_shape");
  const auto alpha = number(at(result, "alpha"), "value");
  table.notes = {
      fmt::format("One alpha {}: F {}, which chance alone makes as large in {} of such pairs.",
                  yes(shape, "serves") ? "serves both" : "does not serve both", shown(number(shape, "f"), 3),
                  percent(number(shape, "chance"))),
      fmt::format("mu is the small-strain shear modulus; 2 mu/alpha is the number that LS-DYNA and others call "
                  "MU1 or mu: with one alpha {} at the low rate and {} at the high rate. The factor is the same "
                  "in both.",
                  twice_over(number(at(result, "mu_slow_Pa"), "value"), alpha),
                  twice_over(number(at(result, "mu_fast_Pa"), "value"), alpha))};
  add(section, table);
  add(section, sources_table(result));
  return section;
}

}  // namespace

Page rate_factor_page(const Json& result) {
  const Json& factor = at(result, "rate_factor");
  Page page;
  page.title = "Rate factor between two curves";
  page.summary =
      fmt::format("The stress at the high rate is {} times that at the low rate ({} interval {}).",
                  shown(number(factor, "value")), level_words(result), interval_words(factor, dimension::none));
  for (auto section : {warnings_section, factor_section, taken_section, findings_section, pair_section, alone_section,
                       provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal::page_of_fit
