// The answer: what was asked, the numbers under every hypothesis, what a reader must know, what to do next, what it cost.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/calibrate/page/sections.hpp"
#include "percal/page/numbers.hpp"
#include "percal/units/words.hpp"

namespace percal::calibration_page {
namespace {

// A number that was asked for, as one hypothesis has it.
struct Found {
  std::string what, value, interval;
  std::string rate = "";  // "quasi-static", where it is not that of impacts
};

Found found_modulus(const std::string& what, const Json& estimate, const std::string& rate = "") {
  return {what, value_words(estimate, "value"), interval_words(estimate, "interval"), rate};
}

bool is_modulus(const Json& result, const std::string& parameter) {
  for (const Json& one : list(at(result, "data"), "parameters"))
    if (text(one, "name") == parameter) return text(one, "kind") == "modulus";
  return false;
}

// True moduli of the materials. Main: the quasi-static one where a rate factor is known, the one at impact rate where it is not.
enum class Moduli { main, all };
std::vector<Found> moduli_of(const Json& hypothesis, Moduli wanted) {
  std::vector<Found> all;
  for (const Json& one : list(hypothesis, "moduli")) {
    const std::string material = text(one, "material");
    const Json& youngs = at(one, "youngs_quasi_static_true");
    if (wanted == Moduli::all || youngs.is_null())
      all.push_back(found_modulus("mu of " + material, at(one, "mu_true")));
    if (!youngs.is_null()) all.push_back(found_modulus("E of " + material, youngs, "quasi-static"));
  }
  return all;
}

// Exponents and erosion strains that were fitted, and what rate factors would be if they were free.
void add_other_numbers(const Json& result, const Json& hypothesis, std::vector<Found>& all) {
  for (const Json& one : list(hypothesis, "parameters"))
    if (!is_modulus(result, text(one, "name")))
      all.push_back({text(one, "name"), value_words(one, "value"), allowed_words(one)});
  for (const Json& one : list(at(hypothesis, "verdict"), "rate_factors"))
    all.push_back({"implied rate factor of " + text(one, "material"), shown(number(one, "implied"), 2),
                   interval_words(one, "implied_interval")});
}

// The first hypothesis in one line.
std::vector<Found> headline_of(const Json& result, const Json& hypothesis) {
  std::vector<Found> all = moduli_of(hypothesis, Moduli::main);
  add_other_numbers(result, hypothesis, all);
  return all;
}

std::string agreement_words(const Json& hypothesis) {
  const Json& verdict = at(hypothesis, "verdict");
  const std::string agreement = text(verdict, "agreement");
  if (agreement == word(DataAgreement::agrees)) return "The data agree";
  if (agreement == word(DataAgreement::cannot_tell) && list(verdict, "rate_factors").empty())
    return "There are no curve and depths of one material to contradict each other";
  return agreement == word(DataAgreement::disagrees) ? "The data contradict each other or the model"
                                                     : "Whether the data agree cannot be told";
}

std::vector<Found> numbers_of(const Json& result, const Json& hypothesis) {
  const bool alone = list(result, "hypotheses").size() == 1;  // there is room for both
  std::vector<Found> all = moduli_of(hypothesis, alone ? Moduli::all : Moduli::main);
  add_other_numbers(result, hypothesis, all);
  for (const Json& one : list(hypothesis, "held"))
    if (!is_modulus(result, text(one, "name"))) all.push_back({text(one, "name"), value_words(one, "value"), "held"});
  if (const FittedDepths fitted = fitted_depths(hypothesis); fitted.count > 0)
    all.push_back(
        {"depths are off by", percent(fitted.deviation), fmt::format("{} of {} within", fitted.within, fitted.count)});
  return all;
}

// One number after the other, every hypothesis below the others.
Table number_table(const Json& result) {
  const Json& hypotheses = list(result, "hypotheses");
  Table table{.caption = "", .rows = {{"", "under", "value", level_words(result) + " interval"}}, .notes = {}};
  std::vector<std::string> names;
  std::vector<std::vector<Found>> found;
  bool quasi_static = false;
  for (const Json& hypothesis : hypotheses) {
    found.push_back(numbers_of(result, hypothesis));
    for (const Found& one : found.back()) {
      if (std::find(names.begin(), names.end(), one.what) == names.end()) names.push_back(one.what);
      quasi_static |= !one.rate.empty();
    }
    if (hypotheses.size() > 1) table.notes.push_back(fmt::format("{}: {}", found.size(), text(hypothesis, "name")));
  }
  for (const std::string& name : names)
    for (std::size_t h = 0; h < found.size(); ++h)
      for (const Found& one : found[h])
        if (one.what == name) table.rows.push_back({name, fmt::format("{}", h + 1), one.value, one.interval});
  if (hypotheses.size() == 1)
    for (auto& row : table.rows) row.erase(row.begin() + 1);
  if (quasi_static) table.notes.push_back("mu at impact rate, true; E = 3 mu, quasi-static.");
  return table;
}

// The parameters that the data do not tell, and those that ended at a bound, by hypothesis.
std::vector<std::string> unknown(const Json& result) {
  const Json& hypotheses = list(result, "hypotheses");
  std::vector<std::string> sentences;
  for (std::size_t n = 0; n < hypotheses.size(); ++n) {
    const std::string under = hypotheses.size() > 1 ? fmt::format(" under {}: ", n + 1) : ": ";
    std::vector<std::string> unidentified, bounded;
    for (const Json& one : list(hypotheses[n], "parameters")) {
      if (at(one, "identifiable") == Json(false)) unidentified.push_back(text(one, "name"));
      if (yes(one, "at_bound")) bounded.push_back(text(one, "name"));
    }
    if (!unidentified.empty()) sentences.push_back("Not identifiable" + under + listed(unidentified) + ".");
    if (!bounded.empty()) sentences.push_back("At a bound of the search" + under + listed(bounded) + ".");
  }
  return sentences;
}

Section asked_section(const Json& result) {
  const Json& data = at(result, "data");
  const Json &shots = list(data, "shots"), &curves = list(data, "curves"), &hypotheses = list(result, "hypotheses");
  const auto used = std::count_if(shots.begin(), shots.end(), [](const Json& shot) { return yes(shot, "used"); });
  std::vector<std::string> names, synthetic;
  for (const Json& one : list(data, "parameters")) names.push_back(text(one, "name"));
  for (const Json& curve : curves)
    if (yes(curve, "synthetic")) synthetic.push_back(text(curve, "name"));
  Section section{.id = "asked", .title = "What was asked", .blocks = {}, .detail = Detail::answer};
  add_sentence(
      section,
      fmt::format("{} from {} ({} fitted) and {}{}{}.", listed(names), counted(static_cast<long>(shots.size()), "shot"),
                  used, counted(static_cast<long>(curves.size()), "curve"),
                  synthetic.empty() ? "" : " (synthetic: " + listed(synthetic) + ")",
                  hypotheses.size() > 1 ? fmt::format(", under {} hypotheses", hypotheses.size()) : ""));
  return section;
}

// What each hypothesis makes of the data, before any number: a sentence of several of them once, with their numbers.
Section verdict_section(const Json& result) {
  const Json& hypotheses = list(result, "hypotheses");
  Section section{.id = "verdict", .title = "Do the data agree?", .blocks = {}, .detail = Detail::answer};
  std::vector<std::pair<std::string, std::string>> sentences;  // and under which hypotheses
  bool disagrees = false;
  for (std::size_t n = 0; n < hypotheses.size(); ++n) {
    const Json& verdict = at(hypotheses[n], "verdict");
    disagrees |= text(verdict, "agreement") == word(DataAgreement::disagrees);
    for (const std::string& sentence : texts(at(verdict, "sentences"))) {
      const auto said = std::ranges::find(sentences, sentence, &std::pair<std::string, std::string>::first);
      if (said == sentences.end())
        sentences.emplace_back(sentence, fmt::format("{}", n + 1));
      else
        said->second += fmt::format(", {}", n + 1);
    }
  }
  List all{.items = {}, .tone = disagrees ? Tone::warning : Tone::plain};
  for (const auto& [sentence, under] : sentences)
    all.items.push_back(hypotheses.size() > 1 ? fmt::format("under {}: {}", under, sentence) : sentence);
  add(section, std::move(all));
  return section;
}

Section numbers_section(const Json& result) {
  Section section{.id = "answer", .title = "What came out", .blocks = {}, .detail = Detail::answer};
  Table table = number_table(result);
  for (const std::string& sentence : unknown(result)) table.notes.push_back(sentence);
  add(section, std::move(table));
  return section;
}

// What every hypothesis says, then what is said of all together.
Section known_section(const Json& result) {
  Section section = findings_section(result);
  if (List common{findings_of_all(result), Tone::note}; !common.items.empty())
    section.blocks.insert(section.blocks.begin(), std::move(common));
  return section;
}

// Measurements, and runs.
Section next_section(const Json& result) {
  const Json &cost = at(result, "cost"), &hypotheses = list(result, "hypotheses");
  Section section{.id = "next", .title = "What to do next", .blocks = {}, .detail = Detail::answer};
  List advice;
  if (!hypotheses.empty()) advice = advice_list(hypotheses.front());
  if (const std::string more = text(cost, "advice"); !more.empty()) advice.items.push_back(more);
  add(section, std::move(advice));
  const auto budget = number(cost, "budget_s");
  add_sentence(
      section,
      fmt::format("This took {} runs, {} more from the store, {:.1f} s of processor time, {:.1f} s in all{}.",
                  shown(number(cost, "runs"), 9), shown(number(cost, "reused"), 9), number_or(cost, "cpu_s", nowhere),
                  number_or(cost, "wall_s", nowhere), budget ? fmt::format(" of a budget of {:g} s", *budget) : ""));
  return section;
}

}  // namespace

std::vector<std::string> findings_of_all(const Json& result) {
  const Json& hypotheses = list(result, "hypotheses");
  std::vector<std::string> common;
  if (!hypotheses.empty()) common = texts(at(hypotheses.front(), "findings"));
  for (const Json& hypothesis : hypotheses) {
    const auto theirs = texts(at(hypothesis, "findings"));
    std::erase_if(common,
                  [&](const auto& one) { return std::find(theirs.begin(), theirs.end(), one) == theirs.end(); });
  }
  return common;
}

std::string summary_of(const Json& result) {
  const Json& hypotheses = list(result, "hypotheses");
  if (hypotheses.empty()) return "No hypothesis could be fitted.";
  std::string summary;
  for (const Found& one : headline_of(result, hypotheses.front()))
    summary += fmt::format("{}{}{}{} {} ({})", summary.empty() ? "" : "; ", one.rate, one.rate.empty() ? "" : " ",
                           one.what, one.value, one.interval);
  return fmt::format("{}. {}: true moduli with {} intervals, by the hypothesis \"{}\"{}.",
                     agreement_words(hypotheses.front()), summary, level_words(result),
                     text(hypotheses.front(), "name"),
                     hypotheses.size() > 1 ? fmt::format(", the first of {}", hypotheses.size()) : "");
}

void add_answer(Page& page, const Json& result) {
  page.summary = summary_of(result);
  for (Section section : {verdict_section(result), asked_section(result), numbers_section(result),
                          known_section(result), next_section(result)})
    add(page, std::move(section));
}

}  // namespace percal::calibration_page
