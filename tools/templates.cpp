#include "templates.hpp"

#include <sstream>

namespace percal::tools {

std::string uncommented(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    const bool alternative = line.find(" #> ") != std::string::npos;
    if (line.starts_with("# ") && !alternative) line.erase(0, 2);
    result += line + "\n";
  }
  return result;
}

std::string with_stem(std::string text, const std::string& stem) {
  const std::string word = "STEM";
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + stem.size()))
    text.replace(at, word.size(), stem);
  return text;
}

}  // namespace percal::tools
