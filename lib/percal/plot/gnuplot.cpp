#include "percal/plot/gnuplot.hpp"

#include <fmt/format.h>

#include "percal/base/child_process.hpp"
#include "percal/plot/svg.hpp"

namespace percal {

std::optional<std::string> gnuplot(const std::string& script) {
  const auto [ended_well, text] = answer_of({"gnuplot"}, script);
  return ended_well && !text.empty() ? std::optional(text) : std::nullopt;
}

std::optional<std::string> draw_svg(const Plot& plot, const Canvas& canvas, const std::string& prefix) {
  if (plot.script.empty()) return std::nullopt;
  const auto svg = gnuplot(fmt::format("set terminal svg size {},{} dynamic font \"sans,{}\"\n", canvas.width,
                                       canvas.height, canvas.font_size) +
                           plot.script);
  return svg ? std::optional(tidy_svg(*svg, prefix)) : std::nullopt;
}

std::optional<std::string> draw_svg(const Plot& plot) { return draw_svg(plot, wide_canvas, plot.name); }

std::optional<std::string> draw_png(const Plot& plot) {
  if (plot.script.empty()) return std::nullopt;
  return gnuplot(
      "set terminal pngcairo size 1080,660 pointscale 1.4 linewidth 1.2 font \"sans,13\" background rgb \"white\"\n" +
      plot.script);
}

}  // namespace percal
