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

}  // namespace

std::vector<TextFile> template_of(const std::string& kind) {
  std::vector<TextFile> files;
  for (const auto& [name, text] : embedded_templates())
    if (name.starts_with(kind + "_")) files.push_back({"STEM" + name.substr(kind.size()), text});
  const bool table = embedded_templates().contains(kind + ".csv");
  const std::string ending = table ? ".csv" : ".toml", shared = "solver_keys.toml";
  files.insert(files.begin(), {"STEM" + ending, replaced(embedded_templates().at(kind + ending), "#< " + shared + "\n",
                                                         embedded_templates().at(shared))});
  return files;
}

std::string uncommented(const std::string& text) {
  std::string result;
  for (const std::string& line : lines_of(text)) result += (note_of(line).empty() ? live(line) : line) + "\n";
  return result;
}

std::vector<std::string> sample_documents(const std::string& kind) {
  const std::string text = template_of(kind).front().text;
  std::vector<std::string> documents{uncommented(text)};
  const auto lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (note_of(lines[i]).starts_with("instead of ")) documents.push_back(uncommented(with_alternative(lines, i)));
  for (const auto& [name, variant] : embedded_templates())
    if (name.starts_with("variants/" + kind + "_")) documents.push_back(variant);
  return documents;
}

std::string with_stem(std::string text, const std::string& stem) { return replaced(std::move(text), "STEM", stem); }

}  // namespace percal::tools
