#include "help.hpp"

#include <algorithm>
#include <sstream>

#include "percal/page/text.hpp"

namespace percal::tools {
namespace {

// Where the words of a line begin that go below each other: behind its first run of blanks, else further in than a name.
std::size_t hang_of(const std::string& line) {
  const auto first = line.find_first_not_of(' ');
  const auto gap = line.find("  ", first);
  const auto words = gap == std::string::npos ? gap : line.find_first_not_of(' ', gap);
  return words != std::string::npos ? words : first == 2 ? first + 2 : first;
}

std::string fitted_line(const std::string& line, std::size_t columns) {
  if (line.size() <= columns) return line + "\n";
  const auto hang = std::min(hang_of(line), columns / 2);
  const auto start = std::min(hang, line.find_first_not_of(' '));
  const bool described = line.find("  ", start) < hang;
  const std::string head = described ? line.substr(0, hang) : std::string(start, ' ');
  std::string text;
  for (const std::string& words : page::folded(line.substr(head.size()), columns - hang))
    text += (text.empty() ? head : std::string(hang, ' ')) + words + "\n";
  return text;
}

// A command that is too long for the terminal goes on in the next line, as a shell reads it.
std::string fitted_example(const std::string& line, std::size_t columns) {
  const auto start = line.find("percal");
  if (line.size() <= columns || start == std::string::npos || start + 30 > columns) return line + "\n";
  std::string text;
  for (const std::string& words : page::folded(line.substr(start), columns - start - 4))
    text += (text.empty() ? line.substr(0, start) : " \\\n" + std::string(start + 2, ' ')) + words;
  return text + "\n";
}

}  // namespace

std::string fitted_help(const std::string& help, int columns) {
  if (columns <= 0) return help;
  std::istringstream lines(help);
  std::string text;
  const auto width = static_cast<std::size_t>(columns);
  bool examples = false;
  for (std::string line; std::getline(lines, line);) {
    examples = examples || line.starts_with("Example");
    text += examples ? fitted_example(line, width) : fitted_line(line, width);
  }
  return text;
}

}  // namespace percal::tools
