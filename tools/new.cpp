// percal new: a commented template, and the example tables that it reads.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "colour.hpp"
#include "commands.hpp"
#include "key_reference.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t comment_column = 44;

// "a.NAME.b" and "a.x.b".
bool same_path(const std::string& pattern, const std::string& path) {
  std::istringstream expected(pattern), found(path);
  std::string a, b;
  while (std::getline(expected, a, '.')) {
    if (!std::getline(found, b, '.')) return false;
    if (a != b && a != "NAME") return false;
  }
  return !std::getline(found, b, '.');
}

const KeyEntry* find(const std::vector<KeyEntry>& keys, const std::string& path) {
  const auto at =
      std::find_if(keys.begin(), keys.end(), [&](const KeyEntry& key) { return same_path(key.path, path); });
  return at == keys.end() ? nullptr : &*at;
}

// The path of a header's table, with [] behind every part that is an array of tables.
class TablePath {
 public:
  // Of a line without "# ": "[a.b]" or "[[a.b]]".
  void enter(const std::string& header) {
    const bool array = header.starts_with("[[");
    const auto first = header.find_first_not_of('['), last = header.find(']');
    std::istringstream parts(header.substr(first, last - first));
    if (array) arrays_.insert(header.substr(first, last - first));
    std::string plain;
    path_.clear();
    for (std::string part; std::getline(parts, part, '.');) {
      plain += (plain.empty() ? "" : ".") + part;
      path_ += (path_.empty() ? "" : ".") + part + (arrays_.contains(plain) ? "[]" : "");
    }
  }
  // Of the table itself as a key of its parent: without the last [].
  std::string itself() const { return path_.ends_with("[]") ? path_.substr(0, path_.size() - 2) : path_; }
  std::string of(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }

 private:
  std::set<std::string> arrays_;
  std::string path_;
};

std::string comment_for(const KeyEntry& key, const std::string& note, bool optional) {
  std::string text = key.meaning;
  if (!key.accepted.empty()) text += (text.empty() ? "" : "; ") + key.accepted;
  std::string stand = key.fallback.starts_with("required") ? key.fallback : "";
  if (!note.empty())
    stand = note;
  else if (optional && stand.empty())
    stand = key.fallback == "left out"    ? "example"
            : key.fallback.front() == '"' ? "default"
                                          : "default " + key.fallback;
  return stand + (stand.empty() || text.empty() ? "" : ": ") + text;
}

std::string padded(std::string text) {
  text.resize(std::max(comment_column, text.size() + 2), ' ');
  return text;
}

// One line of a template with what the readers say about it.
std::string annotated_line(const std::string& line, const std::vector<KeyEntry>& keys, TablePath& table) {
  const auto mark = line.find(" #> ");
  const std::string shown = line.substr(0, mark), note = mark == std::string::npos ? "" : line.substr(mark + 4);
  if (shown.starts_with("## ")) return shown.substr(1);
  const bool optional = shown.starts_with("# ");
  const std::string live = optional ? shown.substr(2) : shown;
  if (live.starts_with('[')) {
    table.enter(live);
    const KeyEntry* key = find(keys, table.itself());
    const std::string text = !note.empty() ? note : key ? key->meaning : "";
    return text.empty() ? shown : padded(shown) + "# " + text;
  }
  const auto equals = live.find(" = ");
  if (equals == std::string::npos) return shown;
  const KeyEntry* key = find(keys, table.of(live.substr(0, equals)));
  if (!key) throw std::logic_error("a template has a key that no reader asks for: " + table.of(live.substr(0, equals)));
  const std::string comment = comment_for(*key, note, optional);
  return comment.empty() ? shown : padded(shown) + "# " + comment;
}

std::string annotated(const std::string& text, const std::vector<KeyEntry>& keys) {
  std::istringstream lines(text);
  TablePath table;
  std::string result;
  for (std::string line; std::getline(lines, line);) result += annotated_line(line, keys, table) + "\n";
  return result;
}

std::vector<TextFile> annotated_template(const NewArguments& asked) {
  const Keys extent = asked.all ? Keys::all : Keys::needed;
  if (asked.kind == "fit") return template_of("fit", extent);
  const FileKind& kind = file_kind(asked.kind);
  // A command that shares its kind of file has a template of its own where it needs other keys.
  const bool has_its_own = !asked.all && embedded_templates().contains(asked.kind + ".toml");
  auto files = template_of(has_its_own ? asked.kind : kind.name, extent);
  files.front().text = annotated(files.front().text, keys_of(kind));
  return files;
}

// The document under the name that was asked for, its tables beside it.
std::vector<TextFile> placed(std::vector<TextFile> files, const fs::path& document) {
  const std::string stem = document.stem().string();
  for (TextFile& file : files) {
    file.text = with_stem(file.text, stem);
    file.name = (document.parent_path() / with_stem(file.name, stem)).string();
  }
  files.front().name = document.string();
  return files;
}

}  // namespace

Exit run_new(const NewArguments& arguments, const Common& common) {
  const auto files = annotated_template(arguments);
  if (arguments.file.empty()) {
    fmt::print("{}", with_stem(files.front().text, "example"));
    return Exit::done;
  }
  const auto written = placed(files, arguments.file);
  for (const TextFile& file : written) {
    std::error_code error;
    if (fs::symlink_status(file.name, error).type() != fs::file_type::not_found)
      throw BadInput({file.name, 0, ""}, "a file that is there already", "the name of a new file");
  }
  for (const TextFile& file : written) write_file(file.name, file.text);
  if (!common.quiet)
    for (const TextFile& file : written) print("wrote " + file.name + "\n");
  return Exit::done;
}

}  // namespace percal::tools
