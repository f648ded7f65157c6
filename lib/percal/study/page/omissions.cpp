// The page of `percal study SCENE --omissions`.
#include <fmt/core.h>

#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/study/page/parts.hpp"

namespace percal::page {
namespace {

Section left_out_audited(const Json& result) {
  Section section{.id = "left-out", .title = "What was left out, and why", .blocks = {}};
  Table table{.caption = "The program's own list", .rows = {{"what", "why", "audited below as"}}, .notes = {}};
  for (const Json& one : list(result, "left_out")) {
    std::string names;
    for (const std::string& name : texts(at(one, "audited_by"))) names += (names.empty() ? "" : ", ") + name;
    table.rows.push_back(
        {text(one, "what"), text(one, "why"), names.empty() ? "not: " + text(one, "why_not_audited") : names});
  }
  add(section, table);
  return section;
}

Figure change_figure(const Json& result) {
  Figure figure;
  figure.name = "changes";
  figure.chart.title = "What each omission is worth";
  figure.chart.x.label = "number in the table";
  figure.chart.y.label = "change of the depth, %";
  struct Effect {
    const char* key;
    Series drawn;
  };
  Effect effects[] = {{"clear", series("clear", Mark::points_with_bars, 0)},
                      {"possible", series("possible", Mark::points_with_bars, 4)},
                      {"none", series("none", Mark::points_with_bars, 1)}};
  const Json& omissions = list(result, "omissions");
  for (std::size_t k = 0; k < omissions.size(); ++k) {
    const double change = 100 * number_or(omissions[k], "change", NAN),
                 error = 100 * number_or(omissions[k], "change_standard_error", NAN);
    for (Effect& effect : effects)
      if (text(omissions[k], "effect") == effect.key)
        add_bar(effect.drawn, static_cast<double>(k + 1), change, change - 2 * error, change + 2 * error);
  }
  for (const Effect& effect : effects) add(figure.chart, effect.drawn);
  if (!drawable(figure.chart)) return figure;
  Series zero = series("", Mark::line, -1);
  zero.x = {0.5, static_cast<double>(omissions.size()) + 0.5};
  zero.y = {0, 0};
  add(figure.chart, zero);
  figure.chart.x.low = zero.x[0];
  figure.chart.x.high = zero.x[1];
  figure.caption =
      "Bars are two standard errors of the difference of two means. None: below two standard errors; possible: "
      "below three, which chance reaches once or twice among so many.";
  figure.alt =
      fmt::format("Changes of the depth by {} variants with their errors. {}", omissions.size(), figure.caption);
  return figure;
}

Section changes_section(const Json& result) {
  Section section{.id = "changes", .title = "Each switched back on, or changed", .blocks = {}};
  add(section, change_figure(result));
  Table table{.caption = "The variants, the largest effect first",
              .rows = {{"variant", "number", "kind", "depth", "spread", "change", "standard error", "effect",
                        "time ratio", "how"}},
              .notes = {}};
  const Json &baseline = at(result, "baseline"), &omissions = list(result, "omissions");
  const auto depth = [](const Json& rung) {
    return number(rung, "depth_m") ? length(number(rung, "depth_m")) : text(rung, "outcome");
  };
  table.rows.push_back({"the scene as it is", "-", "-", depth(baseline), length(number(baseline, "depth_spread_m"), 2),
                        "-", "-", "-", "1", "-"});
  for (std::size_t k = 0; k < omissions.size(); ++k) {
    const Json& one = omissions[k];
    table.rows.push_back({text(one, "name") + (yes(one, "is_illustration") ? " (illustration)" : ""),
                          std::to_string(k + 1), text(one, "kind"), depth(one),
                          length(number(one, "depth_spread_m"), 2), signed_percent(number(one, "change"), 1),
                          percent(number(one, "change_standard_error"), 1), text(one, "effect"),
                          shown(number(one, "cost_ratio"), 3), text(one, "how")});
  }
  table.notes = {"An illustration's size is not the scene's: it shows what such a thing would be worth."};
  add(section, table);
  List skipped;
  for (const Json& one : list(result, "skipped"))
    skipped.items.push_back("Not run: " + text(one, "name") + ": " + text(one, "why"));
  if (!skipped.items.empty()) section.blocks.push_back(skipped);
  return section;
}

Section conclusions_section(const Json& result) {
  Section section{.id = "conclusions", .title = "Conclusions", .blocks = {}};
  if (const auto lines = texts(at(result, "conclusions")); !lines.empty()) section.blocks.push_back(List{lines});
  return section;
}

}  // namespace

Page omissions_page(const Json& result) {
  Page page;
  page.title = "What the omissions are worth: " + scene_words(result);
  int clear = 0;
  for (const Json& one : list(result, "omissions")) clear += text(one, "effect") == "clear";
  page.summary = fmt::format("Of {} variants {} change the depth of {} clearly. {} runs each; a run scatters by {}.",
                             list(result, "omissions").size(), clear, length(number(at(result, "baseline"), "depth_m")),
                             shown(number(result, "replicates")), percent(number(result, "spread_of_a_run"), 2));
  for (auto section : {conclusions_section, changes_section, left_out_audited, provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal::page
