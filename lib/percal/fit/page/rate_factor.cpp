// The page of `percal fit --rate-factor`: one factor between the curves of one solid at two rates.
#include <fmt/core.h>

#include <cmath>

#include "percal/fit/page/parts.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page {
namespace {

Table parameter_table(const Json& result) {
  Table table{.caption = "One alpha for both rates",
              .rows = {{"", "value", fmt::format("{:g} % interval", 100 * number_or(result, "level", 0.95))}},
              .notes = {"mu is the small-strain shear modulus; 2 mu/alpha is the number that LS-DYNA and others call "
                        "MU1 or mu. The factor is the same in both."}};
  const auto row = [&](const char* name, const char* key, const Dimension& dimension) {
    const Json& parameter = at(result, key);
    table.rows.push_back(
        {name, quantity(number(parameter, "value"), dimension),
         interval_words(parameter, dimension) + (yes(parameter, "identifiable") ? "" : ", not identifiable")});
  };
  row("rate factor", "rate_factor", dimension::none);
  row("mu at the low rate, true", "mu_slow_Pa", dimension::pressure);
  row("mu at the high rate, true", "mu_fast_Pa", dimension::pressure);
  row("alpha", "alpha", dimension::none);
  const double alpha = number_or(at(result, "alpha"), "value", NAN);
  for (const auto& [name, key] :
       {std::pair{"2 mu/alpha at the low rate", "mu_slow_Pa"}, std::pair{"2 mu/alpha at the high rate", "mu_fast_Pa"}})
    table.rows.push_back({name, pressure(2 * number_or(at(result, key), "value", NAN) / alpha), "-"});
  return table;
}

Table alone_table(const Json& result) {
  Table table{.caption = "Each curve alone",
              .rows = {{"", "points", "mu true", "alpha", "2 mu/alpha", "errors from the"}},
              .notes = {}};
  for (const auto& [name, key] : {std::pair{"low rate", "slow"}, std::pair{"high rate", "fast"}}) {
    const Json& curve = at(result, key);
    const auto mu = number(curve, "mu_alone_Pa"), alpha = number(curve, "alpha_alone");
    table.rows.push_back({name, shown(number(curve, "points"), 9), pressure(mu), shown(alpha),
                          mu && alpha ? pressure(2 * *mu / *alpha) : "-", text(curve, "errors")});
  }
  const Json& shape = at(result, "one_shape");
  table.notes = {fmt::format("One alpha {}: F {}, which chance alone makes as large in {} of such pairs.",
                             yes(shape, "serves") ? "serves both" : "does not serve both", shown(number(shape, "f"), 3),
                             percent(number(shape, "chance")))};
  return table;
}

Section curves_section(const Json& result) {
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

Section result_section(const Json& result) {
  Section section{.id = "result", .title = "What came out", .blocks = {}};
  add(section, parameter_table(result));
  add(section, alone_table(result));
  if (const auto findings = texts(at(result, "findings")); !findings.empty()) section.blocks.push_back(List{findings});
  return section;
}

}  // namespace

Page rate_factor_page(const Json& result) {
  const Json& factor = at(result, "rate_factor");
  Page page;
  page.title = "Rate factor between two curves";
  page.summary = fmt::format("The stress at the high rate is {} times that at the low rate ({:g} % interval {}).",
                             shown(number(factor, "value")), 100 * number_or(result, "level", 0.95),
                             interval_words(factor, dimension::none));
  Section asked{.id = "asked", .title = "What was asked", .blocks = {}};
  add_sentence(asked, fmt::format("One factor between the stresses of one solid at two rates: the one-term Ogden "
                                  "solid with one alpha and two moduli, {} residuals.",
                                  text(result, "residual")));
  add(asked, sources_table(result));
  add(page, asked);
  for (auto section : {result_section, curves_section, provenance_section, input_section}) add(page, section(result));
  return page;
}

}  // namespace percal::page
