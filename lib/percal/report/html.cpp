#include "percal/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>
#include <stdexcept>
#include <thread>

#include "percal/base/version.hpp"
#include "percal/plot/gnuplot.hpp"
#include "percal/plot/svg.hpp"
#include "percal/report/style.hpp"
#include "percal/text/markup.hpp"

namespace percal {
namespace {

// --- tables -----------------------------------------------------------------------------------------------------

// "3.4 MPa", "-0.02", "+1 %": begins as a number does, and is short.
bool is_number(const std::string& cell) {
  const std::size_t first = cell.find_first_not_of("+-<>~ ");
  return first != std::string::npos && cell[first] >= '0' && cell[first] <= '9' && cell.size() <= 34;
}

bool is_blank(const std::string& cell) { return cell.empty() || cell == "-"; }

// A column of numbers is set right: most cells that say something are numbers, and the others are a word or two.
bool is_column_of_numbers(const PageTable& table, std::size_t column) {
  constexpr std::size_t short_text = 16;
  int of_numbers = 0, of_words = 0;
  for (std::size_t r = 1; r < table.rows.size(); ++r) {
    if (column >= table.rows[r].size() || is_blank(table.rows[r][column])) continue;
    const std::string& cell = table.rows[r][column];
    if (!is_number(cell) && cell.size() > short_text) return false;
    ++(is_number(cell) ? of_numbers : of_words);
  }
  return of_numbers > of_words;
}

// A first row of empty cells is none: names and values of any kind.
bool has_header(const PageTable& table) {
  const auto& cells = table.rows.front();
  return !std::all_of(cells.begin(), cells.end(), [](const std::string& cell) { return cell.empty(); });
}

std::string header_row(const PageTable& table, const std::vector<bool>& of_numbers) {
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
std::string rows_of(const PageTable& table, const std::string& kind) {
  if (table.rows.empty()) return "";
  std::size_t columns = 0;
  for (const auto& row : table.rows) columns = std::max(columns, row.size());
  std::vector<bool> of_numbers(columns, false);
  for (std::size_t c = 1; c < columns && has_header(table); ++c) of_numbers[c] = is_column_of_numbers(table, c);
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

PageTable points_of(const PageFigure& figure) {
  const Chart& chart = figure.chart;
  PageTable table{.caption = "points: " + figure.chart.title,
                  .rows = {{"series", chart.x.label, chart.y.label, "low", "high"}},
                  .notes = {}};
  for (const Series& one : chart.series)
    for (std::size_t i = 0; i < one.x.size(); ++i)
      table.rows.push_back({one.name, cell_of(one.x, i), cell_of(one.y, i), cell_of(one.low, i), cell_of(one.high, i)});
  return table;
}

std::string figure_of(const PageFigure& figure, const DrawnFigures& figures) {
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

  std::string operator()(const Paragraph& paragraph) const { return "<p>" + escaped(paragraph.text) + "</p>\n"; }
  std::string operator()(const Bullets& bullets) const {
    std::string text = "<ul>\n";
    for (const std::string& item : bullets.items) text += "<li>" + escaped(item) + "</li>\n";
    return text + "</ul>\n";
  }
  std::string operator()(const PageTable& table) const {
    return "<figure class=\"table\">\n" +
           (table.caption.empty() ? std::string()
                                  : "<figcaption><strong>" + escaped(table.caption) + "</strong></figcaption>\n") +
           rows_of(table, "scroll") + notes_of(table.notes) + "</figure>\n";
  }
  std::string operator()(const PageFigure& figure) const { return figure_of(figure, figures); }
  std::string operator()(const Preformatted& kept) const {
    return fmt::format(
        "<details><summary>{0}</summary>\n<pre class=\"scroll\" tabindex=\"0\" aria-label=\"{0}\">{1}</pre>\n"
        "</details>\n",
        escaped(kept.caption.empty() ? "text" : kept.caption), escaped(kept.text));
  }
};

std::string section_of(const PageSection& section, const DrawnFigures& figures) {
  std::string text = fmt::format("<section aria-labelledby=\"{0}\">\n<h2 id=\"{0}\">{1}</h2>\n", escaped(section.id),
                                 escaped(section.title));
  for (const PageBlock& block : section.blocks) text += std::visit(Renderer{figures}, block);
  return text + "</section>\n";
}

std::string contents_of(const Page& page) {
  std::string text = "<nav aria-label=\"Sections\">\n<ul>\n";
  for (const PageSection& section : page.sections)
    text += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", escaped(section.id), escaped(section.title));
  return text + "</ul>\n</nav>\n";
}

std::vector<const PageFigure*> figures_of(const Page& page) {
  std::vector<const PageFigure*> all;
  for (const PageSection& section : page.sections)
    for (const PageBlock& block : section.blocks)
      if (const auto* figure = std::get_if<PageFigure>(&block)) all.push_back(figure);
  return all;
}

// High enough for a key with many names, of which so many stand side by side, and for a long label of the upright axis.
Canvas with_room_for_words(Canvas canvas, const Chart& chart, int side_by_side) {
  constexpr double character = 0.62, below_axis = 100;  // width over the font's size; pixels under the axis
  const auto names =
      std::count_if(chart.series.begin(), chart.series.end(), [](const Series& s) { return !s.name.empty(); });
  const int lines = (static_cast<int>(names) + side_by_side - 1) / side_by_side;
  const double label = character * canvas.font_size * static_cast<double>(chart.y.label.size()) + below_axis;
  canvas.height = std::max(canvas.height, static_cast<int>(label));
  canvas.height += std::max(lines - 2, 0) * canvas.font_size * 3 / 2;
  return canvas;
}

// For wide and for narrow screens; the style sheet shows one of them. The title is in the caption.
std::string drawn(const PageFigure& figure) {
  Chart chart = figure.chart;
  chart.title.clear();
  const Plot plot = plot_of(figure.name, chart);
  const auto wide = draw_svg(plot, with_room_for_words(wide_canvas, chart, 3), plot.name);
  const auto narrow =
      wide ? draw_svg(plot, with_room_for_words(narrow_canvas, chart, 1), plot.name + "-narrow") : std::nullopt;
  if (!narrow) return "";
  return "<div class=\"wide\">" + inline_svg(*wide, figure.alt) + "</div>\n<div class=\"narrow\">" +
         inline_svg(*narrow, figure.alt) + "</div>\n";
}

// Links and ids would lead to the wrong place.
void require_unique_names(const Page& page) {
  std::set<std::string> names;
  for (const PageSection& section : page.sections)
    if (!names.insert(section.id).second) throw std::logic_error("two sections of a page are called " + section.id);
  for (const PageFigure* figure : figures_of(page))
    if (!names.insert("figure-" + figure->name).second)
      throw std::logic_error("two figures of a page are called " + figure->name);
}

}  // namespace

DrawnFigures draw_figures(const Page& page) {
  const auto figures = figures_of(page);
  std::vector<std::string> texts(figures.size());
  std::atomic<std::size_t> next = 0;
  const auto draw = [&] {
    for (std::size_t i; (i = next++) < figures.size();) texts[i] = drawn(*figures[i]);
  };
  std::vector<std::jthread> threads(std::min<std::size_t>(std::thread::hardware_concurrency(), figures.size()));
  for (auto& thread : threads) thread = std::jthread(draw);
  draw();
  threads.clear();  // joins
  DrawnFigures all;
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (!texts[i].empty()) all[figures[i]->name] = texts[i];
  return all;
}

std::string html(const Page& page, const DrawnFigures& figures) {
  require_unique_names(page);
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<meta name=\"generator\" content=\"percal {}\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n",
      escaped(version()), escaped(page.title), report_parts::style_sheet);
  text += "<header>\n<h1>" + escaped(page.title) + "</h1>\n";
  if (!page.summary.empty()) text += "<p class=\"summary\">" + escaped(page.summary) + "</p>\n";
  text += "</header>\n" + contents_of(page) + "<main>\n";
  for (const PageSection& section : page.sections) text += section_of(section, figures);
  return text + "</main>\n<footer>Written by percal " + escaped(version()) + " report.</footer>\n</body>\n</html>\n";
}

}  // namespace percal
