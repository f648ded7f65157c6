// The page of `percal identify`.
#include "percal/identify/page/page.hpp"

#include <fmt/core.h>

#include <cmath>

#include "percal/identify/page/parts.hpp"
#include "percal/page/numbers.hpp"

namespace percal {

using namespace page;

namespace {

// Quantities that stand in a result as given and true.
struct BothConventions {
  const char* what;
  const char* key;  // KEY_as_given_Pa, KEY_true_Pa
};
constexpr BothConventions moduli[] = {{"shear modulus at impact rate", "mu_highrate"},
                                      {"shear modulus, quasi-static", "mu_quasistatic"},
                                      {"Young's modulus, quasi-static", "youngs_quasistatic"}};

std::optional<double> as_given(const Json& tissue, const std::string& key) {
  return number(tissue, key + "_as_given_Pa");
}

// Where a result lacks the true value, the other moduli's ratio says it.
std::optional<double> true_value(const Json& tissue, const std::string& key) {
  if (const auto value = number(tissue, key + "_true_Pa")) return value;
  const auto given = as_given(tissue, key), high = number(tissue, "mu_highrate_true_Pa"),
             high_given = as_given(tissue, "mu_highrate");
  return given && high && high_given && *high_given != 0 ? std::optional(*given * *high / *high_given) : std::nullopt;
}

std::string strain_with_error(const Json& tissue) {
  return with_error(shown(number(tissue, "erosion_strain"), 3), shown(number(tissue, "erosion_strain_error"), 2));
}

std::string sphere_words(const Json& sphere) {
  return fmt::format("{} of radius {} at {} m/s", text(sphere, "particle"), length(number(sphere, "radius_m")),
                     shown(number(sphere, "speed_m_s")));
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
      "{}: shear modulus at impact rate {} as given ({}), {} true; quasi-static Young's modulus {} as given, {} true; "
      "erosion strain {} ({}) at alpha {}.",
      text(tissue, "name"), pressure(as_given(tissue, "mu_highrate"), 3), text(tissue, "convention"),
      pressure(true_value(tissue, "mu_highrate"), 3), pressure(as_given(tissue, "youngs_quasistatic"), 3),
      pressure(true_value(tissue, "youngs_quasistatic"), 3), strain_with_error(tissue), text(tissue, "strain_measure"),
      shown(number(tissue, "alpha")));
}

Section asked_section(const Json& result) {
  Section section{.id = "asked", .title = "What was asked", .blocks = {}};
  const Json &tissue = at(result, "skin"), &calibration = at(result, "calibration"), &model = at(result, "model");
  if (calibration.is_object())
    add_sentence(section, fmt::format("Which material is {}, in which {} goes {} deep{}?", text(tissue, "name"),
                                      sphere_words(calibration), length(number(calibration, "penetration_m")),
                                      number(calibration, "penetration_standard_error_m")
                                          ? fmt::format(" (standard error {})",
                                                        length(number(calibration, "penetration_standard_error_m")))
                                          : ""));
  if (model.is_object())
    add_sentence(section,
                 fmt::format("Its modulus is taken from the formulation of {} in which {} goes as deep as in the "
                             "system that is similar to this shot.",
                             text(model, "material"), sphere_words(model)));
  add_sentence(section, fmt::format("Moduli are given as {}, erosion strains as {} strain.", text(tissue, "convention"),
                                    text(tissue, "strain_measure")));
  return section;
}

Section answer_section(const Json& result) {
  Section section{.id = "answer", .title = "What came out", .blocks = {}};
  const Json &tissue = at(result, "skin"), &alpha = at(result, "alpha"), &similar = at(result, "similarity");
  Table table{.caption = text(tissue, "name"), .rows = {}, .notes = {}};
  table.rows.push_back({"", "as given (" + text(tissue, "convention") + ")", "true", "error"});
  const std::string error = "\u00b1 " + percent(modulus_error(result));
  for (const auto& [what, key] : moduli)
    table.rows.push_back({what, pressure(as_given(tissue, key)), pressure(true_value(tissue, key)),
                          modulus_error(result) ? error : "-"});
  const std::string strain_error = shown(number(tissue, "erosion_strain_error"), 2);
  table.rows.push_back({"erosion strain (" + text(tissue, "strain_measure") + ")",
                        shown(number(tissue, "erosion_strain"), 3), "",
                        strain_error == "-" ? "-" : "\u00b1 " + strain_error});
  const auto from = number(alpha, "indistinguishable_from"), to = number(alpha, "indistinguishable_to");
  table.rows.push_back({"alpha, " + text(alpha, "from"), shown(number(alpha, "value")), "",
                        from && to ? fmt::format("{} to {} no worse", shown(from), shown(to)) : "-"});
  table.notes.push_back(fmt::format(
      "The moduli's error is the choice of one formulation, whose depth lies {} from the similar one, over the "
      "ridge's slope; rate factors, densities and the mesh are not in it. The erosion strain's is the ridge's.",
      signed_percent(number(similar, "formulation_mismatch"))));
  add(section, std::move(table));

  Table means{.caption = "How deep percal's predictions lie, in the mean",
              .rows = {{"shots", "target density, kg/m3", "from the measured depths", "from the reference's"}},
              .notes = {}};
  for (const Json& one : list(result, "prediction_means"))
    means.rows.push_back({text(one, "system"), shown(number(one, "target_density_kg_m3")),
                          percent(number(one, "mean_deviation_from_measured")),
                          percent(number(one, "mean_deviation_from_thesis_fe"))});
  means.notes.push_back("Mean size of the deviations, over the shots that stopped in the layer.");
  add(section, std::move(means));
  return section;
}

Section tables_section(const Json& result, const std::string& key, const std::string& id, const std::string& title) {
  Section section{.id = id, .title = title, .blocks = {}};
  for (const Json& table : list(result, key)) add(section, comparison_table(table));
  return section;
}

Section card_section(const Json& result) {
  Section section{.id = "card", .title = "The material card", .blocks = {}};
  if (list(result, "cards").empty()) return section;
  const Json& card = list(result, "cards").front();
  Table table{.caption = text(card, "name"), .rows = {{"", ""}}, .notes = {}};
  table.rows.push_back({"density", shown(number(card, "density_kg_m3")) + " kg/m3"});
  if (const auto mu = number(card, "mu_true_Pa")) table.rows.push_back({"mu, true", pressure(mu)});
  if (const auto alpha = number(card, "alpha")) table.rows.push_back({"alpha", shown(alpha)});
  table.rows.push_back({"bulk modulus", pressure(number(card, "bulk_modulus_Pa"))});
  const Json& erosion = at(card, "erosion");
  if (erosion.is_object())
    table.rows.push_back({"erosion strain (" + text(erosion, "measure") + ")", shown(number(erosion, "strain"))});
  table.notes.push_back("percal card write turns this result into a card of any of its solvers.");
  for (const std::string& comment : texts(at(card, "comments"))) table.notes.push_back(comment);
  add(section, std::move(table));
  return section;
}

}  // namespace

page::Page identify_page(const page::Json& result) {
  Page page{.title = text(result, "title"), .summary = summary_of(result), .sections = {}};
  add(page, asked_section(result));
  add(page, answer_section(result));
  add(page, findings_section(result));
  add(page, ridge_section(result));
  add(page, alpha_section(result));
  add(page, law_section(result));
  add(page, depths_section(result));
  add(page, model_section(result));
  add(page, scaled_section(result));
  add(page, trends_section(result));
  add(page, mesh_section(result));
  add(page, tables_section(result, "steps", "steps", "The chain, step by step"));
  add(page, tables_section(result, "tables", "tables", "Published tables, computed again"));
  add(page, left_out_section(result));
  add(page, card_section(result));
  add(page, provenance_section(result));
  add(page, input_section(result));
  return page;
}

}  // namespace percal
