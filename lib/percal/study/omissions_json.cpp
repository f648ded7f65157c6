#include "percal/study/omissions_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "percal/study/study_json.hpp"

namespace percal {
namespace {

using Json = nlohmann::json;

Json finite(const std::optional<double>& x) { return x && std::isfinite(*x) ? Json(*x) : Json(nullptr); }
std::string cell(const std::optional<double>& x) { return x && std::isfinite(*x) ? fmt::format("{:.9g}", *x) : ""; }

std::string quoted(std::string text) {
  for (std::size_t i = 0; (i = text.find('"', i)) != std::string::npos; i += 2) text.insert(i, 1, '"');
  return '"' + text + '"';
}

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

std::string csv_line(const std::string& name, const std::string& kind, const Rung& rung, const AuditedOmission* one) {
  const auto& p = rung.penetration;
  std::string line = fmt::format("{},{},{},{},{},{}", quoted(name), kind, word(p.outcome), cell(p.depth),
                                 cell(p.spread), cell(p.standard_error));
  line += one ? fmt::format(",{},{},{},{}", cell(one->change.share), cell(one->change.standard_error),
                            word(one->effect), cell(one->change.cost_ratio))
              : ",,,,1";
  return line + fmt::format(",{},{},{:.9g},{:.9g},{:.6g}\n", rung.replicates, rung.elements, rung.steps,
                            rung.element_steps, rung.cpu_seconds);
}

std::string page_line(const std::string& name, const std::string& how, const std::string& verdict, const Rung& rung,
                      double cost_ratio, double radius) {
  const auto& p = rung.penetration;
  const auto radii = [&](const std::optional<double>& x) { return x ? fmt::format("{:.2f}", *x / radius) : "-"; };
  return fmt::format("| {} | {} | {} | {} | {} | {:.2f} | {:.0f} | {:.3g} |\n", name, how,
                     p.depth ? radii(p.depth) : word(p.outcome), radii(p.spread), verdict, cost_ratio, rung.steps,
                     rung.cpu_seconds);
}

}  // namespace

Json omissions_to_json(const Omissions& audit) {
  Json left_out = Json::array(), omissions = Json::array(), skipped = Json::array();
  for (const auto& one : audit.left_out)
    left_out.push_back({{"what", one.left_out.what},
                        {"why", one.left_out.why},
                        {"audited_by", one.audited_by},
                        {"why_not_audited", one.why_not}});
  for (const auto& one : audit.omissions) omissions.push_back(omission_to_json(one));
  for (const auto& one : audit.skipped)
    skipped.push_back({{"name", one.name}, {"kind", word(one.kind)}, {"why", one.why}});
  return {{"left_out", left_out},
          {"baseline", rung_to_json(audit.baseline)},
          {"spread_of_a_run", audit.spread_of_a_run},
          {"omissions", omissions},
          {"skipped", skipped},
          {"conclusions", audit.conclusions}};
}

std::string omissions_csv(const Omissions& audit) {
  std::string csv =
      "name,kind,outcome,depth_m,depth_spread_m,depth_standard_error_m,change,change_standard_error,effect,cost_ratio,"
      "replicates,elements,steps,element_steps,cpu_s\n";
  csv += csv_line("as it is", "", audit.baseline, nullptr);
  for (const auto& one : audit.omissions) csv += csv_line(one.variant.name, word(one.variant.kind), one.rung, &one);
  return csv;
}

std::string omissions_markdown(const Omissions& audit) {
  std::string page =
      "## What the program left out, and why\n\n| what | why | audited below as |\n| --- | --- | --- |\n";
  for (const auto& one : audit.left_out)
    page +=
        fmt::format("| {} | {} | {} |\n", one.left_out.what, one.left_out.why,
                    one.audited_by.empty() ? "-: " + one.why_not : fmt::format("{}", fmt::join(one.audited_by, ", ")));
  page +=
      "\n## Each switched back on, or changed\n\n| what | how | depth, radii | spread | verdict: change of the depth | "
      "time ratio | steps | CPU s a run |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  const double radius = audit.reduction.scales.radius;
  page += page_line("the scene as it is", "", "", audit.baseline, 1, radius);
  for (const auto& one : audit.omissions)
    page += page_line(one.variant.name, one.variant.how, one.verdict, one.rung, one.change.cost_ratio, radius);
  if (!audit.skipped.empty()) page += "\nNot run:\n\n";
  for (const auto& one : audit.skipped) page += fmt::format("- {}: {}\n", one.name, one.why);
  page += "\n## Conclusions\n\n";
  for (const auto& one : audit.conclusions) page += fmt::format("- {}.\n", one);
  return page;
}

}  // namespace percal
