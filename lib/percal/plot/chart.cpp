#include "percal/plot/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "percal/plot/quoted.hpp"

namespace percal {
namespace {

// Lists may be shorter than x: what is not there is no number.
double at(const std::vector<double>& values, std::size_t i) { return i < values.size() ? values[i] : NAN; }

// Beyond, gnuplot's tics never end; no quantity goes there.
constexpr double smallest_drawn = 1e-100, largest_drawn = 1e100;
constexpr double flat = 1e-12;  // a span, over the largest value: numbers that differ by rounding

bool can_be_drawn(double value, const Axis& axis) {
  return std::abs(value) <= largest_drawn && (!axis.logarithmic || value >= smallest_drawn);
}

// --- axes -------------------------------------------------------------------------------------------------------

struct Extent {
  double low = HUGE_VAL, high = -HUGE_VAL;

  void take(double value, const Axis& axis) {
    if (!can_be_drawn(value, axis)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool is_empty() const { return low > high; }
};

// Of everything that is drawn, with room on both sides; the axis' own ends where it has them.
Extent with_room(Extent extent, const Axis& axis) {
  if (extent.is_empty()) extent = axis.logarithmic ? Extent{1, 10} : Extent{0, 1};
  if (axis.logarithmic) {
    const double room = std::max(std::pow(extent.high / extent.low, 0.04), 1.1);
    extent = {extent.low / room, extent.high * room};
  } else {
    const double span = extent.high - extent.low, size = std::max(std::abs(extent.low), std::abs(extent.high));
    const double room = span > std::max(flat * size, smallest_drawn) ? 0.03 * span : std::max(size, 1.0) * 0.1;
    extent = {extent.low - room, extent.high + room};
  }
  const auto own_or = [&](const std::optional<double>& own, double found) {
    return own && can_be_drawn(*own, axis) ? *own : found;
  };
  const Extent own{own_or(axis.low, extent.low), own_or(axis.high, extent.high)};
  return own.high - own.low > flat * std::abs(own.high) ? own : extent;
}

Extent extent_of_x(const Chart& chart) {
  Extent extent;
  for (const Series& one : chart.series)
    for (const double x : one.x) extent.take(x, chart.x);
  return with_room(extent, chart.x);
}

Extent extent_of_y(const Chart& chart) {
  Extent extent;
  for (const Series& one : chart.series)
    for (const auto* values : {&one.y, &one.low, &one.high})
      for (const double y : *values) extent.take(y, chart.y);
  return with_room(extent, chart.y);
}

// 1, 10, 100, ..; with steps between them where the axis spans few decades.
std::vector<double> logarithmic_tics(const Extent& extent) {
  const double decades = std::log10(extent.high / extent.low);
  std::vector<double> steps{1};
  if (decades < 3) steps = {1, 2, 5};
  if (decades < 1) steps = {1, 1.5, 2, 3, 4, 5, 6, 8};
  if (decades < 0.3) steps.clear();  // gnuplot's own
  std::vector<double> tics;
  for (int decade = static_cast<int>(std::floor(std::log10(extent.low))); decade <= std::log10(extent.high); ++decade)
    for (const double step : steps)
      if (const double at = step * std::pow(10, decade); extent.low <= at && at <= extent.high) tics.push_back(at);
  return tics;
}

// Of a character of a label over the length of a horizontal axis on a phone, the gap between two labels counted in.
constexpr double width_of_character = 0.032;

std::string tics_of(const std::string& name, const Axis& axis, const Extent& extent) {
  std::string listed;
  const auto add = [&](const std::string& label, double place) {
    listed += fmt::format("{}{} {:.9g}", listed.empty() ? "" : ", ", gnuplot_quoted(label), place);
  };
  for (const auto& [place, label] : axis.tics) add(label, place);
  if (listed.empty() && axis.logarithmic) {
    const double decades = std::log10(extent.high / extent.low);
    double free_from = -HUGE_VAL;  // where the last label ends, as a share of the axis
    for (const double place : logarithmic_tics(extent)) {
      const std::string label = fmt::format("{:.6g}", place);
      const double middle = std::log10(place / extent.low) / decades;
      const double half = name.starts_with('x') ? 0.5 * width_of_character * static_cast<double>(label.size()) : 0;
      if (middle - half < free_from) continue;
      add(label, place);
      free_from = middle + half;
    }
  }
  return fmt::format("set {}tics {} noenhanced\n", name, listed.empty() ? "autofreq" : "(" + listed + ")");
}

std::string axis_of(const std::string& name, const Axis& axis, const Extent& extent) {
  return fmt::format("set {0}label {1} noenhanced{5}\n{2}set {0}range [{3:.9g}:{4:.9g}]\n", name,
                     gnuplot_quoted(axis.label), axis.logarithmic ? "set logscale " + name + "\n" : "", extent.low,
                     extent.high, name == "x" ? " offset 0,0.4" : "") +
         tics_of(name, axis, extent);
}

std::string axes_of(const Chart& chart) {
  const Extent x = extent_of_x(chart);
  std::string text = axis_of("x", chart.x, x) + axis_of("y", chart.y, extent_of_y(chart));
  if (!chart.upper) return text + "set border 3 lw 0.8\n";
  Axis upper = *chart.upper;
  upper.logarithmic = chart.x.logarithmic;
  return text + axis_of("x2", upper, {x.low * chart.upper_factor, x.high * chart.upper_factor}) +
         "set border 7 lw 0.8\n";
}

// --- series -----------------------------------------------------------------------------------------------------

bool has_bounds(const Series& one) { return one.mark == Mark::band || one.mark == Mark::points_with_bars; }

// x y low high; an empty line, where the line is broken, for a point that cannot be drawn.
std::string data_of(const Series& one, const Chart& chart) {
  std::string text;
  for (std::size_t i = 0; i < one.x.size(); ++i) {
    double y = at(one.y, i), low = at(one.low, i), high = at(one.high, i);
    if (one.mark == Mark::points_with_bars && can_be_drawn(y, chart.y)) {
      if (!can_be_drawn(low, chart.y)) low = y;  // a bar without an end
      if (!can_be_drawn(high, chart.y)) high = y;
    }
    if (one.mark == Mark::band && !can_be_drawn(y, chart.y)) y = high;
    const bool drawn = can_be_drawn(one.x[i], chart.x) && can_be_drawn(y, chart.y) &&
                       (!has_bounds(one) || (can_be_drawn(low, chart.y) && can_be_drawn(high, chart.y)));
    if (!drawn)
      text += "\n";
    else if (has_bounds(one))
      text += fmt::format("{:.7g} {:.7g} {:.7g} {:.7g}\n", one.x[i], y, low, high);
    else
      text += fmt::format("{:.7g} {:.7g}\n", one.x[i], y);
  }
  return text;
}

// A shape for each colour, so that a reader who sees no colours tells them apart.
int shape_of(int colour) {
  constexpr std::array shapes{7, 5, 9, 13, 11, 6, 4, 8};
  return colour < 0 ? 7 : shapes[static_cast<std::size_t>(colour) % shapes.size()];
}

std::string style_of(const Series& one) {
  const std::string colour = fmt::format("lc rgb \"{}\"", palette_colour(one.colour));
  switch (one.mark) {
    case Mark::line: return "using 1:2 with lines lw 1.8 " + colour;
    case Mark::dashes: return "using 1:2 with lines lw 1.4 dt 2 " + colour;
    case Mark::points: return fmt::format("using 1:2 with points pt {} ps 0.7 {}", shape_of(one.colour), colour);
    case Mark::points_with_bars:
      return fmt::format("using 1:2:3:4 with yerrorbars pt {} ps 0.7 lw 1.2 {}", shape_of(one.colour), colour);
    case Mark::band: return "using 1:3:4 with filledcurves fs transparent solid 0.22 noborder " + colour;
  }
  return "";
}

std::string csv_of(const Chart& chart) {
  std::string csv;
  for (const std::string& remark : chart.remarks) {
    std::string line = remark;
    std::replace(line.begin(), line.end(), '\n', ' ');
    csv += "# " + line + "\n";
  }
  csv += fmt::format("series,{},{},low,high\n", csv_quoted(chart.x.label), csv_quoted(chart.y.label));
  const auto cell = [](double value) { return std::isfinite(value) ? fmt::format("{:.9g}", value) : std::string(); };
  for (const Series& one : chart.series)
    for (std::size_t i = 0; i < one.x.size(); ++i)
      csv += fmt::format("{},{},{},{},{}\n", csv_quoted(one.name), cell(one.x[i]), cell(at(one.y, i)),
                         cell(at(one.low, i)), cell(at(one.high, i)));
  return csv;
}

}  // namespace

std::string palette_colour(int index) {
  constexpr std::array colours{"#d55e00", "#0072b2", "#693cff", "#a55a3c", "#7878ff", "#3c96b4", "#0fa569", "#4ba52d"};
  return index < 0 ? "#808080" : colours[static_cast<std::size_t>(index) % colours.size()];
}

Plot plot_of(const std::string& name, const Chart& chart) {
  std::string blocks, drawn;
  int count = 0;
  for (const Series& one : chart.series) {
    const std::string data = data_of(one, chart);
    if (data.find_first_not_of('\n') == std::string::npos) continue;
    blocks += fmt::format("$s{} << EOD\n{}EOD\n", ++count, data);
    drawn += fmt::format("{}$s{} {} {}", drawn.empty() ? "plot " : ", \\\n     ", count, style_of(one),
                         one.name.empty() ? "notitle" : "title " + gnuplot_quoted(one.name));
  }
  if (count == 0) return {name, csv_of(chart), ""};
  return {name, csv_of(chart),
          (chart.title.empty() ? "" : fmt::format("set title {} noenhanced\n", gnuplot_quoted(chart.title))) +
              "set encoding utf8\nset tics nomirror out scale 0.6\nset pointintervalbox 0\nset key below Left reverse "
              "samplen 1.5 height 0.6 noenhanced\n" +
              axes_of(chart) + (chart.equal_scales ? "set size ratio -1\n" : "") + "set grid lt 1 lw 0.5 lc rgb \"#bb808080\"\n" + blocks + drawn + "\n"};
}

}  // namespace percal
