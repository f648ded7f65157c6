#include "percal/study/page/omissions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"

namespace percal {

using namespace page;

namespace {

Json omission_to_json(const AuditedOmission& one) {
  Json json = rung_to_json(one.rung);
  json.update({{"name", one.variant.name},
               {"kind", word(one.variant.kind)},
               {"how", one.variant.how},
               {"is_illustration", one.variant.is_illustration},
               {"change", finite(one.change.share)},
               {"change_standard_error", finite(one.change.standard_error)},
               {"cost_ratio", finite(one.change.cost_ratio)},
               {"effect", word(one.effect)},
               {"verdict", one.verdict}});
  return json;
}

// The scene as it is among the variants, in tables.
Json as_it_is(const Json& result, const std::string& name) {
  Json row = emptied(omission_to_json({}));
  row.update(at(result, "baseline"));
  row.update({{"name", name}, {"cost_ratio", 1}});
  return row;
}

// --- the page -----------------------------------------------------------------------------------------------------

Section conclusions_section(const Json& result) {
  Section section{.id = "conclusions", .title = "Conclusions", .blocks = {}, .detail = Detail::answer};
  add(section, List{texts(at(result, "conclusions")), Tone::plain});
  return section;
}

Figure change_figure(const Json& result) {
  Figure figure;
  figure.name = "changes";
  figure.chart.title = "What each omission is worth";
  figure.chart.x.label = "number in the table";
  figure.chart.y.label = "change of the depth, %";
  struct Drawn {
    Effect effect;
    int colour;
  };
  const Json& omissions = list(result, "omissions");
  for (const auto& [effect, colour] : {Drawn{Effect::clear, 0}, {Effect::possible, 4}, {Effect::none, 1}}) {
    Series drawn = series(word(effect), Mark::points_with_bars, colour);
    for (std::size_t k = 0; k < omissions.size(); ++k) {
      const double change = 100 * number_or(omissions[k], "change", NAN),
                   error = 100 * number_or(omissions[k], "change_standard_error", NAN);
      if (text(omissions[k], "effect") == word(effect))
        add_bar(drawn, static_cast<double>(k + 1), change, change - 2 * error, change + 2 * error);
    }
    add(figure.chart, drawn);
  }
  if (!drawable(figure.chart)) return figure;
  Series zero = series("", Mark::line, -1);
  for (const double k : {0.5, static_cast<double>(omissions.size()) + 0.5}) add_point(zero, k, 0);
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

std::vector<std::string> variant_row(const Json& one, const std::string& number_of_row) {
  const auto words = [&](const char* key) { return text(one, key).empty() ? absent : text(one, key); };
  const bool has_change = number(one, "change").has_value();
  return {text(one, "name") + (yes(one, "is_illustration") ? " (illustration)" : ""),
          number_of_row,
          words("kind"),
          depth_or_outcome(one),
          length(number(one, "depth_spread_m"), 2),
          signed_percent(number(one, "change")),
          percent(number(one, "change_standard_error")),
          words(has_change ? "effect" : "verdict"),
          shown(number(one, "cost_ratio"), 3),
          shown(number(one, "steps"), 5),
          cpu_time(number(one, "cpu_s")),
          words("how")};
}

Section changes_section(const Json& result) {
  Section section{.id = "changes", .title = "Each switched back on, or changed", .blocks = {}};
  add(section, change_figure(result));
  Table table{.caption = "The variants, the largest effect first",
              .rows = {{"variant", "number", "kind", "depth", "spread", "change", "standard error", "effect",
                        "time ratio", "steps", "time of a run", "how"}},
              .notes = {"An illustration's size is not the scene's: it shows what such a thing would be worth."}};
  const Json& omissions = list(result, "omissions");
  table.rows.push_back(variant_row(as_it_is(result, "the scene as it is"), absent));
  for (std::size_t k = 0; k < omissions.size(); ++k)
    table.rows.push_back(variant_row(omissions[k], std::to_string(k + 1)));
  add(section, table);
  List skipped;
  for (const Json& one : list(result, "skipped"))
    skipped.items.push_back("Not run: " + text(one, "name") + ": " + text(one, "why"));
  add(section, skipped);
  return section;
}

Section audited_section(const Json& result) {
  Section section{.id = "left-out", .title = "What was left out, and why", .blocks = {}};
  Table table{.caption = "The program's own list", .rows = {{"what", "why", "audited above as"}}, .notes = {}};
  for (const Json& one : list(result, "left_out")) {
    const auto names = texts(at(one, "audited_by"));
    table.rows.push_back(
        {text(one, "what"), text(one, "why"), names.empty() ? "not: " + text(one, "why_not_audited") : joined(names)});
  }
  add(section, table);
  return section;
}

}  // namespace

Json omissions_to_json(const Scene& scene, const Omissions& audit, const Cost& cost) {
  Json left_out = Json::array(), omissions = Json::array(), skipped = Json::array();
  for (const auto& one : audit.left_out)
    left_out.push_back({{"what", one.left_out.what},
                        {"why", one.left_out.why},
                        {"audited_by", one.audited_by},
                        {"why_not_audited", one.why_not}});
  for (const auto& one : audit.omissions) omissions.push_back(omission_to_json(one));
  for (const auto& one : audit.skipped)
    skipped.push_back({{"name", one.name}, {"kind", word(one.kind)}, {"why", one.why}});
  Json json = study_head(study_kind::omissions, input_of(scene), cost);
  json.update({{"replicates", audit.baseline.replicates},
               {"left_out", left_out},
               {"baseline", rung_to_json(audit.baseline)},
               {"spread_of_a_run", audit.spread_of_a_run},
               {"omissions", omissions},
               {"skipped", skipped},
               {"conclusions", audit.conclusions}});
  return json;
}

std::string omissions_csv(const Json& result) {
  std::vector<ResultColumn> columns{{"name", "name", ResultColumn::free_text}};
  for (const char* key :
       {"kind", "outcome", "depth_m", "depth_spread_m", "depth_standard_error_m", "change", "change_standard_error",
        "effect", "cost_ratio", "replicates", "elements", "steps", "element_steps", "cpu_s"})
    columns.push_back({key, key});
  std::vector<Json> rows{as_it_is(result, "as it is")};
  for (const Json& one : list(result, "omissions")) rows.push_back(one);
  return as_csv(columns, rows);
}

Page omissions_page(const Json& result) {
  const Json &omissions = list(result, "omissions"), &baseline = at(result, "baseline");
  Page page;
  page.title = "What the omissions are worth: " + studied_scene(result);
  const auto clear = std::count_if(omissions.begin(), omissions.end(),
                                   [](const Json& one) { return text(one, "effect") == word(Effect::clear); });
  page.summary = number(baseline, "depth_m") ? fmt::format("Of {} variants {} change the depth of {} clearly.",
                                                           omissions.size(), clear, depth_or_outcome(baseline))
                                             : fmt::format("The scene as it is ends as {}.", text(baseline, "outcome"));
  page.summary +=
      fmt::format(" {} runs each on {} elements per radius; a run scatters by {}.", shown(number(result, "replicates")),
                  shown(number(baseline, "elements_per_radius")), percent(number(result, "spread_of_a_run"), 2));
  for (auto section : {conclusions_section, changes_section, audited_section, provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal
