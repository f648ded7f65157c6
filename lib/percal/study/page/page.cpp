#include "percal/study/page/page.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "percal/base/error.hpp"
#include "percal/observe/page/scene_words.hpp"
#include "percal/page/numbers.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/study/page/error_vs_time.hpp"
#include "percal/study/page/extremes.hpp"
#include "percal/study/page/omissions.hpp"
#include "percal/units/words.hpp"

namespace percal {

using page::Json;

page::Page study_page(const Json& result) {
  const std::string kind = page::text(result, "study");
  if (kind == study_kind::error_vs_time) return error_vs_time_page(result);
  if (kind == study_kind::omissions) return omissions_page(result);
  if (kind == study_kind::extremes) return extremes_page(result);
  throw BadInput(Place{.file = "", .line = 0, .key = "study"}, in_quotes(kind),
                 listed({study_kind::error_vs_time, study_kind::omissions, study_kind::extremes}));
}

Json study_head(const std::string& kind, const Json& input, const page::Cost& cost) {
  Json head = page::result_head("study", input);
  head.update({{"study", kind}, {"cost", page::cost_to_json(cost)}});
  return head;
}

Json input_of(const Scene& scene) { return {{"scene", scene.source}, {"toml", scene_to_toml(scene, "")}}; }

Json rung_to_json(const Rung& rung) {
  const auto& p = rung.penetration;
  Json outcomes = Json::array();
  for (const Outcome outcome : p.outcomes) outcomes.push_back(word(outcome));
  return {{"elements_per_radius", rung.elements_per_radius},
          {"elements", rung.elements},
          {"time_step_factor", rung.time_step_factor},
          {"arithmetic", rung.arithmetic == Arithmetic::single_precision ? "single" : "double"},
          {"replicates", rung.replicates},
          {"outcome", word(p.outcome)},
          {"outcomes", outcomes},
          {"depth_m", page::finite(p.depth)},
          {"depth_spread_m", page::finite(p.spread)},
          {"depth_standard_error_m", page::finite(p.standard_error)},
          {"depth_at_least_m", page::finite(p.at_least)},
          {"steps", rung.steps},
          {"element_steps", rung.element_steps},
          {"cpu_s", rung.cpu_seconds}};
}

Json emptied(Json object) {
  for (Json& value : object) value = nullptr;
  return object;
}

std::string studied_scene(const Json& result) {
  const Json& input = page::at(result, "input");
  const std::string pair = page::scene_title(page::text(input, "toml"));
  const std::string file = std::filesystem::path(page::text(input, "scene")).filename().string();
  return pair.empty() ? file : pair + " (" + file + ")";
}

std::string cpu_time(const std::optional<double>& seconds) {
  if (!seconds) return page::absent;
  return *seconds >= 1000 ? fmt::format("{:.0f} s", *seconds) : page::shown(seconds, 3) + " s";
}

std::string depth_or_outcome(const Json& rung) {
  const auto depth = page::number(rung, "depth_m");
  return depth ? page::length(depth) : page::text(rung, "outcome");
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  return fmt::format("{}", fmt::join(words, between));
}

}  // namespace percal
