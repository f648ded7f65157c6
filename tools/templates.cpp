#include "templates.hpp"

#include <algorithm>
#include <sstream>

namespace percal::tools {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string live(const std::string& line) { return line.starts_with("# ") ? line.substr(2) : line; }
std::string note_of(const std::string& line) {
  const auto mark = line.find(" #> ");
  return mark == std::string::npos ? "" : line.substr(mark + 4);
}

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size()))
    text.replace(at, word.size(), by);
  return text;
}

// The template with the alternative of this line in place of the keys of its table that the note names.
std::string with_alternative(std::vector<std::string> lines, std::size_t chosen) {
  const auto is_header = [](const std::string& line) { return live(line).starts_with('['); };
  const auto alternative = lines.begin() + static_cast<std::ptrdiff_t>(chosen);
  const auto last = std::find_if(alternative, lines.end(), is_header);
  auto first = alternative;
  while (first != lines.begin() && !is_header(*first)) --first;
  std::istringstream words(note_of(*alternative));
  for (std::string word; words >> word;)
    std::replace_if(
        first, last, [&](const std::string& line) { return live(line).starts_with(word + " = "); }, "");
  alternative->erase(alternative->find(" #> "));
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string document_name(const std::string& kind, Keys keys) {
  const std::string all = "variants/" + kind + "_all.toml";
  if (keys == Keys::all && embedded_templates().contains(all)) return all;
  return kind + (embedded_templates().contains(kind + ".csv") ? ".csv" : ".toml");
}

// An embedded document with the lines that it shares with others.
std::string document(const std::string& name) {
  const std::string shared = "solver_keys.toml";
  return replaced(embedded_templates().at(name), "#< " + shared + "\n", embedded_templates().at(shared));
}

}  // namespace

std::vector<TextFile> template_of(const std::string& kind, Keys keys) {
  const std::string name = document_name(kind, keys);
  std::vector<TextFile> files{{"STEM" + name.substr(name.rfind('.')), document(name)}};
  for (const auto& [other, text] : embedded_templates()) {
    const std::string table = "STEM" + other.substr(std::min(kind.size(), other.size()));
    if (other.starts_with(kind + "_") && files.front().text.find('"' + table + '"') != std::string::npos)
      files.push_back({table, text});
  }
  return files;
}

std::string uncommented(const std::string& text) {
  std::string result;
  for (const std::string& line : lines_of(text)) result += (note_of(line).empty() ? live(line) : line) + "\n";
  return result;
}

std::vector<std::string> sample_documents(const std::string& kind) {
  std::vector<std::string> names{document_name(kind, Keys::all)}, samples;  // the order of the keys is the first one's
  for (const auto& [name, text] : embedded_templates())
    if ((name == kind + ".toml" || name.starts_with("variants/" + kind + "_")) && name != names.front())
      names.push_back(name);
  for (const std::string& name : names) {
    const std::string text = document(name);
    const auto lines = lines_of(text);
    samples.push_back(uncommented(text));
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (note_of(lines[i]).starts_with("instead of ")) samples.push_back(uncommented(with_alternative(lines, i)));
  }
  return samples;
}

std::string with_stem(std::string text, const std::string& stem) { return replaced(std::move(text), "STEM", stem); }

}  // namespace percal::tools
