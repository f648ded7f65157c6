#include "percal/page/figures.hpp"

#include <algorithm>
#include <filesystem>

#include "percal/base/threads.hpp"
#include "percal/plot/gnuplot.hpp"
#include "percal/plot/svg.hpp"
#include "percal/text/file.hpp"

namespace percal::page {
namespace {

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
std::string drawn(const Figure& figure) {
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

}  // namespace

std::vector<const Figure*> figures_of(const Page& page) {
  std::vector<const Figure*> all;
  for (const Section& section : page.sections)
    for (const Block& block : section.blocks)
      if (const auto* figure = std::get_if<Figure>(&block)) all.push_back(figure);
  return all;
}

DrawnFigures draw_figures(const Page& page) {
  const auto figures = figures_of(page);
  std::vector<std::string> texts(figures.size());
  side_by_side(threads_of_this_machine(), static_cast<int>(figures.size()),
               [&](int i) { texts[i] = drawn(*figures[i]); });
  DrawnFigures all;
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (!texts[i].empty()) all[figures[i]->name] = texts[i];
  return all;
}

bool write_figures(const Page& page, const std::string& folder, Pictures pictures) {
  bool drawn = true;
  for (const Figure* figure : figures_of(page)) {
    const Plot plot = plot_of(figure->name, figure->chart);
    const std::string file = (std::filesystem::path(folder) / plot.name).string();
    write_file(file + ".csv", plot.csv);
    const auto svg = draw_svg(plot);
    if (svg) write_file(file + ".svg", *svg);
    if (const auto png = pictures == Pictures::svg_and_png ? draw_png(plot) : std::nullopt)
      write_file(file + ".png", *png);
    drawn &= svg.has_value();
  }
  return drawn;
}

}  // namespace percal::page
