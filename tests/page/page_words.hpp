// What a page says, for tests that look for it.
#pragma once
#include <string>

#include "percal/page/page.hpp"

namespace percal::test {

using page::Block;
using page::Code;
using page::Figure;
using page::List;
using page::Page;
using page::Section;
using page::Sentence;
using page::Table;

// Every text of a section's blocks, a line each; cells of a table's row are joined by " | ".
inline std::string words_of(const Section& section) {
  std::string words;
  const auto line = [&](const std::string& text) { words += text + "\n"; };
  for (const Block& block : section.blocks) {
    if (const auto* sentence = std::get_if<Sentence>(&block)) line(sentence->text);
    if (const auto* list = std::get_if<List>(&block))
      for (const auto& item : list->items) line(item);
    if (const auto* table = std::get_if<Table>(&block)) {
      line(table->caption);
      for (const auto& row : table->rows) {
        std::string cells;
        for (const auto& cell : row) cells += (cells.empty() ? "" : " | ") + cell;
        line(cells);
      }
      for (const auto& note : table->notes) line(note);
    }
    if (const auto* figure = std::get_if<Figure>(&block)) line(figure->caption);
    if (const auto* code = std::get_if<Code>(&block)) line(code->text);
  }
  return words;
}

inline std::string words_of(const Page& whole) {
  std::string words = whole.title + "\n" + whole.summary + "\n";
  for (const Section& section : whole.sections) words += words_of(section);
  return words;
}

inline const Section* section_of(const Page& whole, const std::string& id) {
  for (const Section& section : whole.sections)
    if (section.id == id) return &section;
  return nullptr;
}

inline const Figure* figure_of(const Page& whole, const std::string& name) {
  for (const Section& section : whole.sections)
    for (const Block& block : section.blocks)
      if (const auto* figure = std::get_if<Figure>(&block); figure && figure->name == name) return figure;
  return nullptr;
}

inline const Series* series_of(const Figure& figure, const std::string& name) {
  for (const Series& series : figure.chart.series)
    if (series.name == name) return &series;
  return nullptr;
}

}  // namespace percal::test
