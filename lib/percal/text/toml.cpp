#include "percal/text/toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "percal/text/file.hpp"
#include "percal/text/key_form.hpp"
#include "percal/text/toml_depth.hpp"
#include "percal/units/words.hpp"

#define TOML_MAX_NESTED_VALUES \
  32  // with refuse_deep_keys this bounds the depth of a document, and so the stack it needs
// toml++ 3.3 asserts that a table header begins with a key, or tells Clang to take it for granted; "[=" does not.
// Without the assertion it goes on to report an error.
#define TOML_ASSERT(expression) static_assert(true)
#pragma push_macro("NDEBUG")
#undef NDEBUG
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace percal {
namespace {

struct Document {
  std::string file;
  toml::table root;
  KeyRecord* record;  // of what is asked for; nullptr: not recorded
};

constexpr std::size_t largest_file = std::size_t{16} << 20;  // bytes

// What stands in the file, for messages.
std::string described(const toml::node& node) {
  if (const auto* text = node.as_string()) return in_quotes(text->get());
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* array = node.as_array()) return array->empty() ? "an empty array" : "an array";
  if (node.is_table()) return "a table";
  return "a date or time";
}

std::optional<double> as_number(const toml::node& node) {
  if (const auto* number = node.as_integer()) return static_cast<double>(number->get());
  if (const auto* number = node.as_floating_point()) return number->get();
  return std::nullopt;
}

int line_of(const toml::source_region& source) { return static_cast<int>(source.begin.line); }

}  // namespace

// A table with what has been asked of it. Children are shared, so that asking twice for a table gives the same one.
struct TomlTable::Node {
  std::shared_ptr<const Document> document;
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
    if (const auto near = nearest_word(key, unasked)) {
      found += fmt::format(" (line {} has {})", place(*near).line, in_quotes(*near));
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
      const auto near = nearest_word(key, asked);
      const std::string found = near ? "an unknown key (did you mean " + *near + "?)" : "an unknown key";
      Place where = place(key);
      const std::string shown = in_quotes(key);
      where.key = prefix + shown.substr(1, shown.size() - 2);
      messages.emplace_back(BadInput(where, found, asked.empty() ? "no keys here" : listed(asked)).what());
    }
    for (const auto& [name, inner] : children) inner->collect_unknown(messages);
  }
};

TomlTable::TomlTable(std::shared_ptr<const Node> node) : node_(std::move(node)) {}

std::optional<double> TomlTable::optional_quantity(const std::string& key, const Dimension& dimension,
                                                   const Range& range) const {
  node_->record(key, quantity_form(dimension, range), false);
  const auto* at = node_->ask(key);
  return at ? std::optional(node_->checked_quantity(key, *at, dimension, range)) : std::nullopt;
}

double TomlTable::quantity(const std::string& key, const Dimension& dimension, const Range& range) const {
  node_->record(key, quantity_form(dimension, range), true);
  if (const auto value = optional_quantity(key, dimension, range)) return *value;
  node_->missing(key, words_of(range, dimension));
}

double TomlTable::quantity(const std::string& key, const Dimension& dimension, const Range& range,
                           double fallback) const {
  node_->record(key, with_default(quantity_form(dimension, range), written(fallback, dimension)), false);
  return optional_quantity(key, dimension, range).value_or(fallback);
}

std::vector<double> TomlTable::quantities(const std::string& key, const Dimension& dimension,
                                          const Range& range) const {
  node_->record(key, quantity_array_form(dimension, range), true);
  return node_->elements(key, "an array, each element " + words_of(range, dimension),
                         [&](const std::string& name, const toml::node& at) {
                           return node_->checked_quantity(name, at, dimension, range);
                         });
}

std::vector<std::array<double, 2>> TomlTable::quantity_pairs(const std::string& key, const Dimension& dimension,
                                                             const Range& range) const {
  const std::string accepted = "an array of pairs, each number " + words_of(range, dimension);
  node_->record(key, quantity_pairs_form(dimension, range), true);
  return node_->elements(key, accepted, [&](const std::string& name, const toml::node& at) {
    const auto* pair = at.as_array();
    if (!pair || pair->size() != 2) node_->refuse(name, at, accepted);
    return std::array{node_->checked_quantity(name + "[1]", *pair->get(0), dimension, range),
                      node_->checked_quantity(name + "[2]", *pair->get(1), dimension, range)};
  });
}

std::optional<double> TomlTable::optional_number(const std::string& key, const Range& range) const {
  node_->record(key, quantity_form(dimension::none, range), false);
  const auto* at = node_->ask(key);
  return at ? std::optional(node_->checked_number(key, *at, range)) : std::nullopt;
}

double TomlTable::number(const std::string& key, const Range& range) const {
  node_->record(key, quantity_form(dimension::none, range), true);
  if (const auto value = optional_number(key, range)) return *value;
  node_->missing(key, words_of(range));
}

double TomlTable::number(const std::string& key, const Range& range, double fallback) const {
  node_->record(key, with_default(quantity_form(dimension::none, range), fmt::format("{}", fallback)), false);
  return optional_number(key, range).value_or(fallback);
}

std::vector<double> TomlTable::numbers(const std::string& key, const Range& range) const {
  node_->record(key, quantity_array_form(dimension::none, range), true);
  return node_->elements(
      key, "an array, each element " + words_of(range),
      [&](const std::string& name, const toml::node& at) { return node_->checked_number(name, at, range); });
}

std::optional<int> TomlTable::optional_integer(const std::string& key, int low, int high) const {
  node_->record(key, integer_form(low, high), false);
  const auto* at = node_->ask(key);
  if (!at) return std::nullopt;
  const auto* number = at->as_integer();
  if (at->is_floating_point())
    throw BadInput(place(key), "the decimal number " + described(*at), accepted_integer(low, high));
  if (!number || number->get() < low || number->get() > high) node_->refuse(key, *at, accepted_integer(low, high));
  return static_cast<int>(number->get());
}

int TomlTable::integer(const std::string& key, int low, int high) const {
  node_->record(key, integer_form(low, high), true);
  if (const auto value = optional_integer(key, low, high)) return *value;
  node_->missing(key, accepted_integer(low, high));
}

int TomlTable::integer(const std::string& key, int low, int high, int fallback) const {
  node_->record(key, with_default(integer_form(low, high), std::to_string(fallback)), false);
  return optional_integer(key, low, high).value_or(fallback);
}

bool TomlTable::flag(const std::string& key, bool fallback) const {
  node_->record(key, with_default(flag_form(), fallback ? "true" : "false"), false);
  const auto* at = node_->ask(key);
  if (!at) return fallback;
  const auto* flag = at->as_boolean();
  if (!flag) node_->refuse(key, *at, "true or false");
  return flag->get();
}

std::optional<std::string> TomlTable::optional_text(const std::string& key) const {
  node_->record(key, text_form(), false);
  const auto* at = node_->ask(key);
  return at ? std::optional(node_->checked_text(key, *at)) : std::nullopt;
}

std::string TomlTable::text(const std::string& key) const {
  node_->record(key, text_form(), true);
  if (const auto value = optional_text(key)) return *value;
  node_->missing(key, "a text in quotes");
}

std::string TomlTable::text(const std::string& key, const std::string& fallback) const {
  node_->record(key, with_default(text_form(), node_->named_file(fallback) ? "the file's name" : in_quotes(fallback)),
                false);
  return optional_text(key).value_or(fallback);
}

std::vector<std::string> TomlTable::texts(const std::string& key) const {
  node_->record(key, {"array: text", "", ""}, true);
  return node_->elements(key, "an array of texts in quotes",
                         [&](const std::string& name, const toml::node& at) { return node_->checked_text(name, at); });
}

int TomlTable::word(const std::string& key, const std::vector<std::string>& accepted) const {
  node_->record(key, word_form(accepted), true);
  const auto* at = node_->ask(key);
  if (!at) node_->missing(key, accepted_words(accepted));
  const auto* text = at->as_string();
  if (!text) node_->refuse(key, *at, accepted_words(accepted));
  const auto found = std::find(accepted.begin(), accepted.end(), text->get());
  if (found != accepted.end()) return static_cast<int>(found - accepted.begin());
  const auto near = nearest_word(text->get(), accepted);
  throw BadInput(place(key), described(*at) + (near ? " (did you mean " + in_quotes(*near) + "?)" : ""),
                 accepted_words(accepted));
}

int TomlTable::word(const std::string& key, const std::vector<std::string>& accepted, int fallback) const {
  node_->record(key, with_default(word_form(accepted), in_quotes(accepted.at(static_cast<std::size_t>(fallback)))),
                false);
  return node_->ask(key) ? word(key, accepted) : fallback;
}

void TomlTable::knows(const std::string& key) const { node_->ask(key); }

void TomlTable::describe(const std::string& key, const KeyForm& form) const {
  if (node_->document->record) node_->document->record->describe(node_->general_path(key), form);
}

bool TomlTable::has(const std::string& key) const {
  node_->record_look(key);
  return node_->table->contains(key);
}

bool TomlTable::is_array(const std::string& key) const {
  const auto* at = node_->table->get(key);
  return at && at->is_array();
}

bool TomlTable::is_text(const std::string& key) const {
  const auto* at = node_->table->get(key);
  return at && at->is_string();
}

std::optional<TomlTable> TomlTable::optional_table(const std::string& key) const {
  node_->record(key, {"table", "", ""}, false);
  const auto* at = node_->ask(key);
  if (!at) return std::nullopt;
  const auto* inner = at->as_table();
  if (!inner) node_->refuse(key, *at, "a table: [" + node_->prefix + key + "]");
  return TomlTable(node_->child(key, *inner, place(key).line));
}

TomlTable TomlTable::table(const std::string& key) const {
  node_->record(key, {"table", "", ""}, true);
  if (auto inner = optional_table(key)) return *inner;
  node_->missing(key, "a table: [" + node_->prefix + key + "]");
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const {
  node_->record(key, {"tables", "", ""}, false);
  const auto* at = node_->ask(key);
  if (!at) return {};
  const std::string accepted = "tables: [[" + node_->prefix + key + "]]";
  const auto* array = at->as_array();
  if (!array) node_->refuse(key, *at, accepted);
  std::vector<TomlTable> result;
  for (const auto& element : *array) {
    const std::string name = fmt::format("{}[{}]", key, result.size() + 1);
    const auto* inner = element.as_table();
    if (!inner) node_->refuse(name, element, accepted);
    result.emplace_back(node_->child(name, *inner, node_->place(key, &element).line));
  }
  return result;
}

std::vector<std::string> TomlTable::keys() const {
  node_->free_names = true;
  std::vector<const toml::key*> found;
  for (const auto& [name, value] : *node_->table) found.push_back(&name);
  std::stable_sort(found.begin(), found.end(),
                   [](const toml::key* a, const toml::key* b) { return a->source().begin < b->source().begin; });
  std::vector<std::string> names;
  for (const auto* name : found) names.emplace_back(name->str());
  return names;
}

std::optional<std::string> TomlTable::optional_path(const std::string& key) const {
  node_->record(key, file_form(), false);
  const auto text = optional_text(key);
  if (!text) return std::nullopt;
  if (text->empty() || text->find('\0') != std::string::npos) refuse(key, in_quotes(*text), "the name of a file");
  const auto folder = std::filesystem::path(node_->document->file).parent_path();
  return (folder / *text).lexically_normal().string();
}

std::string TomlTable::path(const std::string& key) const {
  node_->record(key, file_form(), true);
  if (const auto value = optional_path(key)) return *value;
  node_->missing(key, "the name of a file");
}

Place TomlTable::place(const std::string& key) const { return node_->place(key); }

void TomlTable::refuse(const std::string& key, const std::string& found, const std::string& accepted) const {
  throw BadInput(place(key), found, accepted);
}

void TomlTable::finish() const {
  constexpr std::size_t most_messages = 10;
  std::vector<std::string> messages;
  node_->collect_unknown(messages);
  if (messages.empty()) return;
  const std::size_t left_out = messages.size() - std::min(messages.size(), most_messages);
  messages.resize(messages.size() - left_out);
  if (left_out > 0) messages.push_back(fmt::format("and {} more unknown keys", left_out));
  throw BadInput(fmt::format("{}", fmt::join(messages, "\n")));
}

TomlTable read_toml(const std::string& path) { return parse_toml(read_file(path), path); }

TomlTable parse_toml(const std::string& text, const std::string& name) {
  if (text.size() > largest_file) throw BadInput(name + ": is larger than 16 MiB");
  refuse_deep_keys(text, name);
  try {
    auto document = std::make_shared<const Document>(Document{name, toml::parse(text), KeyRecording::start(name)});
    const toml::table* root = &document->root;
    return TomlTable(
        std::make_shared<const TomlTable::Node>(TomlTable::Node{std::move(document), root, "", "", 0, {}, {}}));
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    throw BadInput(
        fmt::format("{}:{}: not valid TOML (column {}): {}", name, begin.line, begin.column, error.description()));
  }
}

}  // namespace percal
