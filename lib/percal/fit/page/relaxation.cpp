// The page of `percal fit --relaxation`: a modulus that relaxes, over the histories it was fitted to.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/fit/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page_of_fit {
namespace {

const Json& relaxation_of(const Json& result) { return at(result, "relaxation"); }

const Json& parameters_of(const Json& result) { return at(at(relaxation_of(result), "uncertainty"), "parameters"); }

// "23.1 kPa (22.0 to 24.3 kPa)" of a parameter; the value alone without intervals.
std::string interval_of(const Json& result, const std::string& key) {
  const Json& regions = at(at(relaxation_of(result), "uncertainty"), "region");
  const Json& pieces = maybe(regions, key);
  return pieces.size() > 1 ? region_words(pieces, dimension_of_key(key))
                           : interval_words(maybe(parameters_of(result), key), dimension_of_key(key));
}

std::string with_interval(const Json& result, const std::string& key, const std::optional<double>& value) {
  const std::string words = quantity(value, dimension_of_key(key));
  return maybe(parameters_of(result), key).is_null() ? words : words + " (" + interval_of(result, key) + ")";
}

std::string level_in(const Json& result) { return level_words(at(relaxation_of(result), "uncertainty")) + " interval"; }

std::string relaxing_summary(const Json& result) {
  const Json& found = relaxation_of(result);
  std::string summary = "Instantaneous shear modulus " + with_interval(result, "mu_0_Pa", number(found, "mu_0_Pa")) +
                        ", long-term " + with_interval(result, "mu_inf_Pa", number(found, "mu_inf_Pa"));
  if (const auto alpha = number(found, "alpha")) summary += ", alpha " + with_interval(result, "alpha", alpha);
  return summary + fmt::format("; {} of a Prony series{}.",
                               counted(static_cast<long>(number_or(found, "terms", 0)), "term"),
                               yes(found, "converged") ? "" : ", but the fit did not converge");
}

// Moduli, exponents, shares and times, each with its interval.
Table series_table(const Json& result) {
  const Json& found = relaxation_of(result);
  const bool intervals = at(found, "uncertainty").is_object();
  Table table{.caption = "", .rows = {{"", "value"}}, .notes = {}};
  if (intervals) table.rows[0].push_back(level_in(result));
  const auto row = [&](const std::string& name, const std::string& key, const std::optional<double>& value) {
    table.rows.push_back({name, quantity(value, dimension_of_key(key))});
    if (!intervals) return;
    const Json& parameter = maybe(parameters_of(result), key);
    table.rows.back().push_back(parameter.is_null() ? absent : interval_of(result, key));
    if (parameter.is_object() && !yes(parameter, "identifiable")) table.rows.back().back() += ", not identifiable";
  };
  row("mu_0, instantaneous", "mu_0_Pa", number(found, "mu_0_Pa"));
  row("mu_inf, long-term", "mu_inf_Pa", number(found, "mu_inf_Pa"));
  const Json &solid = list(found, "instantaneous"), &series = list(found, "series");
  for (std::size_t k = 0; k < solid.size(); ++k) {
    const std::string name = solid.size() == 1 ? "alpha" : fmt::format("alpha_{}", k + 1);
    row(name, name, number(solid[k], "alpha"));
    if (solid.size() > 1) table.rows.back()[1] += ", with " + pressure(number(solid[k], "mu_Pa")) + " of mu_0";
  }
  for (std::size_t k = 0; k < series.size(); ++k) {
    row(fmt::format("g_{}", k + 1), fmt::format("g_{}", k + 1), number(series[k], "share"));
    row(fmt::format("tau_{}", k + 1), fmt::format("tau_{}_s", k + 1), number(series[k], "time_s"));
  }
  table.notes = {
      "mu(t) = mu_0 (1 - sum g_i (1 - exp(-t/tau_i))), of the deviatoric stress as the solver's target relaxes; mu_0 "
      "is "
      "the small-strain shear modulus at once, mu_inf what is left of it for good."};
  return table;
}

Table rungs_table(const Json& result) {
  Table table{.caption = "",
              .rows = {{"terms", "R2", "objective", "AICc"}},
              .notes = {"No term: the solid that knows no time, on the same rows. AICc: lower is better, the lowest is "
                        "taken as 0."}};
  for (const Json& rung : list(relaxation_of(result), "rungs"))
    table.rows.push_back({number_or(rung, "terms", 0) == 0 ? "none" : shown(number(rung, "terms"), 2),
                          shown(number(rung, "r2")), shown(number(rung, "objective")),
                          shown(number(rung, "aicc_above_lowest"), 3)});
  return table;
}

Section relaxing_result_section(const Json& result) {
  Section section{.id = "result", .title = "What came out", .blocks = {}, .detail = Detail::answer};
  const Json& found = relaxation_of(result);
  add_sentence(section,
               fmt::format("{} in {}, {} residuals; rows {} apart and more, the longest record {}.",
                           counted(static_cast<long>(number_or(result, "points", 0)), "point"),
                           counted(static_cast<long>(list(found, "histories").size()), "test"),
                           text(result, "residual"), quantity(number(found, "shortest_interval_s"), dimension::time, 3),
                           quantity(number(found, "longest_record_s"), dimension::time, 3)));
  add(section, series_table(result));
  return section;
}

Section rungs_section(const Json& result) {
  Section section{.id = "terms", .title = "How many terms", .blocks = {}, .detail = Detail::answer};
  add(section, rungs_table(result));
  return section;
}

ShownUnit unit_of(const Json& histories) {
  double largest = 0;
  for (const Json& history : histories)
    for (const double stress : numbers(at(history, "stress_Pa"))) largest = std::max(largest, std::abs(stress));
  return pressure_unit(largest);
}

Section histories_section(const Json& result) {
  Section section{.id = "histories", .title = "Stress over time", .blocks = {}};
  const Json& histories = list(relaxation_of(result), "histories");
  const ShownUnit unit = unit_of(histories);
  Figure figure;
  figure.name = "stress_over_time";
  figure.chart.title = "Nominal stress over time";
  figure.chart.x.label = "time since rest, s";
  figure.chart.y.label = "nominal stress, " + unit.name;
  int colour = 0;
  for (const Json& history : histories) {
    const auto time = numbers(at(history, "time_s")), stress = numbers(at(history, "stress_Pa")),
               model = numbers(at(history, "model_Pa"));
    const double start = number_or(history, "start_s", 0);
    Series line = series(text(history, "name") + ": model", Mark::line, colour),
           points = series(text(history, "name"), Mark::points, colour++);
    for (std::size_t i = 0; i < time.size() && i < model.size(); ++i) {
      add_point(line, time[i] - start, model[i] / unit.size);
      add_point(points, time[i] - start, stress[i] / unit.size);
    }
    add(figure.chart, line);
    add(figure.chart, points);
  }
  figure.caption = "Measured points and the fitted model's line, each test from rest on.";
  figure.alt =
      fmt::format("Nominal stress over time of {} tests: points and the line of the relaxing solid.", histories.size());
  add(section, figure);
  return section;
}

Section relaxing_minima_section(const Json& result) {
  Section section{.id = "minima", .title = "Every minimum that was found", .blocks = {}};
  Table table{.caption = "",
              .rows = {{"minimum", "mu_0", "mu_inf", "alpha", "shares", "times", "above best"}},
              .notes = {"Starts of the search that came to the same place are one."}};
  int count = 0;
  for (const Json& minimum : list(relaxation_of(result), "minima")) {
    std::string shares, times;
    for (const Json& term : list(minimum, "series")) {
      shares += (shares.empty() ? "" : ", ") + shown(number(term, "share"), 3);
      times += (times.empty() ? "" : ", ") + quantity(number(term, "time_s"), dimension::time, 3);
    }
    table.rows.push_back({std::to_string(++count) + (yes(minimum, "converged") ? "" : ", not converged"),
                          pressure(number(minimum, "mu_0_Pa")), pressure(number(minimum, "mu_inf_Pa")),
                          shown(number(minimum, "alpha")), shares, times,
                          percent(number(minimum, "objective_above_best"), 2)});
  }
  add(section, table);
  return section;
}

Section scene_section(const Json& result) {
  Section section{.id = "scene", .title = "In a scene of percal impact", .blocks = {}, .detail = Detail::answer};
  const std::string scene = text(relaxation_of(result), "scene");
  if (scene.empty()) {
    add_sentence(section, "None: a scene's target is one Ogden term with an alpha that is not 0.");
    return section;
  }
  section.blocks.push_back(
      Code{"mu and alpha of its [target], and its relaxation; target.toml beside the result", scene});
  return section;
}

}  // namespace

bool relaxes(const Json& result) {
  return maybe(result, "relaxation").is_object() && number_or(relaxation_of(result), "terms", 0) > 0;
}

Page relaxation_page(const Json& result, const std::string& title) {
  Page page{.title = title, .summary = relaxing_summary(result), .sections = {}};
  for (auto section :
       {warnings_section, relaxing_result_section, rungs_section, taken_section, findings_section, scene_section,
        histories_section, relaxing_minima_section, sources_section, left_out_points_section, provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal::page_of_fit
