#include "percal/observe/page/depth_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;

Json word_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

// What is in the total as a number, and what is not.
Json sources_to_json(const DepthError& error) {
  Json sources = Json::array();
  for (const ErrorPart& part : error.parts)
    sources.push_back({{"source", word(part.source)},
                       {"half_width_m", finite(part.half_width)},
                       {"by_rule", part.by_rule},
                       {"how", part.how}});
  return sources;
}

Json bias_to_json(const std::optional<ErrorPart>& bias) {
  if (!bias) return nullptr;
  return {{"half_width_m", finite(bias->half_width)}, {"how", bias->how}};
}

}  // namespace

Json depth_error_to_json(const DepthError& error) {
  return {{"level", depth_error_level},
          {"half_width_m", finite(error.half_width())},
          {"belongs_to", word_or_null(error.belongs_to)},
          {"bias", bias_to_json(error.bias)},
          {"sources", sources_to_json(error)}};
}

Json extrapolation_to_json(const std::optional<Extrapolation>& line) {
  if (!line) return nullptr;
  return {{"depth_m", line->depth},
          {"standard_error_m", line->standard_error},
          {"model_error_m", line->model_error},
          {"elements_per_radius", {line->elements_per_radius, line->finer_elements_per_radius}},
          {"mesh_depths_m", {line->mesh_depth, line->finer_depth}},
          {"replicates", line->replicates}};
}

namespace page {
namespace {

// Decimals that show two digits of a number: its smaller parts are to be seen beside it.
int decimals_of(double number) {
  if (!(number > 0)) return 1;
  return std::max(0, 1 - static_cast<int>(std::floor(std::log10(number))));
}

std::string short_name(const std::string& source) {
  return source == word(DepthErrorSource::time_step) ? "step" : source;
}

std::string listed_sources(const Json& error, double unit, int decimals) {
  std::string known, unknown;
  for (const Json& one : list(error, "sources")) {
    const std::string name = short_name(text(one, "source"));
    if (const auto half_width = number(one, "half_width_m"))
      known += fmt::format("{}{} {:.{}f}", known.empty() ? "" : ", ", name, *half_width / unit, decimals);
    else if (name != word(DepthErrorSource::mesh_size) || at(error, "belongs_to").is_null())
      unknown += (unknown.empty() ? "" : " and ") + name;
  }
  return known + (unknown.empty() ? "" : ", " + unknown + " not known");
}

std::optional<double> shown_depth(const Json& result) {
  const Json& line = at(result, "extrapolation");
  return number(line.is_null() ? result : line, "depth_m");
}

}  // namespace

std::string depth_words(const Json& result) {
  const auto depth = shown_depth(result);
  if (!depth) return absent;
  const Json& error = at(result, "depth_error");
  const auto half_width = number(error, "half_width_m");
  if (!half_width) return length(depth);
  const ShownUnit unit = length_unit(*depth);
  const int decimals = decimals_of(*half_width / unit.size);
  std::string words =
      fmt::format("{:.{}f} {} ± {:.{}f} {} (95 %: {}", *depth / unit.size, decimals, unit.name, *half_width / unit.size,
                  decimals, unit.name, listed_sources(error, unit.size, decimals));
  if (!at(error, "belongs_to").is_null()) words += "; belongs to " + text(error, "belongs_to");
  if (const Json& line = at(result, "extrapolation"); !line.is_null()) {
    const auto meshes = numbers(at(line, "elements_per_radius"));
    words += fmt::format("; extrapolated from {:.4g} and {:.4g} elements per radius", meshes[0], meshes[1]);
  }
  return words + ")";
}

std::string bias_words(const Json& result) {
  const Json& bias = at(at(result, "depth_error"), "bias");
  const auto half_width = number(bias.is_null() ? bias : at(bias, "half_width_m"));
  if (!half_width) return "";
  const ShownUnit unit = length_unit(number_or(result, "depth_m", *half_width));
  return fmt::format(
      "Not in this error: the elements' bias, ± {:.2g} {} (95 %) by rule: {}. `--extrapolate` removes it.",
      *half_width / unit.size, unit.name, text(bias, "how"));
}

std::string mesh_depths(const Json& result) {
  const Json& line = at(result, "extrapolation");
  if (line.is_null()) return "";
  const auto meshes = numbers(at(line, "elements_per_radius")), depths = numbers(at(line, "mesh_depths_m"));
  return fmt::format("{} with {:.4g}, {} with {:.4g} elements per radius, {} runs on each", length(depths[0]),
                     meshes[0], length(depths[1]), meshes[1], shown(number(line, "replicates")));
}

bool rules_are_in(const Json& result) {
  return std::ranges::any_of(list(at(result, "depth_error"), "sources"),
                             [](const Json& one) { return yes(one, "by_rule"); });
}

Section depth_error_section(const Json& result) {
  Section section{.id = "errors", .title = "The error of the depth, by source", .blocks = {}};
  const Json& error = at(result, "depth_error");
  Table table{.caption = "", .rows = {{"source", "95 %", "how"}}, .notes = {}};
  for (const Json& one : list(error, "sources"))
    table.rows.push_back({text(one, "source"), length(number(one, "half_width_m"), 3), text(one, "how")});
  if (table.rows.size() == 1) return section;
  table.rows.push_back({"together", length(number(error, "half_width_m"), 3),
                        "root of the sum of squares of what has a number; what has none is not in it"});
  add(section, table);
  return section;
}

}  // namespace page
}  // namespace percal
