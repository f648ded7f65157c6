#include "percal/fit/points/thin_curves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

namespace percal {
namespace {

constexpr int bins = 1000, bins_of_two = 60;

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  int bin(double value, int count) const {
    return high > low ? std::min(count - 1, static_cast<int>((value - low) / (high - low) * count)) : 0;
  }
};

struct Crowd {
  Extent amount, across;
  std::size_t points = 0, left = 0;
};

// Takes `point` into the mean; errors are averaged in squares, none where one has none.
void take(StressPoint& mean, const StressPoint& point) {
  const double share = 1.0 / ++mean.rows;
  mean.strained.amount += share * (point.strained.amount - mean.strained.amount);
  mean.strained.across += share * (point.strained.across - mean.strained.across);
  mean.nominal_stress += share * (point.nominal_stress - mean.nominal_stress);
  if (!mean.standard_error || !point.standard_error)
    mean.standard_error.reset();
  else
    mean.standard_error = std::sqrt((1 - share) * *mean.standard_error * *mean.standard_error +
                                    share * *point.standard_error * *point.standard_error);
}

bool goes_on(const StressPoint& before, const StressPoint& point) {
  return before.strained.deformation == point.strained.deformation && *point.time >= *before.time;
}

void say_averaged(CurveData& data, Deformation deformation, std::size_t rows, std::size_t left) {
  data.sources.back().warnings.push_back(
      fmt::format("{}: {}: {} rows are averaged to {} points, which is all that a fit can tell apart; each counts as "
                  "many rows as it stands for.",
                  data.sources.back().file, word(deformation), rows, left));
}

// Runs of neighbours in time become one; a run ends with its history, whose first point stands alone.
void thin_in_time(CurveData& data, const std::map<Deformation, Crowd>& crowds) {
  std::vector<StressPoint> kept;
  std::map<Deformation, std::size_t> left;
  std::size_t in_history = 0;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const StressPoint& point = data.points[i];
    const std::size_t run = (crowds.at(point.strained.deformation).points + most_points - 1) / most_points;
    in_history = i > 0 && goes_on(data.points[i - 1], point) ? in_history + 1 : 0;
    if (in_history < 2 || (in_history - 1) % run == 0) {
      kept.push_back(point);
      ++left[point.strained.deformation];
      continue;
    }
    take(kept.back(), point);
    *kept.back().time += (*point.time - *kept.back().time) / kept.back().rows;
  }
  for (const auto& [deformation, crowd] : crowds)
    if (left[deformation] < crowd.points) say_averaged(data, deformation, crowd.points, left[deformation]);
  data.points = std::move(kept);
}

}  // namespace

void thin(CurveData& data) {
  std::map<Deformation, Crowd> crowds;
  for (const StressPoint& point : data.points) {
    Crowd& crowd = crowds[point.strained.deformation];
    crowd.amount.add(point.strained.amount);
    crowd.across.add(point.strained.across);
    ++crowd.points;
  }
  if (!data.points.empty() && data.points[0].time) return thin_in_time(data, crowds);
  std::map<std::tuple<Deformation, int, int>, std::size_t> place;
  std::vector<StressPoint> kept;
  for (const StressPoint& point : data.points) {
    Crowd& crowd = crowds[point.strained.deformation];
    if (crowd.points > most_points) {
      const bool two = point.strained.deformation == Deformation::biaxial;
      const auto [found, fresh] = place.try_emplace(
          {point.strained.deformation, crowd.amount.bin(point.strained.amount, two ? bins_of_two : bins),
           two ? crowd.across.bin(point.strained.across, bins_of_two) : 0},
          kept.size());
      if (!fresh) {
        take(kept[found->second], point);
        continue;
      }
    }
    ++crowd.left;
    kept.push_back(point);
  }
  for (const auto& [deformation, crowd] : crowds)
    if (crowd.left < crowd.points) say_averaged(data, deformation, crowd.points, crowd.left);
  data.points = std::move(kept);
}

}  // namespace percal
