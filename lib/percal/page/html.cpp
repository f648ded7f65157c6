#include "percal/page/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "percal/base/version.hpp"
#include "percal/page/style.hpp"
#include "percal/page/table.hpp"
#include "percal/text/markup.hpp"

namespace percal::page {
namespace {

// --- tables -----------------------------------------------------------------------------------------------------

std::string header_row(const Table& table, const std::vector<bool>& of_numbers) {
  if (!has_header(table)) return "";
  const auto& cells = table.rows.front();
  std::string text = "<thead><tr>";
  for (std::size_t c = 0; c < cells.size(); ++c)
    text += cells[c].empty() ? "<td></td>"
                             : fmt::format("<th scope=\"col\"{}>{}</th>", of_numbers[c] ? " class=\"number\"" : "",
                                           escaped(cells[c]));
  return text + "</tr></thead>\n";
}

std::string body_row(const std::vector<std::string>& cells, const std::vector<bool>& of_numbers) {
  constexpr std::size_t long_name = 14, long_text = 40;  // so long that they need room to break into lines
  std::string text = "<tr>";
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const bool is_long = cells[c].size() > (c == 0 ? long_name : long_text);
    const char* const kind = of_numbers[c] ? " class=\"number\"" : is_long ? " class=\"words\"" : "";
    const std::string cell = kind + (">" + escaped(cells[c]));
    text += c == 0 ? "<th scope=\"row\"" + cell + "</th>" : "<td" + cell + "</td>";
  }
  return text + "</tr>\n";
}

// The rows in a box of their own, which scrolls where the page is narrow.
std::string rows_of(const Table& table, const std::string& kind) {
  if (table.rows.empty()) return "";
  std::vector<bool> of_numbers(columns_of(table));
  for (std::size_t c = 0; c < of_numbers.size(); ++c) of_numbers[c] = is_column_of_numbers(table, c);
  std::string text = fmt::format("<div class=\"{}\" role=\"region\" tabindex=\"0\" aria-label=\"{}\"><table>\n", kind,
                                 escaped(table.caption.empty() ? "table" : table.caption)) +
                     header_row(table, of_numbers) + "<tbody>\n";
  for (std::size_t r = 1; r < table.rows.size(); ++r) text += body_row(table.rows[r], of_numbers);
  return text + "</tbody></table></div>\n";
}

std::string notes_of(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += "<p class=\"notes\">" + escaped(note) + "</p>\n";
  return text;
}

// --- figures ----------------------------------------------------------------------------------------------------

std::string cell_of(const std::vector<double>& values, std::size_t i) {
  return i < values.size() && std::isfinite(values[i]) ? fmt::format("{:.5g}", values[i]) : "-";
}

Table points_of(const Figure& figure) {
  const Chart& chart = figure.chart;
  Table table{.caption = "points: " + figure.chart.title,
              .rows = {{"series", chart.x.label, chart.y.label, "low", "high"}},
              .notes = {}};
  for (const Series& one : chart.series)
    for (std::size_t i = 0; i < one.x.size(); ++i)
      table.rows.push_back({one.name, cell_of(one.x, i), cell_of(one.y, i), cell_of(one.low, i), cell_of(one.high, i)});
  return table;
}

std::string figure_of(const Figure& figure, const DrawnFigures& figures) {
  const auto drawn = figures.find(figure.name);
  std::string text = fmt::format("<figure class=\"plot\" id=\"figure-{}\">\n", escaped(figure.name));
  if (drawn != figures.end())
    text += drawn->second;
  else
    text += "<p class=\"notes\">This plot was not drawn, since gnuplot is not there or failed. Its points are:</p>\n" +
            rows_of(points_of(figure), "scroll points");
  text += "<figcaption>";
  if (!figure.chart.title.empty()) text += "<strong>" + escaped(figure.chart.title) + "</strong> ";
  return text + "<span class=\"what\">" + escaped(figure.caption) + "</span></figcaption>\n</figure>\n";
}

// --- blocks and sections ----------------------------------------------------------------------------------------

struct Renderer {
  const DrawnFigures& figures;

  std::string operator()(const Sentence& sentence) const { return "<p>" + escaped(sentence.text) + "</p>\n"; }
  std::string operator()(const List& list) const {
    std::string text = "<ul>\n";
    for (const std::string& item : list.items)
      text += (list.tone == Tone::warning ? "<li><strong>Warning:</strong> " : "<li>") + escaped(item) + "</li>\n";
    return text + "</ul>\n";
  }
  std::string operator()(const Table& table) const {
    if (table.folded)
      return "<details><summary>" + escaped(table.caption) + "</summary>\n" + rows_of(table, "scroll") +
             notes_of(table.notes) + "</details>\n";
    return "<figure class=\"table\">\n" +
           (table.caption.empty() ? std::string()
                                  : "<figcaption><strong>" + escaped(table.caption) + "</strong></figcaption>\n") +
           rows_of(table, "scroll") + notes_of(table.notes) + "</figure>\n";
  }
  std::string operator()(const Figure& figure) const { return figure_of(figure, figures); }
  std::string operator()(const Code& kept) const {
    return fmt::format(
        "<details><summary>{0}</summary>\n<pre class=\"scroll\" tabindex=\"0\" aria-label=\"{0}\">{1}</pre>\n"
        "</details>\n",
        escaped(kept.caption.empty() ? "text" : kept.caption), escaped(kept.text));
  }
};

std::string section_of(const Section& section, const DrawnFigures& figures) {
  std::string text = fmt::format("<section aria-labelledby=\"{0}\">\n<h2 id=\"{0}\">{1}</h2>\n", escaped(section.id),
                                 escaped(section.title));
  for (const Block& block : section.blocks) text += std::visit(Renderer{figures}, block);
  return text + "</section>\n";
}

std::string contents_of(const Page& page) {
  std::string text = "<nav aria-label=\"Sections\">\n<ul>\n";
  for (const Section& section : page.sections)
    text += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", escaped(section.id), escaped(section.title));
  return text + "</ul>\n</nav>\n";
}

// Links and ids would lead to the wrong place.
void require_unique_names(const Page& page) {
  std::set<std::string> names;
  for (const Section& section : page.sections)
    if (!names.insert(section.id).second) throw std::logic_error("two sections of a page are called " + section.id);
  for (const Figure* figure : figures_of(page))
    if (!names.insert("figure-" + figure->name).second)
      throw std::logic_error("two figures of a page are called " + figure->name);
}

}  // namespace

std::string html(const Page& page, const DrawnFigures& figures) {
  require_unique_names(page);
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<meta name=\"generator\" content=\"percal {}\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n",
      escaped(version()), escaped(page.title), style_sheet);
  text += "<header>\n<h1>" + escaped(page.title) + "</h1>\n";
  if (!page.summary.empty()) text += "<p class=\"summary\">" + escaped(page.summary) + "</p>\n";
  text += "</header>\n" + contents_of(page) + "<main>\n";
  for (const Section& section : page.sections) text += section_of(section, figures);
  return text + "</main>\n<footer>Written by percal " + escaped(version()) + " report.</footer>\n</body>\n</html>\n";
}

}  // namespace percal::page
