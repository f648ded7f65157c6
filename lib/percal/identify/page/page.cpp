// The page of `percal identify`.
#include "percal/identify/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/card/card_json.hpp"
#include "percal/identify/page/identification_json.hpp"
#include "percal/identify/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal {

using namespace page_of_identify;

namespace {

std::string strain_with_error(const Json& tissue) {
  return with_error(shown(number(tissue, "erosion_strain"), 3), shown(number(tissue, "erosion_strain_error"), 2));
}

// What the choice of one formulation is worth in the modulus: its mismatch in depth over the ridge's slope.
std::optional<double> modulus_error(const Json& result) {
  const auto mismatch = number(at(result, "similarity"), "formulation_mismatch");
  const auto strain = number(at(result, "skin"), "erosion_strain");
  std::optional<double> slope;
  double nearest = HUGE_VAL;
  for (const Json& point : list(result, "ridge")) {
    const auto at_strain = number(point, "erosion_strain"), at_slope = number(point, "dlnP_dlnmu");
    if (!strain || !at_strain || !at_slope || std::abs(*at_strain - *strain) >= nearest) continue;
    nearest = std::abs(*at_strain - *strain);
    slope = at_slope;
  }
  return mismatch && slope && *slope != 0 ? std::optional(std::abs(*mismatch / *slope)) : std::nullopt;
}

std::string summary_of(const Json& result) {
  const Json& tissue = at(result, "skin");
  if (!yes(result, "complete")) return "The ridge does not reach the modulus that the model material gives.";
  return fmt::format(
      "{}: shear modulus {} at impact rate, Young's modulus {} quasi-static, both true; erosion strain "
      "{} ({}) at alpha {}.",
      text(tissue, "name"), pressure(number(tissue, "mu_highrate_true_Pa"), 3),
      pressure(number(tissue, "youngs_quasistatic_true_Pa"), 3), strain_with_error(tissue),
      text(tissue, "strain_measure"), shown(number(tissue, "alpha")));
}

Section asked_section(const Json& result) {
  Section section{.id = "asked", .title = "What was asked", .blocks = {}, .detail = Detail::answer};
  const Json &tissue = at(result, "skin"), &calibration = at(result, "calibration");
  const auto error = number(calibration, "penetration_standard_error_m");
  add_sentence(section, fmt::format("Which material is {}, in which {} goes {} deep{}?", text(tissue, "name"),
                                    sphere_words(calibration), length(number(calibration, "penetration_m")),
                                    error ? " (standard error " + length(error) + ")" : ""));
  return section;
}

Table tissue_table(const Json& result) {
  const Json &tissue = at(result, "skin"), &alpha = at(result, "alpha");
  Table table{.caption = fmt::format("{}; moduli as given: {}; erosion strain: {}", text(tissue, "name"),
                                     text(tissue, "convention"), text(tissue, "strain_measure")),
              .rows = {{"", "as given", "true", "error"}},
              .notes = {}};
  const auto plus_minus = [](const std::string& error) { return error == absent ? absent : "\u00b1 " + error; };
  const std::string error = plus_minus(percent(modulus_error(result)));
  const auto modulus = [&](const char* what, const char* as_given, const char* as_true) {
    table.rows.push_back({what, pressure(number(tissue, as_given)), pressure(number(tissue, as_true)), error});
  };
  modulus("shear modulus at impact rate", "mu_highrate_as_given_Pa", "mu_highrate_true_Pa");
  modulus("shear modulus, quasi-static", "mu_quasistatic_as_given_Pa", "mu_quasistatic_true_Pa");
  modulus("Young's modulus, quasi-static", "youngs_quasistatic_as_given_Pa", "youngs_quasistatic_true_Pa");
  table.rows.push_back({"erosion strain", shown(number(tissue, "erosion_strain"), 3), "",
                        plus_minus(shown(number(tissue, "erosion_strain_error"), 2))});
  const auto from = number(alpha, "indistinguishable_from"), to = number(alpha, "indistinguishable_to");
  table.rows.push_back({"alpha, " + text(alpha, "from"), shown(number(alpha, "value")), "",
                        from && to ? fmt::format("{} to {} no worse", shown(from), shown(to)) : absent});
  table.notes.push_back(fmt::format(
      "The moduli's error is the choice of one formulation, whose depth lies {} from the similar one, over the "
      "ridge's slope; rate factors, densities and the mesh are not in it. The erosion strain's is the ridge's.",
      signed_percent(number(at(result, "similarity"), "formulation_mismatch"))));
  return table;
}

Table means_table(const Json& result) {
  Table means{.caption = "How far percal's depths lie from others, in the mean",
              .rows = {{"shots", "target, kg/m3", "from the measured", "from the reference's"}},
              .notes = {}};
  for (const Json& one : list(result, "prediction_means"))
    means.rows.push_back({text(one, "system"), shown(number(one, "target_density_kg_m3")),
                          percent(number(one, "mean_deviation_from_measured")),
                          percent(number(one, "mean_deviation_from_thesis_fe"))});
  means.notes.push_back("Mean size of the deviations, over the shots that stopped in the layer.");
  return means;
}

Section answer_section(const Json& result) {
  Section section{.id = "answer", .title = "What came out", .blocks = {}, .detail = Detail::answer};
  add(section, tissue_table(result));
  add(section, ridge_table(result));
  add(section, means_table(result));
  add_sentence(section,
               yes(result, "complete")
                   ? "percal card write makes a card of it for any solver; those for LS-DYNA and Abaqus go beside "
                     "the result."
                   : "Erosion strains further apart ([ridge] erosion_strains) would let the ridge reach it.");
  return section;
}

Section tables_section(const Json& result, const std::string& key, const std::string& id, const std::string& title) {
  Section section{.id = id, .title = title, .blocks = {}};
  for (const Json& comparison : list(result, key)) add(section, comparison_table(comparison));
  return section;
}

Section card_section(const Json& result) {
  Section section{.id = "card", .title = "The material card", .blocks = {}};
  if (list(result, "cards").empty()) return section;
  const CardMaterial card = card_from_json(list(result, "cards").front(), {.file = "", .line = 0, .key = "cards[0]"});
  Table table{.caption = card.name, .rows = {{"", ""}}, .notes = {}};
  table.rows.push_back({"density", shown(card.density) + " kg/m3"});
  for (const Ogden& term : card.terms) {
    table.rows.push_back({"mu, true", pressure(term.mu)});
    table.rows.push_back({"alpha", shown(term.alpha)});
  }
  table.rows.push_back({"bulk modulus", pressure(card.bulk_modulus)});
  if (card.erosion)
    table.rows.push_back({"erosion strain (" + word(card.erosion->measure) + ")", shown(card.erosion->limit)});
  table.notes = card.comments;
  add(section, std::move(table));
  return section;
}

}  // namespace

Table comparison_table(const Json& comparison) {
  const Json& rows = list(comparison, "rows");
  const bool remarks =
      std::any_of(rows.begin(), rows.end(), [](const Json& row) { return !text(row, "remark").empty(); });
  Table table{.caption = text(comparison, "name"), .rows = {}, .notes = {}};
  table.rows.push_back({"", "unit", text(comparison, "reference"), "percal", "difference", "error"});
  if (remarks) table.rows.back().push_back("remark");
  for (const Json& row : rows) {
    const std::string unit = text(row, "unit");
    const int digits = static_cast<int>(number_or(row, "digits", 4));
    table.rows.push_back({text(row, "what"), unit.empty() ? absent : unit, shown(number(row, "reference"), digits),
                          shown(number(row, "ours"), digits), signed_percent(number(row, "difference")),
                          shown(number(row, "error"), 2)});
    if (remarks) table.rows.back().push_back(text(row, "remark"));
  }
  if (const std::string note = text(comparison, "note"); !note.empty()) table.notes.push_back(note);
  if (const auto mean = number(comparison, "mean_difference"); mean && rows.size() > 1)
    table.notes.push_back("mean size of the differences " + percent(mean));
  return table;
}

Page identify_page(const Json& result) {
  Page page{.title = text(result, "title"), .summary = summary_of(result), .sections = {}};
  for (auto section : {asked_section, answer_section, findings_section, ridge_section, alpha_section, law_section,
                       depths_section, model_section, scaled_section, trends_section, mesh_section})
    add(page, section(result));
  add(page, tables_section(result, "steps", "steps", "The chain, step by step"));
  add(page, tables_section(result, "tables", "tables", "Published tables, computed again"));
  for (auto section : {left_out_section, card_section, provenance_section, input_section}) add(page, section(result));
  return page;
}

}  // namespace percal
