// percal keys: the keys of a kind of file.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "key_reference.hpp"

namespace percal::tools {
namespace {

std::string cell(std::string text) {
  for (auto at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, 1, '\\');
  return text;
}

// As a cell: values in code, words as they are.
std::string default_cell(const KeyEntry& key) {
  const char first = key.fallback.empty() ? ' ' : key.fallback.front();
  const bool value = first == '"' || first == '-' || (first >= '0' && first <= '9') || key.fallback == "true" ||
                     key.fallback == "false";
  return value ? "`" + key.fallback + "`" : key.fallback;
}

std::string as_markdown(const std::vector<FileKind>& kinds) {
  std::string text =
      "# Every key\n\n"
      "What the readers of percal's TOML files accept, printed by the program (`percal keys --markdown`) from what the "
      "readers say as they read.\n"
      "The pages of each kind of file tell how the keys belong together: [scenes](scene.md), "
      "[identifications](identify.md), [calibrations](calibrate.md), "
      "[campaigns](campaign.md), [powders](dose.md).\n\n"
      "`a.b` is the key b of the table `[a]`, `a[].b` that of every table `[[a]]`, and NAME a name that you give. "
      "A quantity with a dimension is a text with its\n"
      "unit. \"Left out\" means that the key has no default: leaving it out means something of its own.\n";
  for (const FileKind& kind : kinds) {
    text += fmt::format("\n## {}\n\nRead by `{}`; `percal new {}` writes a template.\n\n", kind.title, kind.command,
                        kind.name);
    text += "| key | kind | accepted | default | meaning |\n| --- | --- | --- | --- | --- |\n";
    for (const KeyEntry& key : keys_of(kind))
      text += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.path, key.kind, cell(key.accepted),
                          cell(default_cell(key)), cell(key.meaning));
  }
  return text;
}

std::string as_text(const FileKind& kind) {
  std::string text;
  for (const KeyEntry& key : keys_of(kind)) {
    text += fmt::format(
        "{}\n    {}{}; {}\n", key.path, key.kind, key.accepted.empty() ? "" : ": " + key.accepted,
        key.fallback == "required" || key.fallback == "left out" ? key.fallback : "default: " + key.fallback);
    if (!key.meaning.empty()) text += fmt::format("    {}\n", key.meaning);
  }
  return text;
}

nlohmann::json to_json(const FileKind& kind) {
  nlohmann::json keys = nlohmann::json::array();
  for (const KeyEntry& key : keys_of(kind))
    keys.push_back({{"key", key.path},
                    {"kind", key.kind},
                    {"accepted", key.accepted},
                    {"required", key.required},
                    {"default", key.fallback},
                    {"meaning", key.meaning}});
  return {{"command", "keys"}, {"file", kind.name}, {"keys", keys}};
}

}  // namespace

Exit run_keys(const KeysArguments& arguments, const Common& common) {
  if (const auto faults = faults_of_meanings(); !faults.empty())
    throw std::logic_error(fmt::format("{}", fmt::join(faults, "\n")));
  if (arguments.markdown) {
    fmt::print("{}", as_markdown(file_kinds()));
    return Exit::done;
  }
  const FileKind& kind = file_kind(arguments.kind);
  if (common.json)
    fmt::print("{}\n", to_json(kind).dump(2));
  else
    fmt::print("{}", as_text(kind));
  return Exit::done;
}

}  // namespace percal::tools
