// What a user says of shots: by options, or in the columns of a table.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/text/csv.hpp"
#include "percal/text/one_value.hpp"

namespace percal {

[[noreturn]] void refuse_option(const std::string& option, const std::string& found, const std::string& accepted);

// Texts with units, as options have them; empty where nothing is said.
struct SphereWords {
  std::string radius = {}, diameter = {};  // one of the two
  std::string density = {}, mass = {};     // one of the two
};

// A text under its name in results and in calls from Python.
using NamedText = std::pair<const char*, std::string*>;
std::vector<NamedText> named_texts(SphereWords& words);

// One number a row: the column of that name, or the option; nothing where neither is there. Without a table one row, by options alone.
class ShotRows {
 public:
  explicit ShotRows(std::optional<CsvTable> table = {}) : table_(std::move(table)) {}

  std::size_t size() const { return table_ ? table_->rows.size() : 1; }
  bool have(const std::string& name, const std::string& option) const { return column(name) || !option.empty(); }
  std::vector<double> numbers(const std::string& name, const std::string& option, const Dimension& dimension) const;
  std::vector<std::string> labels() const;
  // Headers of the table that say nothing of a shot, in its order.
  std::vector<std::string> columns_passed_over() const;

  // m; nothing where no size is said. Throws BadInput for a radius beside a diameter.
  std::optional<std::vector<double>> radii(const SphereWords& words) const;
  // kg/m3, of spheres of these radii (m); as radii().
  std::optional<std::vector<double>> densities(const SphereWords& words, const std::vector<double>& radii) const;

  // "--layer-depth" of "layer_depth".
  static std::string option_of(std::string name);

 private:
  std::optional<int> column(const std::string& name) const { return table_ ? table_->find(name) : std::nullopt; }
  std::string one_of(const std::string& first, const std::string& first_option, const std::string& second,
                     const std::string& second_option) const;

  std::optional<CsvTable> table_;
};

}  // namespace percal
