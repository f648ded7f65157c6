#include "percal/text/job_table.hpp"

#include <fmt/format.h>

#include "percal/units/words.hpp"

namespace percal {

namespace {

std::optional<double> percentage(std::string text) {
  while (text.ends_with(' ')) text.pop_back();
  if (!text.ends_with('%')) return std::nullopt;
  text.pop_back();
  while (text.ends_with(' ')) text.pop_back();
  try {
    const Quantity quantity = parse_quantity(text);
    if (quantity.dimension == dimension::none) return quantity.value / 100;
  } catch (const std::invalid_argument&) {
  }
  return std::nullopt;
}

KeyForm column_form(const std::string& what) { return {"column: " + what, "the name of a column of the table", ""}; }

}  // namespace

CsvTable table_of(const TomlTable& block, const std::string& key) {
  block.describe(key, {"file", "the name of a CSV table", ""});
  block.describe("where", {"array of conditions", "\"COLUMN=VALUE\", all of which a row must meet", ""});
  CsvTable table = read_csv(block.path(key));
  if (block.has("where")) table = table.where(block.texts("where"));
  if (table.rows.empty()) block.refuse("where", "no row of " + table.file, "conditions that some row meets");
  return table;
}

int column_index(const TomlTable& block, const std::string& key, const CsvTable& table) {
  block.describe(key, column_form("any"));
  const std::string name = block.text(key);
  const auto index = table.find(name);
  if (!index) {
    std::vector<std::string> headers;
    for (const CsvColumn& column : table.columns) headers.push_back(column.header);
    block.refuse(key, in_quotes(name), "a column of " + table.file + ": " + listed(headers));
  }
  return *index;
}

std::vector<double> column_of(const TomlTable& block, const std::string& key, const CsvTable& table,
                              const Dimension& dimension, const Range& range) {
  block.describe(key, column_form(dimension == dimension::none ? "number" : name_of(dimension)));
  const int index = column_index(block, key, table);
  auto values = table.numbers(index, dimension);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!contains(range, values[i]))
      throw BadInput({table.file, table.rows[i].line, table.columns[index].header}, table.cell(table.rows[i], index),
                     words_of(range));
  return values;
}

std::vector<std::optional<double>> some_of_column(const TomlTable& block, const std::string& key, const CsvTable& table,
                                                  const Dimension& dimension, const Range& range) {
  std::vector<std::optional<double>> all(table.rows.size());
  block.describe(key, column_form(name_of(dimension)));
  block.knows(key);
  if (!block.has(key)) return all;
  const int column = column_index(block, key, table);
  CsvTable filled = table;
  std::erase_if(filled.rows, [&](const CsvRow& row) { return table.cell(row, column).empty(); });
  const auto values = column_of(block, key, filled, dimension, range);
  std::size_t next = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!table.cell(table.rows[i], column).empty()) all[i] = values[next++];
  return all;
}

std::vector<double> values_of_rows(const TomlTable& block, const std::string& key, const CsvTable& table,
                                   const Dimension& dimension, const Range& range) {
  const std::string column = key + "_column";
  if (block.has(key) && block.has(column)) block.refuse(column, "this beside " + key, "one of the two");
  if (block.has(column)) return column_of(block, column, table, dimension, range);
  block.knows(column);
  if (!block.has(key))
    block.refuse(key, "no such key", words_of(range, dimension) + ", or " + column + " = \"COLUMN\"");
  return std::vector<double>(table.rows.size(), block.quantity(key, dimension, range));
}

std::optional<double> optional_share_from(const TomlTable& block, const std::string& key, const Range& range) {
  block.describe(key, {"share", words_of(range) + ", as 0.05 or \"5 %\"", ""});
  if (!block.is_text(key)) return block.optional_number(key, range);
  const std::string text = block.text(key);
  const auto share = percentage(text);
  if (!share || !contains(range, *share)) block.refuse(key, in_quotes(text), words_of(range) + ", as 0.05 or \"5 %\"");
  return share;
}

double share_from(const TomlTable& block, const std::string& key, const Range& range, double fallback) {
  block.describe(key, {"share", words_of(range) + ", as 0.05 or \"5 %\"", fmt::format("{}", fallback)});
  return optional_share_from(block, key, range).value_or(fallback);
}

}  // namespace percal
