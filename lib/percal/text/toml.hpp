// Reading a TOML file key by key: every key read is checked for kind, unit and range, and a key that nobody read is an
// error. Messages name file, line, key, what was found and what is accepted.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/text/key_record.hpp"
#include "percal/text/range.hpp"
#include "percal/units/quantity.hpp"

namespace percal {

// A value by itself: true or false, a whole number, a number, a text (words, quantities).
using TomlScalar = std::variant<bool, std::int64_t, double, std::string>;

// As a file has it: "83 m/s" in quotes.
std::string written(const TomlScalar& value);

// One table of a TOML file. Every getter marks its key as known; finish() throws BadInput for the keys that nobody
// asked for, with the nearest known key as a suggestion. Getters without a fallback throw BadInput where the key is
// missing. Messages give the dotted path: "target.erosion.strain", "points[2].depth" (the second of [[points]]).
// Copies, and tables asked for twice, share what has been asked. A table may be used by one thread at a time.
class TomlTable {
 public:
  struct Node;  // toml++ stays in the .cpp
  explicit TomlTable(std::shared_ptr<const Node> node);

  // A number with a unit, in SI. A bare number is refused unless the dimension is none.
  double quantity(const std::string& key, const Dimension&, const Range&) const;
  double quantity(const std::string& key, const Dimension&, const Range&, double fallback) const;
  std::optional<double> optional_quantity(const std::string& key, const Dimension&, const Range&) const;
  std::vector<double> quantities(const std::string& key, const Dimension&, const Range&) const;  // an array, not empty
  // An array of pairs, not empty: [["0 mm", "1 mm"], ...].
  std::vector<std::array<double, 2>> quantity_pairs(const std::string& key, const Dimension&, const Range&) const;
  std::vector<std::array<double, 3>> quantity_triples(const std::string& key, const Dimension&, const Range&) const;

  double number(const std::string& key, const Range&) const;
  double number(const std::string& key, const Range&, double fallback) const;
  std::optional<double> optional_number(const std::string& key, const Range&) const;
  std::vector<double> numbers(const std::string& key, const Range&) const;
  int integer(const std::string& key, int low, int high) const;
  int integer(const std::string& key, int low, int high, int fallback) const;
  std::optional<int> optional_integer(const std::string& key, int low, int high) const;
  bool flag(const std::string& key, bool fallback) const;
  std::string text(const std::string& key) const;
  std::string text(const std::string& key, const std::string& fallback) const;
  std::optional<std::string> optional_text(const std::string& key) const;
  std::vector<std::string> texts(const std::string& key) const;
  // One word of a list; returns its index.
  int word(const std::string& key, const std::vector<std::string>& accepted) const;
  int word(const std::string& key, const std::vector<std::string>& accepted, int fallback) const;

  // Whatever it is, for who hands it on to another reader.
  TomlScalar scalar(const std::string& key) const;
  std::vector<TomlScalar> scalars(const std::string& key) const;  // an array, not empty

  // Marks a key as known that is refused where it is given, because it belongs to another shape or kind.
  void knows(const std::string& key) const;
  // Says what a key may be where a getter alone does not tell, for the record of keys (key_record.hpp).
  void describe(const std::string& key, const KeyForm& form) const;

  bool has(const std::string& key) const;         // marks nothing as known
  bool is_array(const std::string& key) const;    // likewise; false where the key is missing
  bool is_text(const std::string& key) const;     // likewise
  bool is_table(const std::string& key) const;    // likewise
  TomlTable table(const std::string& key) const;  // must be there
  std::optional<TomlTable> optional_table(const std::string& key) const;
  std::vector<TomlTable> tables(const std::string& key) const;  // array of tables; empty where missing
  // Names that the user gives to its entries, in file order; marks nothing as known.
  std::vector<std::string> keys() const;

  // A path in the file, relative to the file's own folder; returned ready to open.
  std::string path(const std::string& key) const;
  std::optional<std::string> optional_path(const std::string& key) const;

  Place place(const std::string& key) const;  // for messages of one's own
  [[noreturn]] void refuse(const std::string& key, const std::string& found, const std::string& accepted) const;

  // Throws for unknown keys of this table and of every table handed out from it.
  void finish() const;

 private:
  template <std::size_t Count>
  std::vector<std::array<double, Count>> quantity_tuples(const std::string& key, const Dimension&, const Range&,
                                                         const char* what) const;

  std::shared_ptr<const Node> node_;
};

// The file's root table. A missing file, a folder, malformed TOML: BadInput with line and column.
TomlTable read_toml(const std::string& path);
TomlTable parse_toml(const std::string& text, const std::string& name);

}  // namespace percal
