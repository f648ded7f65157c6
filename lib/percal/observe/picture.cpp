#include "percal/observe/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "percal/base/error.hpp"
#include "percal/page/numbers.hpp"
#include "percal/plot/quoted.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

// What is shown, in radii.
struct Window {
  double left, right, bottom, top;
  double width() const { return right - left; }
  double height() const { return top - bottom; }
  bool holds(const Point& point) const {
    return point[0] >= left && point[0] <= right && point[1] >= bottom && point[1] <= top;  // false for NaN
  }
};

constexpr double beside = 4, below = 3,
                 above = 2;        // of the particle's radius: beside the axis, under tip, over surface
constexpr int longer_side = 1000;  // of the window, pixels
constexpr int left = 100, right = 150, top = 60, bottom = 80;  // margins, pixels
constexpr int letter = 9;                                      // of the title, pixels

Window window_of(const Frame& frame, const Problem& problem) {
  const double tip = std::isfinite(frame.moment.tip) ? std::clamp(frame.moment.tip, 0.0, problem.whole_depth() + 2) : 0;
  double widest = 0;
  for (const Point& point : frame.target.position)
    if (std::isfinite(point[0])) widest = std::max(widest, std::abs(point[0]));
  Window window{-beside, beside, -tip - below, above};
  for (const Point& point : frame.particle.position) {  // one that has gone aside is shown with what is around it
    if (!std::isfinite(point[0])) continue;
    window.left = std::min(window.left, point[0] - below);
    window.right = std::max(window.right, point[0] + below);
  }
  if (widest > 0) window.left = std::max(window.left, -widest), window.right = std::min(window.right, widest);
  return window;
}

// Sizes in pixels so that both axes have one scale, and the title has room.
std::string canvas(PictureFormat format, const Window& window, std::size_t title) {
  const double scale = longer_side / std::max(window.width(), window.height());
  const double inner_width = window.width() * scale, inner_height = window.height() * scale;
  const double width = std::max(left + inner_width + right, static_cast<double>(letter * (title + 4)));
  const double height = top + inner_height + bottom, more_left = (width - left - inner_width - right) / 2;
  std::string text;
  switch (format) {
    case PictureFormat::svg:
      text = fmt::format("set terminal svg size {:.0f},{:.0f} font 'sans,16' background rgb 'white'\n", width, height);
      break;
    case PictureFormat::pdf:
      text = fmt::format("set terminal pdfcairo size {:.2f}in,{:.2f}in font 'sans,12'\n", width / 96, height / 96);
      break;
    case PictureFormat::png:
      text = fmt::format("set terminal pngcairo size {:.0f},{:.0f} font 'sans,12' background rgb 'white'\n", width,
                         height);
  }
  const double from = (left + more_left) / width;
  return text +
         fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n", from, from + inner_width / width) +
         fmt::format("set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n", bottom / height, 1 - top / height);
}

struct Cells {
  std::string text;  // of a data block: each cell a surface of its own
  double largest_stretch = 1;
};

Cells cells_in(const Window& window, const TargetPiece& target, double unit) {
  Cells cells;
  for (std::size_t k = 0; k < target.states.size(); ++k) {
    if (target.eroded[k]) continue;
    const int* corner = target.corners.data() + 4 * k;
    const bool is_seen = std::any_of(corner, corner + 4, [&](int n) { return window.holds(target.position[n]); });
    const double stretch = target.states[k].stretches[0];
    if (!is_seen || !std::isfinite(stretch)) continue;
    cells.largest_stretch = std::max(cells.largest_stretch, stretch);
    for (const int a : {0, 1, 3, 2}) {
      const Point& point = target.position[corner[a]];
      cells.text += fmt::format("{:.5g} {:.5g} {:.4g}\n", point[0] * unit, -point[1] * unit, stretch);
      if (a == 1) cells.text += '\n';
    }
    cells.text += "\n\n";
  }
  return cells;
}

// All around: the mirror image closes what is half.
std::vector<Point> outline_of(const ParticlePiece& particle, bool is_half) {
  std::vector<Point> outline;
  for (const int n : particle.outline) outline.push_back(particle.position[n]);
  if (is_half)
    for (std::size_t k = outline.size(); k-- > 0;) outline.push_back({-outline[k][0], outline[k][1]});
  return outline;
}

std::string polygon(const std::vector<Point>& outline, double unit) {
  std::string text = "set object 1 polygon from ";
  for (const Point& point : outline) text += fmt::format("{:.6g},{:.6g} to ", point[0] * unit, -point[1] * unit);
  return text + fmt::format("{:.6g},{:.6g}", outline.front()[0] * unit, -outline.front()[1] * unit) +
         " front fillstyle solid border linecolor rgb '#202020' fillcolor rgb '#b8b8b8'\n";
}

}  // namespace

PictureFormat picture_format(const std::string& file, const std::string& key) {
  const std::string end = std::filesystem::path(file).extension().string();
  if (end == ".png") return PictureFormat::png;
  if (end == ".svg") return PictureFormat::svg;
  if (end == ".pdf") return PictureFormat::pdf;
  throw BadInput(Place{.file = "", .line = 0, .key = key}, in_quotes(file), "a file that ends in .png, .svg or .pdf");
}

std::string picture_script(const Frame& frame, const Problem& problem, const Scales& scales, PictureFormat format,
                           const std::string& title) {
  const Window window = window_of(frame, problem);
  const page::ShownUnit length = page::length_unit(std::max(window.width(), window.height()) * scales.radius);
  const double unit = scales.radius / length.size;  // of a radius
  const Cells cells = cells_in(window, frame.target, unit);
  std::string script = canvas(format, window, title.size());
  script +=
      "unset key\nset view map\nset size ratio -1\nset tics out nomirror scale 0.25\nset xtics offset 0,1\nset ytics "
      "offset -0.7,0\n";
  script += "set pm3d explicit corners2color c1 border retrace\n";
  script += "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n";
  script += fmt::format("set title {} noenhanced\n", gnuplot_quoted(title));
  script += fmt::format("set xlabel 'distance from the axis, {}' offset 0,1.5\nset ylabel 'depth, {}' rotate\n",
                        length.name, length.name);
  script += "set cblabel 'largest principal stretch'\n";
  script += fmt::format("set cbrange [1:{:.4g}]\n", std::max(cells.largest_stretch, 1.01));
  script += fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n", window.left * unit,
                        window.right * unit, -window.bottom * unit, -window.top * unit);
  const std::vector<Point> outline = outline_of(frame.particle, !problem.whole);
  const auto is_finite = [](const Point& p) { return std::isfinite(p[0] + p[1]); };
  if (!outline.empty() && std::all_of(outline.begin(), outline.end(), is_finite)) script += polygon(outline, unit);
  // A cell without area on top, so that there is always something to draw.
  const std::string nothing = fmt::format("0 {0:.6g} 1\n0 {0:.6g} 1\n", -window.bottom / 2 * unit);
  script += "$cells << END\n" + cells.text + nothing + "\n" + nothing + "END\n";
  script += "splot $cells using 1:2:3 with pm3d";
  if (!problem.whole) script += ", $cells using (-$1):2:3 with pm3d";
  return script + "\n";
}

}  // namespace percal
