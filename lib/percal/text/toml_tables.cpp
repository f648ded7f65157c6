// Tables of a table, paths, and the file itself.
#include <string_view>

#include "percal/text/file.hpp"
#include "percal/text/toml_node.hpp"

namespace percal {
namespace {

constexpr std::size_t largest_file = std::size_t{16} << 20;  // bytes
constexpr int most_dots = 100;                               // in one line, decimal points not counted

bool is_digit(char c) { return (c >= '0' && c <= '9') || c == '_'; }

// A dot with digits on both sides, none of which belongs to another dot: 0.25, but not the keys 1.2.3.
bool is_decimal_point(std::string_view line, std::size_t dot) {
  std::size_t before = dot, after = dot + 1;
  while (before > 0 && is_digit(line[before - 1])) --before;
  while (after < line.size() && is_digit(line[after])) ++after;
  const bool has_digits = before < dot && after > dot + 1;
  const bool alone = (before == 0 || line[before - 1] != '.') && (after == line.size() || line[after] != '.');
  return has_digits && alone;
}

// Each dot of a key nests one table in another, and tables are destroyed recursively: throws BadInput for a line with too many.
void refuse_deep_keys(std::string_view text, const std::string& file) {
  int number = 1;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    int dots = 0;
    for (std::size_t at = line.find('.'); at != line.npos; at = line.find('.', at + 1))
      dots += !is_decimal_point(line, at);
    if (dots > most_dots)
      throw BadInput({file, number, ""}, "a line with more than 100 dots", "keys nested a few levels deep");
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    ++number;
  }
}

}  // namespace

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

bool TomlTable::is_table(const std::string& key) const {
  const auto* at = node_->table->get(key);
  return at && at->is_table();
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
  return parse_document(text, name, KeyRecording::start(name), {});
}

TomlTable parse_document(const std::string& text, const std::string& name, KeyRecord* record,
                         const std::function<void(toml::table&)>& edit) {
  if (text.size() > largest_file) throw BadInput(name + ": is larger than 16 MiB");
  refuse_deep_keys(text, name);
  try {
    toml::table content = toml::parse(text);
    if (edit) edit(content);
    auto document = std::make_shared<const TomlDocument>(TomlDocument{name, std::move(content), record});
    const toml::table* root = &document->root;
    return TomlTable(
        std::make_shared<const TomlTable::Node>(TomlTable::Node{std::move(document), root, "", "", 0, {}, {}}));
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    throw BadInput(
        fmt::format("{}:{}: not valid TOML (column {}): {}", name, begin.line, begin.column, error.description()));
  } catch (const std::logic_error& error) {  // toml_came_out_of_reach
    throw BadInput(fmt::format("{}: not valid TOML: {}", name, error.what()));
  }
}

}  // namespace percal
