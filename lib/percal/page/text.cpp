#include "percal/page/text.hpp"

#include <algorithm>
#include <sstream>

#include "percal/base/printable.hpp"
#include "percal/page/table.hpp"

namespace percal::page {
namespace {

using Row = std::vector<std::string>;

constexpr std::size_t least_folded_width = 16;

// Cells as a terminal may show them: names in a result are some file's.
Table printable_of(Table table) {
  for (Row& row : table.rows)
    for (std::string& cell : row) cell = printable(cell);
  return table;
}

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

std::string line_of(const Row& row, const std::vector<std::size_t>& widths, const std::vector<bool>& flush_right) {
  std::string line = " ";
  for (std::size_t c = 0; c < row.size(); ++c) {
    const std::string pad(widths[c] - characters(row[c]), ' ');
    line += (c == 0 ? " " : "  ") + (flush_right[c] ? pad + row[c] : row[c] + pad);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

// Columns of words made narrower until the table fits, the widest first, none below its header; further lines of a cell are rows of
// their own. Too wide still where there is nothing left to fold.
std::vector<Row> folded_to_fit(const Table& table, std::size_t room) {
  auto widths = widths_of(table.rows);
  const Row& header = table.rows.front();
  while (total(widths) > room) {
    std::size_t widest = widths.size(), most = least_folded_width;
    for (std::size_t c = 0; c < widths.size(); ++c) {
      const bool may_fold =
          !is_column_of_numbers(table, c) && (c >= header.size() || widths[c] > characters(header[c]));
      if (may_fold && widths[c] > most) most = widths[widest = c];
    }
    if (widest == widths.size()) break;
    --widths[widest];
  }
  std::vector<Row> result;
  for (const Row& row : table.rows) {
    std::vector<Row> lines(1, Row(row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) {
      const auto cell = folded(row[c], widths[c]);
      lines.resize(std::max(lines.size(), cell.size()), Row(row.size()));
      for (std::size_t k = 0; k < cell.size(); ++k) lines[k][c] = cell[k];
    }
    result.insert(result.end(), lines.begin(), lines.end());
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

// A terminal's escape codes.
std::string bold(const std::string& text, const TextStyle& style) {
  return style.colour ? "\033[1m" + text + "\033[0m" : text;
}
std::string yellow(const std::string& text, const TextStyle& style) {
  return style.colour ? "\033[33m" + text + "\033[0m" : text;
}

std::string plain(const Table& table, const std::vector<Row>& rows, const TextStyle& style) {
  const auto widths = widths_of(rows);
  std::vector<bool> flush_right(widths.size());
  for (std::size_t c = 0; c < widths.size(); ++c) flush_right[c] = is_column_of_numbers(table, c);
  std::string text;
  for (std::size_t r = has_header(table) ? 0 : 1; r < rows.size(); ++r) {
    const std::string line = line_of(rows[r], widths, flush_right);
    text += r == 0 ? bold(line.substr(0, line.size() - 1), style) + "\n" : line;
    if (r == 0) text += "  " + std::string(total(widths) - 2, '-') + "\n";
  }
  return text;
}

// Indented by two, folded where there are columns; further lines of a list's item are indented by `hang` more.
std::string sentence(const std::string& text, const TextStyle& style, std::size_t hang = 0) {
  const std::size_t indent = 2;
  const auto columns = static_cast<std::size_t>(style.columns);
  const auto room = columns > indent + hang + least_folded_width ? columns - indent - hang : std::string::npos;
  std::string all;
  for (const std::string& line : folded(printable(text), room))
    all += std::string(indent + (all.empty() ? 0 : hang), ' ') + line + "\n";
  return all;
}

struct TextWriter {
  const TextStyle& style;

  std::string operator()(const Sentence& words) const { return sentence(words.text, style); }
  std::string operator()(const List& list) const {
    std::string text;
    for (const std::string& item : list.items) {
      if (list.tone == Tone::plain) text += sentence("- " + item, style, 2);
      if (list.tone == Tone::plain) continue;
      const std::string mark = list.tone == Tone::note ? "note:" : "warning:";
      text += sentence(mark + " " + item, style, 2).replace(2, mark.size(), yellow(mark, style));
    }
    return text;
  }
  std::string operator()(const Table& table) const { return as_text(table, style); }
  std::string operator()(const Figure& figure) const {
    return sentence("[figure " + figure.name + "] " + figure.caption, style);
  }
  std::string operator()(const Code& code) const {
    const auto lines = std::count(code.text.begin(), code.text.end(), '\n');
    return sentence("[" + code.caption + ": " + std::to_string(lines) + " lines, in the result]", style);
  }
};

}  // namespace

std::vector<std::string> folded(const std::string& text, std::size_t width) {
  std::vector<std::string> lines{""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.back().empty() && characters(lines.back()) + 1 + characters(word) > width) lines.push_back("");
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

std::string as_text(const Table& written, const TextStyle& style) {
  const Table table = printable_of(written);
  if (table.rows.empty()) return "";
  std::string text = table.caption.empty() ? "" : sentence(table.caption, style);
  const auto widths = widths_of(table.rows);
  const auto room = static_cast<std::size_t>(style.columns);
  if (style.columns <= 0 || total(widths) <= room) {
    text += plain(table, table.rows, style);
  } else {
    const auto fit = folded_to_fit(table, room);
    text += total(widths_of(fit)) <= room ? plain(table, fit, style) : as_lists(table.rows);
  }
  for (const std::string& note : table.notes) text += sentence(note, style);
  return text;
}

std::string as_text(const Section& section, const TextStyle& style) {
  std::string text = bold(printable(section.title), style) + "\n";
  for (const Block& block : section.blocks) {
    const bool is_table = std::holds_alternative<Table>(block);
    if (is_table && &block != &section.blocks.front()) text += "\n";
    text += std::visit(TextWriter{style}, block);
  }
  return text + "\n";
}

std::string as_text(const Page& page, const TextStyle& style) {
  std::string text =
      bold(printable(page.title), style) + "\n" + (page.summary.empty() ? "" : sentence(page.summary, style)) + "\n";
  for (const Section& section : page.sections)
    if (section.detail == Detail::answer || style.detail == Detail::more) text += as_text(section, style);
  return text;
}

}  // namespace percal::page
