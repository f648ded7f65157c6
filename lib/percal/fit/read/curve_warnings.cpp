#include "percal/fit/read/curve_warnings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "percal/page/numbers.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr double percent_likely = 5;  // a strain; the best rubbers break at about 7
constexpr double longest_stretch = 10;
constexpr double noise = 0.01;  // of the largest stress: signs below it mean nothing

// Of the chosen numbers the one that lies farthest from `zero`, as a difference.
double farthest(const std::vector<double>& values, const std::vector<bool>& chosen, double zero) {
  double found = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (chosen[i] && std::abs(values[i] - zero) > std::abs(found)) found = values[i] - zero;
  return found;
}

void turn(std::vector<double>& values, const std::vector<bool>& chosen) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (chosen[i] && values[i] != 0) values[i] = -values[i];
}

bool is_stretch(Abscissa abscissa) { return abscissa == Abscissa::stretch || abscissa == Abscissa::stretch_or_gamma; }

// Where the sign of the stress is that of stretch - 1.
bool signs_agree(Deformation deformation) {
  return deformation != Deformation::simple_shear && deformation != Deformation::biaxial;
}

}  // namespace

void turn_compression(CurveNumbers& numbers, const CsvTable& table, const FoundColumns& found,
                      const std::vector<bool>& compressed, std::vector<std::string>& warnings) {
  const bool stretch = is_stretch(found.x_words.abscissa);
  const std::string &x = table.columns[static_cast<std::size_t>(found.x)].header,
                    &y = table.columns[static_cast<std::size_t>(found.y)].header;
  const bool x_positive = farthest(numbers.x, compressed, stretch ? 1 : 0) > 0;
  const bool y_positive = farthest(numbers.y, compressed, 0) > 0;
  if (stretch && x_positive)
    throw BadInput({table.file, table.header_line, x}, "compression, but stretches above 1",
                   "stretches below 1, a column of strain, or another mode");
  if (x_positive) turn(numbers.x, compressed);
  if (y_positive) turn(numbers.y, compressed);
  if (!x_positive && !y_positive) return;
  const std::string columns =
      x_positive && y_positive ? in_quotes(x) + " and " + in_quotes(y) : in_quotes(x_positive ? x : y);
  warnings.push_back(
      fmt::format("{}: compression written with positive numbers: the signs of {} are turned.", table.file, columns));
}

std::vector<std::string> implausible(const CsvTable& table, const FoundColumns& found, const std::vector<double>& given,
                                     const std::vector<StressPoint>& points) {
  std::vector<std::string> sentences;
  const CsvColumn& x = table.columns[static_cast<std::size_t>(found.x)];
  double largest = 0, largest_stress = 0;
  for (const double value : given) largest = std::max(largest, std::abs(value));
  const bool stretch = is_stretch(found.x_words.abscissa);
  if (x.unit.empty() && found.x_words.size == 1 && largest >= (stretch ? longest_stretch : percent_likely))
    sentences.push_back(
        fmt::format("{}: column {} goes to {:.4g}, a {} of {:.4g} %: if its numbers are percent, write {} "
                    "into the header.",
                    table.file, in_quotes(x.header), largest, stretch ? "stretch" : "strain", 100 * largest,
                    in_quotes(x.name + " [%]")));
  for (const auto& point : points) largest_stress = std::max(largest_stress, std::abs(point.nominal_stress));
  int pushed = 0, pulled = 0;
  for (const StressPoint& point : points) {
    const auto& [strained, stress] = std::tie(point.strained, point.nominal_stress);
    if (!signs_agree(strained.deformation) || std::abs(stress) <= noise * largest_stress) continue;
    pushed += strained.amount < 1 && stress > 0;
    pulled += strained.amount > 1 && stress < 0;
  }
  for (const auto& [count, side, sign] : {std::tuple{pushed, "below", "positive"}, {pulled, "above", "negative"}})
    if (count > 0)
      sentences.push_back(
          fmt::format("{}: {} of {} points have a stretch {} 1 and a {} stress, which no solid at rest "
                      "has: check the signs.",
                      table.file, count, points.size(), side, sign));
  return sentences;
}

}  // namespace percal
