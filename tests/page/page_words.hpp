// What a page says, for tests that look for it.
#pragma once
#include <string>

#include "percal/page/page.hpp"

namespace percal::test {

// Every text of a section's blocks, a line each; cells of a table's row are joined by " | ".
inline std::string words_of(const Section& section) {
  std::string words;
  const auto line = [&](const std::string& text) { words += text + "\n"; };
  for (const Block& block : section.blocks) {
    if (const auto* paragraph = std::get_if<Sentence>(&block)) line(paragraph->text);
    if (const auto* bullets = std::get_if<List>(&block))
      for (const auto& item : bullets->items) line(item);
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
    if (const auto* kept = std::get_if<Code>(&block)) line(kept->text);
  }
  return words;
}

inline std::string words_of(const Page& page) {
  std::string words = page.title + "\n" + page.summary + "\n";
  for (const Section& section : page.sections) words += words_of(section);
  return words;
}

inline const Section* section_of(const Page& page, const std::string& id) {
  for (const Section& section : page.sections)
    if (section.id == id) return &section;
  return nullptr;
}

inline const Figure* figure_of(const Page& page, const std::string& name) {
  for (const Section& section : page.sections)
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
