#include "percal/text/toml_edits.hpp"

#include <cctype>
#include <charconv>

#include "percal/text/toml_node.hpp"

namespace percal {
namespace {

// One part of a path: "below[2]" is the second element of below.
struct Step {
  std::string key;
  std::optional<std::size_t> index;  // from 1
};

bool is_key(const std::string& text) {
  return !text.empty() &&
         std::ranges::all_of(text, [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
}

Step step_of(const std::string& part, const Place& place) {
  const auto bracket = part.find('[');
  Step step{part.substr(0, bracket), {}};
  bool good = is_key(step.key);
  if (bracket != std::string::npos) {
    std::size_t index = 0;
    const char *first = part.data() + bracket + 1, *last = part.data() + part.size() - 1;
    const auto [end, error] = std::from_chars(first, last, index);
    good = good && part.ends_with(']') && error == std::errc() && end == last && index > 0;
    step.index = index;
  }
  if (!good) throw BadInput(place, in_quotes(place.key), "a key such as particle.speed or below[1].mu");
  return step;
}

std::vector<Step> steps_of(const std::string& path, const Place& place) {
  std::vector<Step> steps;
  for (std::size_t start = 0; start != std::string::npos;) {
    const auto dot = path.find('.', start);
    steps.push_back(step_of(path.substr(start, dot == std::string::npos ? dot : dot - start), place));
    start = dot == std::string::npos ? dot : dot + 1;
  }
  return steps;
}

toml::table& inner_table(toml::table& table, const Step& step, const Place& place) {
  toml::node* at = table.get(step.key);
  if (!at && !step.index) at = &table.insert_or_assign(step.key, toml::table{}).first->second;
  if (step.index) {
    toml::array* const array = at ? at->as_array() : nullptr;
    const std::size_t count = array ? array->size() : 0;
    if (*step.index > count)
      throw BadInput(place, fmt::format("{} tables [[{}]]", count, step.key), fmt::format("{} or more", *step.index));
    at = array->get(*step.index - 1);
  }
  if (!at->is_table()) throw BadInput(place, described(*at) + " at " + in_quotes(step.key), "a table there");
  return *at->as_table();
}

void apply(toml::table& root, const TomlEdit& edit, const std::string& file) {
  const Place place{file, 0, edit.path};
  const auto steps = steps_of(edit.path, place);
  toml::table* table = &root;
  for (std::size_t k = 0; k + 1 < steps.size(); ++k) table = &inner_table(*table, steps[k], place);
  const toml::node* const there = table->get(steps.back().key);
  if (steps.back().index || (there && (there->is_table() || there->is_array())))
    throw BadInput(place, "a table or an array", "a key with one value");
  std::visit([&](const auto& value) { table->insert_or_assign(steps.back().key, value); }, edit.value);
}

std::optional<TomlScalar> as_scalar(const toml::node& at) {
  if (const auto* text = at.as_string()) return text->get();
  if (const auto* number = at.as_integer()) return number->get();
  if (const auto* number = at.as_floating_point()) return number->get();
  if (const auto* flag = at.as_boolean()) return flag->get();
  return std::nullopt;
}

constexpr const char* accepted_scalar =
    "a number, with its unit in quotes where it has one, a word in quotes, true or false";

}  // namespace

std::string written(const TomlScalar& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&value)) return in_quotes(*text);
  if (const auto* number = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *number);
  return fmt::format("{}", std::get<double>(value));
}

TomlTable parse_toml_with(const std::string& text, const std::string& name, const std::vector<TomlEdit>& edits) {
  return parse_document(text, name, nullptr, [&](toml::table& root) {
    for (const TomlEdit& edit : edits) apply(root, edit, name);
  });
}

TomlScalar TomlTable::scalar(const std::string& key) const {
  node_->record(key, {"value", accepted_scalar, ""}, true);
  const toml::node* at = node_->ask(key);
  if (!at) node_->missing(key, accepted_scalar);
  const auto value = as_scalar(*at);
  if (!value) node_->refuse(key, *at, accepted_scalar);
  return *value;
}

std::vector<TomlScalar> TomlTable::scalars(const std::string& key) const {
  const std::string accepted = std::string("an array, each element ") + accepted_scalar;
  node_->record(key, {"array: value", accepted, ""}, true);
  return node_->elements(key, accepted, [&](const std::string& name, const toml::node& at) {
    const auto value = as_scalar(at);
    if (!value) node_->refuse(name, at, accepted_scalar);
    return *value;
  });
}

}  // namespace percal
