#include "percal/page/markdown.hpp"

#include <fmt/format.h>

#include "percal/page/table.hpp"

namespace percal::page {
namespace {

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return text;
}

std::string row(const std::vector<std::string>& cells, std::size_t columns) {
  std::string line = "|";
  for (std::size_t c = 0; c < columns; ++c) line += " " + (c < cells.size() ? cell(cells[c]) : "") + " |";
  return line + "\n";
}

struct MarkdownWriter {
  const std::string& figures;

  std::string operator()(const Sentence& sentence) const { return sentence.text + "\n\n"; }
  std::string operator()(const List& list) const {
    std::string text;
    for (const std::string& item : list.items)
      text += fmt::format("- {}{}\n", list.tone == Tone::warning ? "**Warning:** " : "", item);
    return text + "\n";
  }
  std::string operator()(const Table& table) const {
    const std::size_t columns = columns_of(table);
    std::string text = table.caption.empty() ? "" : "**" + table.caption + "**\n\n";
    text += row(table.rows.front(), columns) + "|";
    for (std::size_t c = 0; c < columns; ++c) text += is_column_of_numbers(table, c) ? " ---: |" : " --- |";
    text += "\n";
    for (std::size_t r = 1; r < table.rows.size(); ++r) text += row(table.rows[r], columns);
    for (const std::string& note : table.notes) text += "\n" + note + "\n";
    return text + "\n";
  }
  std::string operator()(const Figure& figure) const {
    return fmt::format("![{}]({}/{}.svg)\n\n{}\n\n", figure.alt, figures, figure.name, figure.caption);
  }
  std::string operator()(const Code& code) const { return "```\n" + code.text + "\n```\n\n"; }
};

}  // namespace

std::string markdown(const Page& page, Detail detail, const std::string& figures) {
  std::string text = "# " + page.title + "\n\n" + (page.summary.empty() ? "" : page.summary + "\n\n");
  for (const Section& section : page.sections) {
    if (detail == Detail::answer && section.detail == Detail::more) continue;
    text += "## " + section.title + "\n\n";
    for (const Block& block : section.blocks) text += std::visit(MarkdownWriter{figures}, block);
  }
  text.pop_back();
  return text;
}

}  // namespace percal::page
