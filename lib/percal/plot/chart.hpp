// A chart as data: axes and series. Drawn by gnuplot, kept as CSV.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace percal {

enum class Mark {
  line,
  dashes,
  points,
  points_with_bars,  // low and high are the ends of the bars
  band,              // between low and high; y may be left empty
};

struct Series {
  std::string name;  // in the key; empty: not listed
  Mark mark = Mark::line;
  int colour = 0;  // index into the palette, taken modulo its length; grey: -1
  std::vector<double> x = {}, y = {};
  std::vector<double> low = {}, high = {};  // of bars and bands, else empty
};

struct Axis {
  std::string label;  // with its unit: "stretch", "depth, um"
  bool logarithmic = false;
  std::optional<double> low = {}, high = {};              // of the range; free where not given
  std::vector<std::pair<double, std::string>> tics = {};  // empty: gnuplot's own
};

struct Chart {
  std::string title;
  Axis x, y;
  std::vector<Series> series = {};
  std::optional<Axis> upper = {};  // a second x axis above, x times upper_factor
  double upper_factor = 1;
  bool equal_scales = false;              // a unit is as long on either axis: a picture of something
  std::vector<std::string> remarks = {};  // comment lines at the head of the CSV
};

// To be kept as NAME.csv, NAME.svg, NAME.png.
struct Plot {
  std::string name;
  std::string csv;     // every point of every series: series,x,y,low,high with the axes' labels in the header
  std::string script;  // for gnuplot, without a terminal; empty: nothing to draw
};

Plot plot_of(const std::string& name, const Chart& chart);

// "#c8553d" for the index of a series, taken modulo the palette's length; grey for a negative one. Each is readable on a white page
// and on a dark one (contrast of 3 with both), and the first five differ for a reader who sees no red or no green, too.
std::string palette_colour(int index);

}  // namespace percal
