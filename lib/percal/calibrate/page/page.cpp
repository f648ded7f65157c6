// The page of `percal calibrate`.
#include "percal/calibrate/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/calibrate/page/parts.hpp"
#include "percal/page/numbers.hpp"

namespace percal {

using namespace page;

namespace {

// The materials' moduli of a hypothesis that the data speak of: quasi-static where a rate factor is known.
struct MainModulus {
  std::string words;
  const Json* estimate;
};
std::vector<MainModulus> main_moduli(const Json& hypothesis) {
  std::vector<MainModulus> all;
  for (const Json& one : list(hypothesis, "moduli")) {
    const Json& youngs = at(one, "youngs_quasi_static_true");
    if (youngs.is_object()) all.push_back({"quasi-static E of " + text(one, "material"), &youngs});
  }
  if (all.empty())
    for (const Json& one : list(hypothesis, "moduli")) {
      all.push_back({"mu of " + text(one, "material"), &at(one, "mu_true")});
      break;
    }
  return all;
}

std::string summary_of(const Json& result) {
  const Json& hypotheses = list(result, "hypotheses");
  if (hypotheses.empty()) return "No hypothesis could be fitted.";
  std::string summary;
  for (const MainModulus& modulus : main_moduli(hypotheses.front()))
    summary += fmt::format("{}{} {} ({})", summary.empty() ? "" : "; ", modulus.words,
                           value_words(*modulus.estimate, "value"), interval_words(*modulus.estimate, "interval"));
  return fmt::format("{}: true moduli with {} intervals, by the hypothesis \"{}\"{}.", summary, level_words(result),
                     text(hypotheses.front(), "name"),
                     hypotheses.size() > 1 ? fmt::format(", the first of {}", hypotheses.size()) : "");
}

Section asked_section(const Json& result) {
  Section section{.id = "asked", .title = "What was asked", .blocks = {}};
  const Json& data = at(result, "data");
  const Json &shots = list(data, "shots"), &curves = list(data, "curves");
  const auto used = std::count_if(shots.begin(), shots.end(), [](const Json& shot) { return yes(shot, "used"); });
  std::string synthetic;
  for (const Json& curve : curves)
    if (yes(curve, "synthetic")) synthetic += (synthetic.empty() ? "" : ", ") + text(curve, "name");
  add_sentence(section,
               fmt::format("Which material gives these {} depths ({} of them fitted) and {} curves{}?", shots.size(),
                           used, curves.size(), synthetic.empty() ? "" : " (synthetic: " + synthetic + ")"));
  Table parameters{.caption = "What was looked for",
                   .rows = {{"parameter", "kind", "searched from", "to", "expected beforehand"}},
                   .notes = {}};
  for (const Json& one : list(data, "parameters")) {
    const std::string prior = value_words(one, "prior");
    parameters.rows.push_back(
        {text(one, "name"), text(one, "kind"), value_words(one, "low"), value_words(one, "high"), prior});
  }
  add(section, std::move(parameters));
  Table hypotheses{.caption = "How the data were read",
                   .rows = {{"", "hypothesis", "mu means", "contact stiffness", "held"}},
                   .notes = {}};
  int n = 0;
  for (const Json& one : list(result, "hypotheses")) {
    std::string held;
    for (const Json& value : list(one, "held"))
      held += fmt::format("{}{} = {}", held.empty() ? "" : ", ", text(value, "name"), value_words(value, "value"));
    hypotheses.rows.push_back({shown(++n), text(one, "name"), text(one, "convention"),
                               shown(number(one, "contact_stiffness")), held.empty() ? "-" : held});
  }
  add(section, std::move(hypotheses));
  return section;
}

// "478 kPa (106 kPa to above 1.92 MPa)" of an estimate; "-" of none.
std::string estimate_words(const Json& estimate) {
  if (!estimate.is_object()) return "-";
  const std::string value = value_words(estimate, "value"), interval = interval_words(estimate, "interval");
  return interval == "-" ? value : fmt::format("{} ({})", value, interval);
}

// One material after the other, every hypothesis beside the others. `first` and `second`: keys of a modulus true and as MU1.
Table modulus_table(const Json& result, const std::string& caption, const std::vector<std::string>& header,
                    const std::string& first, const std::string& second) {
  Table table{.caption = caption, .rows = {header}, .notes = {}};
  std::vector<std::string> materials;
  for (const Json& hypothesis : list(result, "hypotheses"))
    for (const Json& one : list(hypothesis, "moduli"))
      if (std::find(materials.begin(), materials.end(), text(one, "material")) == materials.end())
        materials.push_back(text(one, "material"));
  for (const std::string& material : materials) {
    int n = 0;
    for (const Json& hypothesis : list(result, "hypotheses")) {
      ++n;
      for (const Json& one : list(hypothesis, "moduli"))
        if (text(one, "material") == material && at(one, first).is_object())
          table.rows.push_back({material, shown(n), estimate_words(at(one, first)), estimate_words(at(one, second)),
                                value_words(one, "curve_mu_true")});
    }
  }
  return table;
}

Section answer_section(const Json& result) {
  Section section{.id = "answer", .title = "What came out", .blocks = {}};
  Table rate = modulus_table(result, "Shear modulus at impact rate, with its " + level_words(result) + " interval",
                             {"material", "hypothesis", "true", "as LS-DYNA's MU1 = 2 mu/alpha", "its curve's, true"},
                             "mu_true", "mu_over_alpha");
  rate.notes.push_back(
      "\"below\" and \"above\": the interval is cut off by a bound of the search, the data say nothing there.");
  add(section, std::move(rate));
  Table youngs = modulus_table(result, "Young's modulus, quasi-static, with its " + level_words(result) + " interval",
                               {"material", "hypothesis", "true: 3 mu", "3 MU1"}, "youngs_quasi_static_true",
                               "youngs_quasi_static_over_alpha");
  for (auto& row : youngs.rows) row.resize(4);
  add(section, std::move(youngs));
  return section;
}

}  // namespace

page::Page calibrate_page(const page::Json& result) {
  Page page{.title = text(result, "title"), .summary = summary_of(result), .sections = {}};
  add(page, asked_section(result));
  add(page, answer_section(result));
  add(page, findings_section(result));
  add(page, ridges_section(result));
  add(page, impact_parameter_section(result));
  add(page, predictions_section(result));
  int n = 0;
  for (const Json& hypothesis : list(result, "hypotheses")) {
    ++n;
    add(page, hypothesis_section(result, hypothesis, n));
  }
  add(page, emulators_section(result));
  add(page, provenance_section(result));
  add(page, input_section(result));
  return page;
}

}  // namespace percal
