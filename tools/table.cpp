#include "table.hpp"

#include <algorithm>
#include <sstream>

#include "colour.hpp"

namespace percal::tools {
namespace {

using Row = std::vector<std::string>;

constexpr std::size_t least_folded_width = 16;

// UTF-8: every byte but a continuation byte starts a character.
std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::vector<std::size_t> widths_of(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], characters(row[c]));
  }
  return widths;
}

std::size_t total(const std::vector<std::size_t>& widths) {
  std::size_t sum = 0;
  for (const std::size_t width : widths) sum += width + 2;
  return sum;
}

std::string line_of(const Row& row, const std::vector<std::size_t>& widths) {
  std::string line = " ";
  for (std::size_t c = 0; c < row.size(); ++c) {
    const std::string pad(widths[c] - characters(row[c]), ' ');
    const bool flush_left = c == 0 || c + 1 == widths.size();
    line += (c == 0 ? " " : "  ") + (flush_left ? row[c] + pad : pad + row[c]);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

// Lines of at most so many characters, broken at blanks; a longer word stays whole.
std::vector<std::string> folded(const std::string& text, std::size_t width) {
  std::vector<std::string> lines{""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.back().empty() && characters(lines.back()) + 1 + characters(word) > width) lines.push_back("");
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

// Rows whose last cell is too long go on below themselves.
std::vector<Row> with_last_column_folded(const std::vector<Row>& rows, std::size_t columns, std::size_t width) {
  std::vector<Row> result;
  for (const Row& row : rows) {
    result.push_back(row);
    if (row.size() < columns) continue;
    const auto lines = folded(row.back(), width);
    result.back().back() = lines.front();
    for (std::size_t k = 1; k < lines.size(); ++k) {
      Row more(columns);
      more.back() = lines[k];
      result.push_back(more);
    }
  }
  return result;
}

// "first cell", then "  header: cell" line by line.
std::string as_lists(const std::vector<Row>& rows) {
  std::string text;
  for (std::size_t r = 1; r < rows.size(); ++r)
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const std::string head = c < rows[0].size() ? rows[0][c] : "";
      if (c == 0) text += "  " + rows[r][c] + "\n";
      if (c > 0 && !rows[r][c].empty()) text += "    " + (head.empty() ? "" : head + ": ") + rows[r][c] + "\n";
    }
  return text;
}

std::string plain(const std::vector<Row>& rows) {
  const auto widths = widths_of(rows);
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    text += line_of(rows[r], widths);
    if (r == 0) text += "  " + std::string(total(widths) - 2, '-') + "\n";
  }
  return text;
}

}  // namespace

std::string aligned_within(const std::vector<Row>& rows, int columns) {
  const auto widths = widths_of(rows);
  if (widths.empty()) return "";
  const auto room = static_cast<std::size_t>(columns);
  if (columns <= 0 || total(widths) <= room) return plain(rows);
  const std::size_t others = total(widths) - widths.back();
  if (others + least_folded_width > room) return as_lists(rows);
  const auto fit = with_last_column_folded(rows, widths.size(), room - others);
  return total(widths_of(fit)) <= room ? plain(fit) : as_lists(rows);
}

std::string aligned(const std::vector<Row>& rows) {
  std::string text = aligned_within(rows, terminal_columns());
  const auto end = text.find('\n');
  const bool has_header = text.compare(end + 1, 5, "  ---") == 0;
  if (end != std::string::npos && has_header) text = bold(text.substr(0, end)) + text.substr(end);
  return text;
}

}  // namespace percal::tools
