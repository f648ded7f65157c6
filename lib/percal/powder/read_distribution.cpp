#include "percal/powder/read_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/text/csv.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr std::size_t most_classes = 5000;
constexpr double most_geometric = 20;
const Range geometric_range{.low = 1, .high = most_geometric, .words = "a geometric standard deviation from 1 to 20"};

const std::vector<std::string> weightings{"number", "mass"};

// Shares that add up to 1, of any that are not negative.
void normalise(Histogram& classes, const std::function<void()>& refuse_sum) {
  double sum = 0;
  for (const ValueClass& one : classes) sum += one.share;
  if (!(sum > 0)) refuse_sum();
  for (ValueClass& one : classes) one.share /= sum;
  std::erase_if(classes, [](const ValueClass& one) { return one.share == 0; });
}

Histogram inline_histogram(const TomlTable& block, const PowderNumber& number) {
  const auto edges = block.quantities("edges", number.dimension, positive(name_of(number.dimension)));
  const auto shares = block.numbers("shares", not_negative("share"));
  if (edges.size() < 2 || !std::ranges::is_sorted(edges, std::ranges::less_equal{}) ||
      std::ranges::adjacent_find(edges) != edges.end())
    block.refuse("edges", "edges that do not rise", "two edges or more, each above the one before");
  if (shares.size() + 1 != edges.size())
    block.refuse("shares", fmt::format("{} of them for {} edges", shares.size(), edges.size()),
                 "one share fewer than edges");
  Histogram classes;
  for (std::size_t k = 0; k < shares.size(); ++k) classes.push_back({edges[k], edges[k + 1], shares[k]});
  normalise(classes, [&] { block.refuse("shares", "zeros alone", "shares of which one is above 0"); });
  return classes;
}

std::vector<double> positive_column(const CsvTable& table, const std::string& name, const Dimension& dimension) {
  const int column = table.column(name);
  std::vector<double> values = table.numbers(column, dimension);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(values[i] > 0))
      throw BadInput({table.file, table.rows[i].line, table.columns[column].header},
                     in_quotes(table.cell(table.rows[i], column)), words_of(positive(name_of(dimension))));
  return values;
}

// Columns NAME, or NAME_from and NAME_to; share, or every row the same.
Histogram histogram_in(const CsvTable& table, const PowderNumber& number) {
  if (table.rows.size() > most_classes)
    throw BadInput({table.file, 0, ""}, fmt::format("{} rows", table.rows.size()),
                   fmt::format("up to {}: a histogram of them", most_classes));
  const std::string from = number.name + "_from", to = number.name + "_to";
  const bool are_classes = table.find(from).has_value();
  const auto lows = positive_column(table, are_classes ? from : number.name, number.dimension);
  const auto highs = are_classes ? positive_column(table, to, number.dimension) : lows;
  const auto shares = table.find("share") ? table.numbers("share", dimension::none) : std::vector(lows.size(), 1.0);
  Histogram classes;
  for (std::size_t i = 0; i < lows.size(); ++i) {
    const auto refuse = [&](const std::string& column, const std::string& accepted) {
      throw BadInput({table.file, table.rows[i].line, column},
                     in_quotes(table.cell(table.rows[i], table.column(column))), accepted);
    };
    if (highs[i] < lows[i]) refuse(to, "no less than " + from);
    if (!(shares[i] >= 0)) refuse("share", "a share not below zero");
    classes.push_back({lows[i], highs[i], shares[i]});
  }
  normalise(classes, [&] { throw BadInput({table.file, 0, "share"}, "zeros alone", "one above 0"); });
  std::ranges::sort(classes, {}, &ValueClass::low);
  return classes;
}

Distribution lognormal_in(const TomlTable& block, const PowderNumber& number) {
  const Range range = positive(name_of(number.dimension));
  if (block.has("median"))
    return Lognormal{block.quantity("median", number.dimension, range),
                     std::log(block.number("geometric_deviation", geometric_range))};
  return lognormal_of(block.quantity("mean", number.dimension, range),
                      block.quantity("deviation", number.dimension, not_negative(name_of(number.dimension))));
}

// Each way to say a distribution, by the key that tells it.
struct Form {
  const char* key;
  std::vector<const char*> others;
};
const std::vector<Form>& forms() {
  static const std::vector<Form> all{
      {"median", {"geometric_deviation"}}, {"mean", {"deviation"}}, {"edges", {"shares"}}, {"file", {}}};
  return all;
}

// The one form that the block has; keys of the others are known and refused.
std::string form_of(const TomlTable& block, const std::string& accepted) {
  std::string found;
  for (const Form& form : forms()) {
    block.knows(form.key);
    for (const char* other : form.others) block.knows(other);
    if (!block.has(form.key)) continue;
    if (!found.empty()) block.refuse(form.key, "this beside " + found, "one of the two");
    found = form.key;
  }
  for (const Form& form : forms())
    for (const char* other : form.others)
      if (form.key != found && block.has(other))
        block.refuse(other, found.empty() ? "this alone" : "this beside " + found,
                     std::string("it beside ") + form.key);
  if (found.empty()) block.refuse("median", "no such key", accepted);
  return found;
}

Distribution distribution_in(const TomlTable& block, const PowderNumber& number) {
  const std::string form =
      form_of(block, "median and geometric_deviation, mean and deviation, edges and shares, or file");
  if (form == "edges") return inline_histogram(block, number);
  if (form == "file") {
    block.describe("file", {"file", "the name of a CSV table", ""});
    return histogram_in(read_csv(block.path("file")), number);
  }
  return lognormal_in(block, number);
}

SpeedBySize speeds_by_size(const TomlTable& block) {
  block.describe("by_size", {"file", "the name of a CSV table with the columns radius or diameter, and speed", ""});
  const CsvTable table = read_csv(block.path("by_size"));
  const bool diameters = table.find("diameter").has_value();
  SpeedBySize found{positive_column(table, diameters ? "diameter" : "radius", dimension::length),
                    positive_column(table, "speed", dimension::speed)};
  if (diameters)
    for (double& size : found.radius) size /= 2;
  for (std::size_t i = 1; i < found.radius.size(); ++i)
    if (!(found.radius[i] > found.radius[i - 1]))
      throw BadInput({table.file, table.rows[i].line, diameters ? "diameter" : "radius"},
                     "a size that is not above the one before", "sizes that rise");
  return found;
}

}  // namespace

ReadDistribution read_distribution(const TomlTable& powder, const PowderNumber& number) {
  powder.describe(number.name, {name_of(number.dimension) + " or table", "one value of all particles, or a table", ""});
  if (!powder.is_table(number.name))
    return {Lognormal{powder.quantity(number.name, number.dimension, positive(name_of(number.dimension))), 0}};
  const TomlTable block = powder.table(number.name);
  const Distribution given = distribution_in(block, number);
  if (!number.is_size) return {given};
  const bool by_mass = block.word("weighting", weightings) == 1;
  return {by_mass ? by_number(given) : given, by_mass};
}

void read_speed(const TomlTable& powder, Powder& into) {
  const PowderNumber number{"speed", dimension::speed};
  if (powder.is_table("speed")) {
    const TomlTable block = powder.table("speed");
    block.knows("by_size");
    if (block.has("by_size")) {
      for (const char* other : {"median", "mean", "deviation", "edges", "shares", "file"}) {
        block.knows(other);
        if (block.has(other)) block.refuse(other, "this beside by_size", "geometric_deviation, or nothing");
      }
      into.by_size = speeds_by_size(block);
      into.speed = Lognormal{1, std::log(block.number("geometric_deviation", geometric_range, 1))};
      return;
    }
  }
  into.speed = read_distribution(powder, number).by_number;
}

}  // namespace percal
