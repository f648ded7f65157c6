// The materials' moduli in both conventions, where their errors come from, and what to measure to make these smaller.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "percal/calibrate/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::calibration_page {
namespace {

Json estimate_to_json(const std::optional<Estimate>& estimate) {
  if (!estimate) return nullptr;
  return {{"value_Pa", finite(estimate->value)}, {"interval_Pa", interval_to_json(estimate->interval)}};
}

Json budget_to_json(const ErrorBudget& budget) {
  Json sources = Json::array();
  for (const ErrorShare& source : budget.sources)
    sources.push_back({{"name", source.name},
                       {"standard_deviation", finite(source.standard_deviation)},
                       {"share", finite(source.share)}});
  const bool known = !budget.most_influential.empty();
  return {{"quantity", budget.quantity},
          {"total", estimate_to_json(budget.total)},
          {"standard_deviation", finite(budget.standard_deviation)},
          {"sources", sources},
          {"most_influential", known ? Json(budget.most_influential) : Json()},
          {"influence", known ? finite(budget.influence) : Json()}};
}

}  // namespace

Json moduli_to_json(const HypothesisResult& result) {
  Json moduli = Json::array(), budgets = Json::array(), advice = Json::array();
  for (const MaterialModuli& one : result.moduli)
    moduli.push_back({{"material", one.material},
                      {"mu_true", estimate_to_json(one.mu_true)},
                      {"mu_over_alpha", estimate_to_json(one.mu_over_alpha)},
                      {"youngs_quasi_static_true", estimate_to_json(one.youngs_quasi_static_true)},
                      {"youngs_quasi_static_over_alpha", estimate_to_json(one.youngs_quasi_static_over_alpha)},
                      {"curve_mu_true_Pa", finite(one.curve_modulus)}});
  for (const ErrorBudget& budget : result.budgets) budgets.push_back(budget_to_json(budget));
  for (const Advice& one : result.advice)
    advice.push_back({{"measurement", one.label}, {"interval_width_ratio", finite(one.width_ratio)}});
  return {{"moduli", moduli}, {"error_budgets", budgets}, {"advice", advice}};
}

// --- the page -------------------------------------------------------------------------------------------------------

namespace {

constexpr double next_to_nothing = 0.002;  // of a variance
constexpr double worth_a_shot = 0.95;  // of an interval's width: a measurement that leaves less is named in the answer

// One material after the other, every hypothesis below the others. `first` and `second`: keys of a modulus true and as MU1.
Table modulus_table(const Json& result, const std::string& caption, const std::vector<std::string>& header,
                    const std::string& first, const std::string& second) {
  Table table{.caption = caption, .rows = {header}, .notes = {}};
  const Json& hypotheses = list(result, "hypotheses");
  std::vector<std::string> materials;
  for (const Json& hypothesis : hypotheses)
    for (const Json& one : list(hypothesis, "moduli"))
      if (std::find(materials.begin(), materials.end(), text(one, "material")) == materials.end())
        materials.push_back(text(one, "material"));
  for (const std::string& material : materials) {
    int n = 0;
    for (const Json& hypothesis : hypotheses) {
      ++n;
      for (const Json& one : list(hypothesis, "moduli"))
        if (text(one, "material") == material && at(one, first).is_object())
          table.rows.push_back({material, shown(n), estimate_words(at(one, first)), estimate_words(at(one, second)),
                                value_words(one, "curve_mu_true")});
    }
  }
  for (auto& row : table.rows) {
    row.resize(header.size());
    if (hypotheses.size() == 1) row.erase(row.begin() + 1);
  }
  return table;
}

// A source's share of the variance, and in brackets its standard deviation.
std::string source_words(double share, double standard_deviation) {
  return fmt::format("{} ({})", percent(share), rough_percent(standard_deviation));
}

struct Source {
  double share = 0, standard_deviation = 0;
};

// Sources as rows, quantities as columns. What is next to nothing of every quantity is one row.
Table budget_table(const Json& result, const Json& hypothesis) {
  Table table{.caption = "Where the errors come from: shares of the variance (standard deviations)",
              .rows = {{"source"}},
              .notes = {}};
  std::vector<std::string> named;
  std::vector<std::map<std::string, Source>> quantities;
  for (const Json& budget : list(hypothesis, "error_budgets")) {
    table.rows[0].push_back(text(budget, "quantity"));
    auto& sources = quantities.emplace_back();
    for (const Json& one : list(budget, "sources")) {
      const std::string name = text(one, "name");
      const Source& source = sources[name] = {number_or(one, "share", 0), number_or(one, "standard_deviation", 0)};
      if (source.share >= next_to_nothing && std::find(named.begin(), named.end(), name) == named.end())
        named.push_back(name);
    }
    const Json& total = at(budget, "total");
    table.notes.push_back(fmt::format("{}: {} ({}, {}), standard deviation {}.", table.rows[0].back(),
                                      value_words(total, "value"), interval_words(total, "interval"),
                                      level_words(result), rough_percent(number(budget, "standard_deviation"))));
  }
  for (const std::string& name : named) {
    table.rows.push_back({name});
    for (auto& sources : quantities) {
      const Source source = sources[name];
      table.rows.back().push_back(source.share > 0 ? source_words(source.share, source.standard_deviation) : "-");
      sources.erase(name);
    }
  }
  std::vector<std::string> rest{"everything else"};
  double most = 0;
  for (const auto& sources : quantities) {
    Source sum;
    for (const auto& [name, source] : sources) {
      sum.share += source.share;
      sum.standard_deviation = std::hypot(sum.standard_deviation, source.standard_deviation);
    }
    most = std::max(most, sum.share);
    rest.push_back(source_words(sum.share, sum.standard_deviation));
  }
  if (most > 0) table.rows.push_back(rest);
  return table;
}

}  // namespace

std::string estimate_words(const Json& estimate) {
  if (!estimate.is_object()) return absent;
  const std::string value = value_words(estimate, "value"), interval = interval_words(estimate, "interval");
  return interval == absent ? value : fmt::format("{} ({})", value, interval);
}

Section moduli_section(const Json& result) {
  Section section{.id = "moduli", .title = "Moduli in both conventions", .blocks = {}};
  Table rate = modulus_table(result, "Shear modulus at impact rate, with its " + level_words(result) + " interval",
                             {"material", "hypothesis", "true", "MU1", "its curve's"}, "mu_true", "mu_over_alpha");
  rate.notes.push_back(
      "MU1: LS-DYNA's, 2 mu/alpha. \"below\" and \"above\": the interval is cut off by a bound of the search, the data "
      "say nothing there.");
  add(section, std::move(rate));
  add(section, modulus_table(result, "Young's modulus, quasi-static, with its " + level_words(result) + " interval",
                             {"material", "hypothesis", "true: 3 mu", "3 MU1"}, "youngs_quasi_static_true",
                             "youngs_quasi_static_over_alpha"));
  return section;
}

void add_errors(Section& section, const Json& result, const Json& hypothesis) {
  add(section, budget_table(result, hypothesis));
  Table advice{.caption = "What to measure next", .rows = {{"leaves of the interval", "measurement"}}, .notes = {}};
  for (const Json& one : list(hypothesis, "advice"))
    advice.rows.push_back({percent(number(one, "interval_width_ratio")), text(one, "measurement")});
  add(section, std::move(advice));
}

List advice_list(const Json& hypothesis) {
  std::vector<std::string> quantities;
  std::map<std::string, const Json*> best;  // of each quantity
  for (const Json& one : list(hypothesis, "advice")) {
    const std::string measurement = text(one, "measurement"), name = measurement.substr(0, measurement.find(':'));
    if (!best.contains(name)) quantities.push_back(name);
    const Json*& so_far = best[name];
    if (!so_far || number_or(one, "interval_width_ratio", 1) < number_or(*so_far, "interval_width_ratio", 1))
      so_far = &one;
  }
  List advice;
  for (const std::string& name : quantities) {
    const double ratio = number_or(*best[name], "interval_width_ratio", 1);
    advice.items.push_back(
        ratio < worth_a_shot
            ? fmt::format("{} would leave {} of its interval.", text(*best[name], "measurement"), percent(ratio, 0))
            : fmt::format("{}: no shot or curve that was looked at would make its interval {} narrower.", name,
                          percent(1 - worth_a_shot, 0)));
  }
  return advice;
}

}  // namespace percal::calibration_page
