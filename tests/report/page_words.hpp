// What a page says, for tests that look for it.
#pragma once
#include <string>

#include "percal/report/page.hpp"

namespace percal::test {

// Every text of a section's blocks, a line each; cells of a table's row are joined by " | ".
inline std::string words_of(const PageSection& section) {
  std::string words;
  const auto line = [&](const std::string& text) { words += text + "\n"; };
  for (const PageBlock& block : section.blocks) {
    if (const auto* paragraph = std::get_if<Paragraph>(&block)) line(paragraph->text);
    if (const auto* bullets = std::get_if<Bullets>(&block))
      for (const auto& item : bullets->items) line(item);
    if (const auto* table = std::get_if<PageTable>(&block)) {
      line(table->caption);
      for (const auto& row : table->rows) {
        std::string cells;
        for (const auto& cell : row) cells += (cells.empty() ? "" : " | ") + cell;
        line(cells);
      }
      for (const auto& note : table->notes) line(note);
    }
    if (const auto* figure = std::get_if<PageFigure>(&block)) line(figure->caption);
    if (const auto* kept = std::get_if<Preformatted>(&block)) line(kept->text);
  }
  return words;
}

inline std::string words_of(const Page& page) {
  std::string words = page.title + "\n" + page.summary + "\n";
  for (const PageSection& section : page.sections) words += words_of(section);
  return words;
}

inline const PageSection* section_of(const Page& page, const std::string& id) {
  for (const PageSection& section : page.sections)
    if (section.id == id) return &section;
  return nullptr;
}

inline const PageFigure* figure_of(const Page& page, const std::string& name) {
  for (const PageSection& section : page.sections)
    for (const PageBlock& block : section.blocks)
      if (const auto* figure = std::get_if<PageFigure>(&block); figure && figure->name == name) return figure;
  return nullptr;
}

inline const Series* series_of(const PageFigure& figure, const std::string& name) {
  for (const Series& series : figure.chart.series)
    if (series.name == name) return &series;
  return nullptr;
}

}  // namespace percal::test
