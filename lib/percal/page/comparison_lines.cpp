// The lines in which two texts differ.
#include <algorithm>
#include <sstream>

#include "percal/page/comparison_of.hpp"

namespace percal::page {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

constexpr std::size_t most_cells = 4'000'000;  // of the table below, some 16 MB

// Line by line, for texts that are too long for more.
std::vector<ChangedLine> changed_in_place(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  std::vector<ChangedLine> changed;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const int line = static_cast<int>(i) + 1;
    if (i < a.size() && i < b.size() && a[i] == b[i]) continue;
    changed.push_back(
        {i < a.size() ? line : 0, i < b.size() ? line : 0, i < a.size() ? a[i] : "", i < b.size() ? b[i] : ""});
  }
  return changed;
}

}  // namespace

std::vector<ChangedLine> changed_lines(const std::string& first, const std::string& second) {
  const auto a = lines_of(first), b = lines_of(second);
  if (a.size() * b.size() > most_cells) return changed_in_place(a, b);
  // common[i][j]: length of the longest common subsequence of a from i on and b from j on.
  std::vector<std::vector<int>> common(a.size() + 1, std::vector<int>(b.size() + 1, 0));
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      common[i][j] = a[i] == b[j] ? 1 + common[i + 1][j + 1] : std::max(common[i + 1][j], common[i][j + 1]);
  std::vector<ChangedLine> changed;
  std::vector<std::size_t> only_a, only_b;  // since the last common line
  const auto flush = [&] {
    for (std::size_t k = 0; k < std::max(only_a.size(), only_b.size()); ++k) {
      ChangedLine line;
      if (k < only_a.size()) {
        line.first_line = static_cast<int>(only_a[k]) + 1;
        line.first = a[only_a[k]];
      }
      if (k < only_b.size()) {
        line.second_line = static_cast<int>(only_b[k]) + 1;
        line.second = b[only_b[k]];
      }
      changed.push_back(line);
    }
    only_a.clear();
    only_b.clear();
  };
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j]) {
      flush();
      ++i;
      ++j;
    } else if (j == b.size() || (i < a.size() && common[i + 1][j] >= common[i][j + 1])) {
      only_a.push_back(i++);
    } else {
      only_b.push_back(j++);
    }
  }
  flush();
  return changed;
}

}  // namespace percal::page
