// What was asked of a fit, and what was read for it.
#include <fmt/core.h>

#include "percal/fit/page/fit_json.hpp"
#include "percal/fit/read/curve_measures.hpp"
#include "percal/fit/shape/peaks.hpp"
#include "percal/text/sha256.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;

// As the command line says it.
std::string words_of(const Weighting& weighting) {
  const auto* tests = std::get_if<EqualTests>(&weighting);
  if (!tests) return "points";
  std::string text;
  for (const auto& [name, share] : tests->of_test)
    text += fmt::format("{}{}={:g}", text.empty() ? "" : ",", name, share);
  return text.empty() ? "tests" : text;
}

Json to_json(const Specimen& specimen) {
  if (!specimen.gauge_length && !specimen.area) return nullptr;
  return {{"gauge_length_m", finite(specimen.gauge_length)}, {"area_m2", finite(specimen.area)}};
}

Json to_json(const std::optional<TimesWanted>& times) {
  if (!times) return nullptr;
  return {{"column", times->column}, {"rate_1_s", finite(times->rate)}, {"rate_of_1_s", times->rate_of}};
}

Json input_of(const FitRequest& request) {
  const CurveColumns& columns = request.columns;
  const CurveOptions& options = request.options;
  const auto& intervals = request.intervals;
  return {{"files", request.files},
          {"mode", columns.mode},
          {"mode_of", columns.mode_of},
          {"model", word(options.model)},
          {"residual", word(options.residual)},
          {"weights", words_of(options.weighting)},
          {"loss", word(options.loss)},
          {"unconstrained", options.signs == Signs::free},
          {"compare", request.compare},
          {"stable", fmt::format("{:g}:{:g}", request.stretches.low, request.stretches.high)},
          {"x", columns.x},
          {"y", columns.y},
          {"error", columns.error},
          {"where", columns.where},
          {"specimen", to_json(columns.specimen)},
          {"branch", word(columns.rows.branch)},
          {"until", columns.rows.until == CurveEnd::peak ? "peak" : ""},
          {"without", columns.rows.holds == Holds::left_out ? "holds" : ""},
          {"relaxation", request.relaxation ? word(*request.relaxation) : ""},
          {"times", to_json(columns.times)},
          {"intervals", intervals.has_value()},
          {"level", intervals ? Json(intervals->level) : Json(nullptr)},
          {"bootstrap", intervals ? Json(intervals->bootstrap) : Json(nullptr)},
          {"rate_factor", request.rate_column.has_value()},
          {"rate_column", request.rate_column.value_or("")}};
}

Json to_json(const std::vector<CurvePeak>& peaks) {
  Json all = Json::array();
  for (const CurvePeak& peak : peaks)
    all.push_back({{"test", peak.test},
                   {"amount", peak.amount},
                   {"stress_Pa", peak.stress},
                   {"erosion_strain", peak.erosion_strain},
                   {"fallen_to", peak.fallen_to},
                   {"end", word(peak.end)},
                   {"rows_behind", peak.rows_behind}});
  return all;
}

Json to_json(const std::vector<CurveHold>& holds) {
  Json all = Json::array();
  for (const CurveHold& hold : holds)
    all.push_back({{"test", hold.test},
                   {"amount", hold.amount},
                   {"stress_before_Pa", hold.stress_before},
                   {"stress_after_Pa", hold.stress_after},
                   {"relaxed_to", hold.stress_after / hold.stress_before},
                   {"rows", hold.rows}});
  return all;
}

Json to_json(const CurveSource& source) {
  const auto digest = sha256_of_file(source.file);
  return {{"file", source.file},
          {"sha256", digest ? Json(*digest) : Json(nullptr)},
          {"x", source.x},
          {"y", source.y},
          {"error", source.error.empty() ? Json(nullptr) : Json(source.error)},
          {"stress", word(source.stress)},
          {"points", source.points},
          {"specimen", to_json(source.specimen)},
          {"peaks", to_json(source.peaks)},
          {"holds", to_json(source.holds)},
          {"taken", source.taken}};
}

}  // namespace

Json read_to_json(const FitRequest& request, const std::vector<CurveSource>& sources) {
  Json result = page::result_head("fit", input_of(request));
  result["sources"] = Json::array();
  result["warnings"] = Json::array();
  for (const CurveSource& source : sources) {
    result["sources"].push_back(to_json(source));
    for (const auto& sentence : source.warnings) result["warnings"].push_back(sentence);
  }
  return result;
}

}  // namespace percal
