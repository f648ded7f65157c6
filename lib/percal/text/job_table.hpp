// What blocks of jobs have in common: the CSV table that one names and its columns, shares.
#pragma once
#include <string>
#include <vector>

#include "percal/text/csv.hpp"
#include "percal/text/toml.hpp"

namespace percal {

// The table of the key, cut down by the conditions of the block's `where`. Throws BadInput where no row is left.
CsvTable table_of(const TomlTable& block, const std::string& key = "file");

// The number of the column that the key names. Throws BadInput with the key's place.
int column_index(const TomlTable& block, const std::string& key, const CsvTable& table);

// The column that the key names, as SI numbers within a range.
std::vector<double> column_of(const TomlTable& block, const std::string& key, const CsvTable& table,
                              const Dimension& dimension, const Range& range = positive());

// The same of a column whose cells may be empty; nothing in every row where the block has no such key.
std::vector<std::optional<double>> some_of_column(const TomlTable& block, const std::string& key, const CsvTable& table,
                                                  const Dimension& dimension, const Range& range = positive());

// One number for all rows (`key`), or the column that `key`_column names.
std::vector<double> values_of_rows(const TomlTable& block, const std::string& key, const CsvTable& table,
                                   const Dimension& dimension, const Range& range);

// A share of 1: a number, or a text in percent, "5 %".
double share_from(const TomlTable& block, const std::string& key, const Range& range, double fallback);
std::optional<double> optional_share_from(const TomlTable& block, const std::string& key, const Range& range);

}  // namespace percal
