#include <algorithm>
#include <cmath>

#include "percal/base/progress.hpp"
#include "percal/base/threads.hpp"
#include "percal/estimate/profile.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

using Eigen::VectorXd;
using Point = Surroundings::Point;

constexpr double confidence = 0.95;
constexpr double margin = 0.15;  // around the region, of its width

std::vector<double> even(double low, double high, int count) {
  std::vector<double> values(count);
  for (int i = 0; i < count; ++i) values[i] = low + (high - low) * i / (count - 1);
  return values;
}

// Even steps over the part of the box in which the profile stays below the threshold, and some more.
std::vector<double> axis(const FreeParameter& free, const Profile& profile, int grid) {
  const double low = profile.down.end.searched[profile.interval.parameter];
  const double high = profile.up.end.searched[profile.interval.parameter], more = margin * (high - low);
  return even(std::max(low - more, free.searched(free.low)), std::min(high + more, free.searched(free.high)), grid);
}

int nearest(const std::vector<double>& axis, double value) {
  const auto distance = [value](double a) { return std::abs(a - value); };
  return static_cast<int>(std::ranges::min_element(axis, {}, distance) - axis.begin());
}

// Indices from the middle one to one end, then to the other; each after its neighbour.
std::vector<int> outwards(int middle, int count) {
  std::vector<int> order;
  for (int i = middle; i < count; ++i) order.push_back(i);
  for (int i = middle - 1; i >= 0; --i) order.push_back(i);
  return order;
}

// Each point starts from its neighbour's others: along the minimum's row first, then up and down every column.
Eigen::MatrixXd rises(const Surroundings& near, const RidgeMap& map, const std::vector<double>& x,
                      const std::vector<double>& y, int threads) {
  const auto columns = static_cast<int>(x.size()), rows = static_cast<int>(y.size());
  const VectorXd& bottom = near.minimum().searched;
  const int column0 = nearest(x, bottom[map.first]), row0 = nearest(y, bottom[map.second]);
  Eigen::MatrixXd rise(rows, columns);
  Progress progress("map of the ridge", static_cast<long>(rows) * columns);
  const auto solve = [&](int row, int column, VectorXd start) {
    start[map.first] = x[column];
    start[map.second] = y[row];
    const Point point = near.fit_others(start, {map.first, map.second});
    rise(row, column) = std::min(point.rise, no_answer_rise);
    progress.add();
    return point.searched;
  };
  std::vector<VectorXd> middle(columns);
  for (const int column : outwards(column0, columns))
    middle[column] =
        solve(row0, column, column == column0 ? bottom : middle[column > column0 ? column - 1 : column + 1]);
  side_by_side(threads, columns, [&](int column) {
    std::vector<VectorXd> of_row(rows);
    for (const int row : outwards(row0, rows))
      of_row[row] = row == row0 ? middle[column] : solve(row, column, of_row[row > row0 ? row - 1 : row + 1]);
  });
  return rise;
}

// Ends of walks along `path` in neighbouring columns, where a fit of the others may have been caught before the threshold: a column that
// its neighbour's end leads further goes on from there.
void lead_on(const Surroundings& near, const Path& path, int first, const std::vector<double>& x,
             std::vector<Point>& ends) {
  const int j = path.parameter, columns = static_cast<int>(x.size());
  const auto try_from = [&](int column, int neighbour) {
    VectorXd start = ends[neighbour].searched;
    if (path.direction * (start[j] - ends[column].searched[j]) <= 0) return;
    start[first] = x[column];
    const Point there = near.fit_others(start, {first, j});
    if (there.rise < path.threshold) ends[column] = walk(near, there, path).end;
  };
  for (int column = 1; column < columns; ++column) try_from(column, column - 1);
  for (int column = columns - 2; column >= 0; --column) try_from(column, column + 1);
}

// A ridge may be much narrower than the grid. So its outline is found column by column: from the valley's floor, where only the
// first parameter is held, up and down to the threshold.
std::vector<std::array<double, 2>> outline(const Surroundings& near, const RidgeMap& map, const Profile& along,
                                           int columns, int threads) {
  const Minimum& minimum = near.minimum();
  const auto& C = minimum.covariance;
  const int i = map.first, j = map.second;
  const double across = C(i, i) > 0 ? C(j, j) - C(i, j) * C(i, j) / C(i, i) : C(j, j);
  const double deviation = std::sqrt(std::max(across, 0.0));
  const auto x = even(along.down.end.searched[i], along.up.end.searched[i], columns);

  std::vector<Point> floor(columns);
  const int middle = nearest(x, minimum.searched[i]);
  for (const int column : outwards(middle, columns)) {
    VectorXd start = column == middle ? minimum.searched : floor[column > middle ? column - 1 : column + 1].searched;
    start[i] = x[column];
    floor[column] = near.fit_others(start, {i});
  }
  floor.front() = along.down.end;
  floor.back() = along.up.end;

  const auto is_tip = [&](const Point& point) { return !(point.rise < map.threshold * (1 - 1e-5)); };
  const Path down{j, -1, map.threshold, deviation, {i}}, up{j, 1, map.threshold, deviation, {i}};
  std::vector<Point> low = floor, high = floor;
  side_by_side(threads, columns, [&](int column) {
    if (is_tip(floor[column])) return;
    low[column] = walk(near, floor[column], down).end;
    high[column] = walk(near, floor[column], up).end;
  });
  lead_on(near, down, i, x, low);
  lead_on(near, up, i, x, high);
  std::vector<std::array<double, 2>> lower, upper;
  for (int column = 0; column < columns; ++column) {
    const bool tip = is_tip(floor[column]);
    if (tip && column > 0 && column + 1 < columns) continue;  // two regions: the saddle between them
    lower.push_back({low[column].searched[i], low[column].searched[j]});
    if (!tip) upper.push_back({high[column].searched[i], high[column].searched[j]});
  }
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
  lower.push_back(lower.front());
  return lower;
}

std::vector<double> natural(const FreeParameter& free, std::vector<double> values) {
  for (double& value : values) value = free.natural(value);
  return values;
}

}  // namespace

RidgeMap ridge_map(const CalibrationProblem& problem, const Minimum& minimum, int first, int second, int grid,
                   const SearchOptions& options) {
  const Surroundings near(problem, minimum);
  const auto p = static_cast<int>(problem.parameters.size());
  const FreeParameter &across = problem.parameters[first], &upwards = problem.parameters[second];
  const double freedom =
      std::min(near.degrees_of_freedom(VectorXd::Unit(p, first)), near.degrees_of_freedom(VectorXd::Unit(p, second)));
  RidgeMap map;
  map.first = first;
  map.second = second;
  map.threshold = 2 * f_quantile(confidence, 2, freedom);
  const Profile along = trace_profile(near, first, map.threshold), aside = trace_profile(near, second, map.threshold);
  const auto x = axis(across, along, grid), y = axis(upwards, aside, grid);
  map.rise = rises(near, map, x, y, options.threads);
  map.x = natural(across, x);
  map.y = natural(upwards, y);
  map.contours.push_back(outline(near, map, along, 2 * grid, options.threads));
  for (auto& point : map.contours[0]) point = {across.natural(point[0]), upwards.natural(point[1])};
  return map;
}

}  // namespace percal
