// The values of a table.
#include "percal/text/toml_node.hpp"

namespace percal {

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

// `what`: "pairs".
template <std::size_t Count>
std::vector<std::array<double, Count>> TomlTable::quantity_tuples(const std::string& key, const Dimension& dimension,
                                                                  const Range& range, const char* what) const {
  const std::string accepted = std::string("an array of ") + what + ", each number " + words_of(range, dimension);
  node_->record(key, quantity_tuples_form(dimension, range, what), true);
  return node_->elements(key, accepted, [&](const std::string& name, const toml::node& at) {
    const auto* tuple = at.as_array();
    if (!tuple || tuple->size() != Count) node_->refuse(name, at, accepted);
    std::array<double, Count> numbers{};
    for (std::size_t k = 0; k < Count; ++k)
      numbers[k] = node_->checked_quantity(name + "[" + std::to_string(k + 1) + "]", *tuple->get(k), dimension, range);
    return numbers;
  });
}

std::vector<std::array<double, 2>> TomlTable::quantity_pairs(const std::string& key, const Dimension& dimension,
                                                             const Range& range) const {
  return quantity_tuples<2>(key, dimension, range, "pairs");
}

std::vector<std::array<double, 3>> TomlTable::quantity_triples(const std::string& key, const Dimension& dimension,
                                                               const Range& range) const {
  return quantity_tuples<3>(key, dimension, range, "triples");
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

}  // namespace percal
