// What stands behind a TomlTable: its table in the document, and what has been asked of it. For toml.cpp and toml_tables.cpp alone:
// it is the one header that includes toml++.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "percal/text/key_record.hpp"
#include "percal/text/key_words.hpp"
#include "percal/text/toml.hpp"
#include "percal/units/words.hpp"

#define TOML_MAX_NESTED_VALUES \
  32  // with refuse_deep_keys this bounds the depth of a document, and so the stack it needs
// toml++ 3.3 asserts that a table header begins with a key, or tells Clang to take it for granted; "[=" does not.
// Without the assertion it goes on to report an error.
#define TOML_ASSERT(expression) static_assert(true)
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/impl/preprocessor.h>
// Places that it takes for out of reach, and lets the compiler run into whatever comes next: here they end the reading.
#undef TOML_UNREACHABLE
#define TOML_UNREACHABLE ::percal::toml_came_out_of_reach()
namespace percal {
[[noreturn]] inline void toml_came_out_of_reach() { throw std::logic_error("toml++ does not know how to go on"); }
}  // namespace percal
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace percal {

struct TomlDocument {
  std::string file;
  toml::table root;
  KeyRecord* record;  // of what is asked for; nullptr: not recorded
};

// What stands in the file, for messages.
inline std::string described(const toml::node& node) {
  if (const auto* text = node.as_string()) return in_quotes(text->get());
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* array = node.as_array()) return array->empty() ? "an empty array" : "an array";
  if (node.is_table()) return "a table";
  return "a date or time";
}

inline std::optional<double> as_number(const toml::node& node) {
  if (const auto* number = node.as_integer()) return static_cast<double>(number->get());
  if (const auto* number = node.as_floating_point()) return number->get();
  return std::nullopt;
}

inline int line_of(const toml::source_region& source) { return static_cast<int>(source.begin.line); }

// A table with what has been asked of it. Children are shared, so that asking twice for a table gives the same one.
struct TomlTable::Node {
  std::shared_ptr<const TomlDocument> document;
  const toml::table* table;
  std::string prefix;   // "target.erosion.", empty for the root
  std::string general;  // the prefix for the record of keys: "points[]." for "points[2]."
  int line;             // of the table's header
  mutable std::vector<std::string> asked;
  mutable std::map<std::string, std::shared_ptr<const Node>> children;
  mutable bool free_names = false;  // its keys are names that the user gives

  std::string general_path(const std::string& key) const { return general + (free_names ? "NAME" : key); }

  void record(const std::string& key, const KeyForm& form, bool required) const {
    if (document->record) document->record->ask(general_path(key), form, required);
  }
  // Whether a default is the document itself or a file beside it.
  bool named_file(const std::string& text) const {
    const auto folder = std::filesystem::path(document->file).parent_path().string();
    return text == document->file || (!folder.empty() && text.starts_with(folder));
  }
  void record_look(const std::string& key) const {
    if (document->record) document->record->look(general_path(key));
  }

  // The value of a key, which is known from now on; nullptr where the file has none.
  const toml::node* ask(const std::string& key) const {
    if (std::find(asked.begin(), asked.end(), key) == asked.end()) asked.push_back(key);
    return table->get(key);
  }

  Place place(const std::string& key, const toml::node* at = nullptr) const {
    const auto found = table->find(key);
    int where = at ? line_of(at->source()) : 0;
    if (where == 0 && found != table->end()) where = line_of(found->first.source());
    return {document->file, where > 0 ? where : line, prefix + key};
  }

  [[noreturn]] void refuse(const std::string& key, const toml::node& at, const std::string& accepted) const {
    throw BadInput(place(key, &at), described(at), accepted);
  }

  [[noreturn]] void missing(const std::string& key, const std::string& accepted) const {
    std::vector<std::string> unasked;
    for (const auto& [name, value] : *table) {
      if (std::find(asked.begin(), asked.end(), name.str()) == asked.end()) unasked.emplace_back(name.str());
    }
    std::string found = "no such key";
    if (const auto near = meant_by(key, unasked)) {
      found += fmt::format(" (line {} has {}: did you mean {}?)", place(*near).line, in_quotes(*near), key);
    }
    throw BadInput(place(key), found, accepted);
  }

  double checked_quantity(const std::string& key, const toml::node& at, const Dimension& dimension,
                          const Range& range) const {
    const std::string accepted = words_of(range, dimension);
    if (const auto number = as_number(at)) {
      if (dimension == dimension::none) return checked_number(key, at, range);
      throw BadInput(place(key, &at), described(at) + " without a unit", accepted);
    }
    const auto* text = at.as_string();
    if (!text) refuse(key, at, accepted);
    try {
      const Quantity quantity = parse_quantity(text->get());
      if (quantity.dimension == dimension && contains(range, quantity.value)) return quantity.value;
      if (quantity.dimension == dimension) refuse(key, at, accepted);
      const std::string kind =
          quantity.dimension == dimension::none ? "number without a unit" : name_of(quantity.dimension);
      throw BadInput(place(key, &at), described(at) + ", " + with_article(kind), accepted);
    } catch (const std::invalid_argument& error) {
      throw BadInput(place(key, &at), fmt::format("{}: {}", described(at), error.what()), accepted);
    }
  }

  double checked_number(const std::string& key, const toml::node& at, const Range& range) const {
    const auto number = as_number(at);
    if (!number || !contains(range, *number)) refuse(key, at, words_of(range));
    return *number;
  }

  std::string checked_text(const std::string& key, const toml::node& at) const {
    const auto* text = at.as_string();
    if (!text) refuse(key, at, "a text in quotes");
    return text->get();
  }

  // Each element of an array that is not empty, through `read(key of the element, element)`.
  template <class Read>
  auto elements(const std::string& key, const std::string& accepted, Read&& read) const {
    const toml::node* at = ask(key);
    if (!at) missing(key, accepted);
    const auto* array = at->as_array();
    if (!array || array->empty()) refuse(key, *at, accepted);
    std::vector<decltype(read(key, *at))> result;
    for (const auto& element : *array) {
      result.push_back(read(fmt::format("{}[{}]", key, result.size() + 1), element));
    }
    return result;
  }

  std::shared_ptr<const Node> child(const std::string& name, const toml::table& inner, int inner_line) const {
    auto& shared = children[name];
    if (!shared) {
      const auto bracket = name.find('[');
      const std::string general_name = free_names                     ? "NAME"
                                       : bracket == std::string::npos ? name
                                                                      : name.substr(0, bracket) + "[]";
      shared = std::make_shared<const Node>(
          Node{document, &inner, prefix + name + ".", general + general_name + ".", inner_line, {}, {}});
    }
    return shared;
  }

  void collect_unknown(std::vector<std::string>& messages) const {
    for (const auto& [name, value] : *table) {
      const std::string key(name.str());
      if (std::find(asked.begin(), asked.end(), key) != asked.end()) continue;
      const auto near = key_meant(key, asked);
      const std::string found = near ? "an unknown key (did you mean " + *near + "?)" : "an unknown key";
      Place where = place(key);
      const std::string shown = in_quotes(key);
      where.key = prefix + shown.substr(1, shown.size() - 2);
      messages.emplace_back(BadInput(where, found, asked.empty() ? "no keys here" : listed(asked)).what());
    }
    for (const auto& [name, inner] : children) inner->collect_unknown(messages);
  }
};

}  // namespace percal
