// Two results of the same command side by side.
#include "percal/page/comparison.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "percal/base/error.hpp"
#include "percal/base/version.hpp"
#include "percal/page/comparison_of.hpp"
#include "percal/page/numbers.hpp"
#include "percal/units/words.hpp"

namespace percal::page {
namespace {

constexpr std::size_t most_others = 40;  // numbers that are not main ones
constexpr double worth_a_word = 2;       // combined errors
constexpr double next_to_nothing = 0.1;  // of the other number: a change over less is no percentage

// --- inputs -------------------------------------------------------------------------------------------------------

// Every plain value of an input, by its path.
void collect_inputs(const Json& value, const std::string& path, std::map<std::string, std::string>& found) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items())
      if (key != "toml") collect_inputs(inner, path.empty() ? key : path + ": " + key, found);
  } else {
    found[path] = value.is_string() ? value.get<std::string>() : value.dump();
  }
}

std::map<std::string, std::string> inputs_of(const Json& result) {
  std::map<std::string, std::string> inputs;
  for (const char* key : {"percal", "residual", "model", "signs", "convention", "sources", "level"})
    if (!maybe(result, key).is_null() && !maybe(result, key).is_object())
      collect_inputs(maybe(result, key), key, inputs);
  if (const Json& isa = maybe(maybe(result, "cost"), "isa"); isa.is_string()) collect_inputs(isa, "isa", inputs);
  collect_inputs(maybe(result, "input"), "", inputs);
  return inputs;
}

Table input_table(const Json& first, const Json& second) {
  Table table{.caption = "What differs beside the text", .rows = {{"", "A", "B"}}, .notes = {}};
  auto a = inputs_of(first), b = inputs_of(second);
  std::set<std::string> keys;
  for (const auto* inputs : {&a, &b})
    for (const auto& [key, value] : *inputs) keys.insert(key);
  for (const std::string& key : keys)
    if (a[key] != b[key]) table.rows.push_back({key, a[key].empty() ? "-" : a[key], b[key].empty() ? "-" : b[key]});
  return table;
}

Table line_table(const Json& first, const Json& second) {
  Table table{.caption = "Lines of the job that differ", .rows = {{"line", "A", "B"}}, .notes = {}};
  for (const ChangedLine& line :
       changed_lines(text(maybe(maybe(first, "input"), "toml")), text(maybe(maybe(second, "input"), "toml")))) {
    const auto place = [](int n) { return n > 0 ? fmt::format("{}", n) : std::string("-"); };
    const bool same_place = line.first_line == line.second_line;
    table.rows.push_back(
        {same_place ? place(line.first_line) : place(line.first_line) + " / " + place(line.second_line),
         line.first_line > 0 ? line.first : "-", line.second_line > 0 ? line.second : "-"});
  }
  return table;
}

Section inputs_section(const Json& first, const Json& second, int& differing) {
  Section section{.id = "inputs", .title = "What was asked differently", .blocks = {}};
  Table lines = line_table(first, second), others = input_table(first, second);
  differing = static_cast<int>(lines.rows.size() + others.rows.size()) - 2;
  if (differing == 0) add_sentence(section, "Nothing: the inputs are the same.");
  add(section, std::move(lines));
  add(section, std::move(others));
  return section;
}

// --- numbers ------------------------------------------------------------------------------------------------------

struct BothNumbers {
  std::string path;
  std::optional<FoundNumber> first, second;

  bool differs() const { return !first || !second || first->value != second->value; }
  std::optional<double> difference() const {
    return first && second ? std::optional(second->value - first->value) : std::nullopt;
  }
  std::optional<double> relative() const {
    return difference() && std::abs(first->value) > next_to_nothing * std::abs(second->value)
               ? std::optional(*difference() / std::abs(first->value))
               : std::nullopt;
  }
  // Of the larger of the two: from 0, the same, to 2.
  double share() const {
    const double larger = std::max(std::abs(first->value), std::abs(second->value));
    return larger > 0 ? std::abs(*difference()) / larger : 0;
  }
  // The difference over both errors together.
  std::optional<double> over_errors() const {
    if (!difference() || (!first->error && !second->error)) return std::nullopt;
    const double error = std::hypot(first->error.value_or(0), second->error.value_or(0));
    return error > 0 ? std::optional(*difference() / error) : std::nullopt;
  }
};

// In the order of the first result, then what only the second has. A path that stands twice counts in its order.
std::vector<BothNumbers> paired(const Json& first, const Json& second) {
  std::vector<BothNumbers> all;
  std::map<std::string, std::vector<std::size_t>> places;
  for (const FoundNumber& one : numbers_of(first)) {
    places[one.path].push_back(all.size());
    all.push_back({one.path, one, std::nullopt});
  }
  std::map<std::string, std::size_t> met;
  for (const FoundNumber& one : numbers_of(second)) {
    const std::size_t n = met[one.path]++;
    const auto found = places.find(one.path);
    if (found != places.end() && n < found->second.size())
      all[found->second[n]].second = one;
    else
      all.push_back({one.path, std::nullopt, one});
  }
  return all;
}

std::string with_its_error(const std::optional<FoundNumber>& one) {
  if (!one) return "-";
  return with_error(value_of(one->path, one->value), one->error ? value_of(one->path, one->error) : "-");
}

std::string difference_words(const BothNumbers& both) {
  if (!both.differs()) return "0";
  const std::string difference = value_of(both.path, both.difference());
  return both.relative() ? fmt::format("{} ({})", difference, signed_percent(both.relative(), 2)) : difference;
}

std::vector<std::string> row_of(const BothNumbers& both) {
  const auto in_errors = both.over_errors();
  return {path_words(both.path), with_its_error(both.first), with_its_error(both.second), difference_words(both),
          both.differs() && in_errors ? fmt::format("{:+.2g}", *in_errors) : "-"};
}

const std::vector<std::string> header{"", "A", "B", "B less A (of A)", "over both errors"};

Section numbers_section(const std::string& command, const std::vector<BothNumbers>& numbers) {
  Section section{.id = "numbers", .title = "What came out", .blocks = {}};
  const bool any = std::any_of(numbers.begin(), numbers.end(), [](const BothNumbers& b) { return b.differs(); });
  if (!any) {
    add_sentence(section, fmt::format("All {} numbers are the same.", numbers.size()));
    return section;
  }
  Table main{.caption = "The main numbers", .rows = {header}, .notes = {}};
  std::vector<BothNumbers> others;
  int only_a = 0, only_b = 0;
  for (const BothNumbers& both : numbers) {
    if (!both.first || !both.second)
      ++(both.first ? only_a : only_b);
    else if (is_main(command, both.path))
      main.rows.push_back(row_of(both));
    else if (both.differs())
      others.push_back(both);
  }
  main.notes.push_back(
      "Errors are standard errors or spreads where the result has them, a quarter of the interval's width where it has "
      "one. Over both errors: the difference over the root of the sum of their squares.");
  add(section, std::move(main));
  std::stable_sort(others.begin(), others.end(),
                   [](const BothNumbers& a, const BothNumbers& b) { return a.share() > b.share(); });
  Table rest{
      .caption = "Other numbers that differ, the largest share first", .rows = {header}, .notes = {}, .folded = true};
  for (std::size_t i = 0; i < std::min(others.size(), most_others); ++i) rest.rows.push_back(row_of(others[i]));
  rest.caption += fmt::format(" ({} of {})", std::min(others.size(), most_others), others.size());
  add(section, std::move(rest));
  if (only_a + only_b > 0)
    add_sentence(section, fmt::format("{} numbers stand in A alone, {} in B alone.", only_a, only_b));
  return section;
}

// Texts at the top of the result: outcomes and the like.
Section words_section(const Json& first, const Json& second) {
  Section section{.id = "words", .title = "Outcomes and findings", .blocks = {}};
  Table table{.caption = "Words that differ", .rows = {{"", "A", "B"}}, .notes = {}};
  for (const auto& [key, value] : first.items())
    if (value.is_string() && key != "percal" && text(maybe(second, key)) != text(maybe(first, key)))
      table.rows.push_back(
          {key, text(maybe(first, key)), text(maybe(second, key)).empty() ? "-" : text(maybe(second, key))});
  add(section, std::move(table));
  const auto a = texts(maybe(first, "findings")), b = texts(maybe(second, "findings"));
  const auto only = [](const std::vector<std::string>& mine, const std::vector<std::string>& other,
                       const std::string& of) {
    List bullets;
    for (const std::string& finding : mine)
      if (std::find(other.begin(), other.end(), finding) == other.end())
        bullets.items.push_back("only " + of + ": " + finding);
    return bullets;
  };
  for (List bullets : {only(a, b, "A"), only(b, a, "B")})
    if (!bullets.items.empty()) section.blocks.push_back(std::move(bullets));
  return section;
}

// --- cost ---------------------------------------------------------------------------------------------------------

Section cost_section(const Json& first, const Json& second) {
  Section section{.id = "cost", .title = "What each cost", .blocks = {}};
  Table table{.caption = "Cost", .rows = {{"", "A", "B"}}, .notes = {}};
  const auto row = [&](const std::string& what, const Json& a, const Json& b, const std::string& key) {
    const auto one = number(maybe(a, key)), other = number(maybe(b, key));
    if (one || other) table.rows.push_back({what, value_of(key, one), value_of(key, other)});
  };
  for (const auto& [key, what] : {std::pair{"runs", "runs done"},
                                  {"reused", "runs from the store"},
                                  {"cpu_s", "processor time"},
                                  {"wall_s", "time in all"},
                                  {"budget_s", "budget"}})
    row(what, maybe(first, "cost"), maybe(second, "cost"), key);
  row("element-steps", first, second, "element_steps");
  add(section, std::move(table));
  return section;
}

std::string summary_of(const std::vector<BothNumbers>& numbers, const std::string& command, int inputs) {
  const auto differing =
      std::count_if(numbers.begin(), numbers.end(), [](const BothNumbers& b) { return b.differs(); });
  if (differing == 0)
    return fmt::format(
        "{}, and every number is the same.",
        inputs == 0 ? "The inputs are the same" : "What was asked differs in " + counted(inputs, "place"));
  const BothNumbers* farthest = nullptr;
  for (const BothNumbers& both : numbers)
    if (is_main(command, both.path) && both.over_errors() &&
        (!farthest || std::abs(*both.over_errors()) > std::abs(*farthest->over_errors())))
      farthest = &both;
  std::string summary = fmt::format("What was asked differs in {}, what came out in {} of {} numbers.",
                                    counted(inputs, "place"), differing, numbers.size());
  if (farthest && std::abs(*farthest->over_errors()) > worth_a_word)
    summary += fmt::format(" Farthest apart for its errors is {}: {} in A, {} in B, {:.2g} combined errors.",
                           path_words(farthest->path), value_of(farthest->path, farthest->first->value),
                           value_of(farthest->path, farthest->second->value), std::abs(*farthest->over_errors()));
  else if (farthest)
    summary += " No main number with an error differs by more than two combined errors.";
  return summary;
}

}  // namespace

Page compared(const ReadResult& first, const ReadResult& second) {
  const std::string command = text(first.json, "command");
  if (text(second.json, "command") != command)
    throw BadInput({second.file, 0, "command"}, in_quotes(text(second.json, "command")),
                   in_quotes(command) + ", as in " + first.file + ": two results of the same command");
  const auto numbers = paired(first.json, second.json);
  int inputs = 0;
  const Section asked = inputs_section(first.json, second.json, inputs);
  Page page{
      .title = "Two results of percal " + command, .summary = summary_of(numbers, command, inputs), .sections = {}};
  Section which{.id = "which", .title = "The results", .blocks = {}};
  add(which,
      Table{.caption = "",
            .rows = {{"", "file", "title"}, {"A", first.file, first.page.title}, {"B", second.file, second.page.title}},
            .notes = {}});
  add(page, which);
  add(page, asked);
  add(page, numbers_section(command, numbers));
  add(page, words_section(first.json, second.json));
  Section figures{.id = "figures", .title = "Both in one plot", .blocks = {}};
  for (Figure& figure : overlaid_figures(first.page, second.page)) add(figures, std::move(figure));
  add(page, std::move(figures));
  add(page, cost_section(first.json, second.json));
  return page;
}

}  // namespace percal::page
