#include "percal/estimate/profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "percal/base/progress.hpp"
#include "percal/base/threads.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

using Eigen::VectorXd;
using Point = Surroundings::Point;

constexpr double first_step = 0.5;    // of the distance at which the linearised profile meets the threshold
constexpr double wanted_gain = 0.25;  // of sqrt(threshold), from one step to the next
constexpr double longest_step = 1 / 12.0, shortest_step = 1e-6;  // of the box
constexpr double root_tolerance = 1e-6;                          // of sqrt(threshold)

// The rise is nearly quadratic, so its root is nearly linear: that is what steps and interpolation use.
double height(const Point& point) { return std::sqrt(std::max(point.rise, 0.0)); }

// One walk's way of fitting and of closing in on the threshold.
struct Walker {
  const Surroundings& surroundings;
  const Path& path;
  std::vector<int> held;
  double goal;  // sqrt(threshold)

  double place(const Point& point) const { return point.searched[path.parameter]; }

  // With the other parameters where a line through two neighbours has them.
  Point at(double x, const Point& near, const Point& further) const {
    VectorXd start = near.searched;
    if (place(near) != place(further))
      start += (x - place(near)) / (place(near) - place(further)) * (near.searched - further.searched);
    for (const int k : path.also_held) start[k] = near.searched[k];
    start[path.parameter] = x;
    return surroundings.fit_others(start, held);
  }

  // Between a point below the goal and one above it: secants, with the stale end's excess halved (Illinois).
  Point root(Point below, Point above, std::vector<Point>& visited) const {
    double low = height(below) - goal, high = height(above) - goal;
    const double box = std::abs(place(above) - place(below));
    for (int step = 0; step < 60 && std::abs(place(above) - place(below)) > 1e-10 * box; ++step) {
      const double share = std::isfinite(high) ? -low / (high - low) : 0.5;
      const double x = place(below) + share * (place(above) - place(below));
      const Point middle = at(x, below, std::isfinite(high) ? above : below);
      visited.push_back(middle);
      const double excess = height(middle) - goal;
      if (std::abs(excess) <= root_tolerance * goal) return middle;
      if (excess < 0) {
        below = middle;
        low = excess;
        high /= 2;
      } else {
        above = middle;
        high = excess;
        low /= 2;
      }
    }
    return below;
  }
};

// Ends that only another parameter's bound made: the data did not stop there.
bool at_anothers_bound(const Surroundings& surroundings, const Point& end, int parameter) {
  const CalibrationProblem& problem = surroundings.problem();
  for (int k = 0; k < end.searched.size(); ++k)
    if (k != parameter && !surroundings.minimum().at_bound[k] && at_bound(problem, end.searched, k) != AtBound::no)
      return true;
  return false;
}

// Not from bound to bound, nor too wide.
bool is_identifiable(const Interval& interval, const FreeParameter& free) {
  const bool everywhere = interval.low == free.low && interval.high == free.high;
  return !everywhere && !(free.logarithmic && interval.high > hopeless_factor * interval.low);
}

// None where the minimum lies so far above the best that nothing is left to rise by.
std::optional<ProfileInterval> interval_about(const Surroundings& surroundings, int parameter, double level,
                                              double above) {
  const auto p = static_cast<int>(surroundings.problem().parameters.size());
  const double freedom = surroundings.degrees_of_freedom(VectorXd::Unit(p, parameter));
  const double t = student_quantile((1 + level) / 2, freedom);
  if (!(t * t > above)) return std::nullopt;
  ProfileInterval found = trace_profile(surroundings, parameter, t * t - above).interval;
  found.level = level;
  found.degrees_of_freedom = freedom;
  return found;
}

double above_best(const Minimum& minimum, const Minimum& best) {
  return std::max(0.0, minimum.deviance - best.deviance);
}

// The pieces about all minima become one region.
void join(ProfileInterval& one, const CalibrationProblem& problem) {
  one.region = united(one.region);
  one.interval = hull(one.region);
  one.identifiable = is_identifiable(one.interval, problem.parameters[one.parameter]);
}

}  // namespace

Surroundings::Surroundings(const CalibrationProblem& problem, const Minimum& minimum)
    : problem_(problem),
      minimum_(minimum),
      answer_(problem.model(minimum.searched, Want::values_and_covariance)),
      weights_(make_weights(problem.data, minimum.scatter, answer_.covariance)),
      likelihood_(
          restricted_likelihood(problem, answer_, minimum.searched, minimum.scatter, free_parameters(problem, {}))) {}

Surroundings::Point Surroundings::fit_others(const VectorXd& start, const std::vector<int>& held) const {
  std::vector<Held> fixed;
  for (const int k : held) fixed.push_back({k, start[k]});
  Evaluator evaluator(problem_);
  const FrozenFit fit = frozen_fit(evaluator, weights_, start, free_parameters(problem(), fixed));
  return {fit.searched, fit.objective - minimum_.objective};
}

// With c = w . C w and g its slopes by the squared scatters, whose covariance is F^-1: 2 c^2/(g . F^-1 g).
double Surroundings::degrees_of_freedom(const VectorXd& weight) const {
  const auto groups = static_cast<int>(likelihood_.covariance_slope.size());
  VectorXd slope(groups);
  for (int g = 0; g < groups; ++g) slope[g] = weight.dot(likelihood_.covariance_slope[g] * weight);
  const double variance = weight.dot(likelihood_.covariance * weight);
  const double uncertainty = slope.dot(scatter_covariance(likelihood_) * slope);
  if (!(uncertainty > 0)) return std::numeric_limits<double>::infinity();
  return std::max(1.0, 2 * variance * variance / uncertainty);
}

Walk walk(const Surroundings& surroundings, const Point& start, const Path& path) {
  std::vector<int> held = path.also_held;
  held.push_back(path.parameter);
  const Walker walker{surroundings, path, held, std::sqrt(path.threshold)};
  const CalibrationProblem& problem = surroundings.problem();
  const double low = lower_bounds(problem)[path.parameter], high = upper_bounds(problem)[path.parameter];
  const double bound = path.direction < 0 ? low : high, box = high - low;
  const auto allowed = [box](double step) { return std::clamp(step, shortest_step * box, longest_step * box); };

  Walk found{start, true, {}};
  Point last = start, before = start;
  double step = allowed(first_step * walker.goal * path.deviation);
  while (walker.place(last) != bound) {
    const double x = walker.place(last) + path.direction * step;
    const Point next = walker.at(path.direction * x < path.direction * bound ? x : bound, last, before);
    found.points.push_back(next);
    if (height(next) > walker.goal) {
      found.end = walker.root(last, next, found.points);
      found.at_bound = false;
      return found;
    }
    const double gain = std::max(height(next) - height(last), 1e-9 * walker.goal);
    step = allowed(step * std::clamp(wanted_gain * walker.goal / gain, 0.5, 2.0));
    before = std::exchange(last, next);
  }
  found.end = last;
  return found;
}

Profile trace_profile(const Surroundings& surroundings, int parameter, double threshold) {
  const Minimum& minimum = surroundings.minimum();
  const FreeParameter& free = surroundings.problem().parameters[parameter];
  const Point bottom{minimum.searched, 0};
  const double deviation = std::sqrt(minimum.covariance(parameter, parameter));
  Profile profile;
  profile.down = walk(surroundings, bottom, {parameter, -1, threshold, deviation, {}});
  profile.up = walk(surroundings, bottom, {parameter, 1, threshold, deviation, {}});
  const Walk &down = profile.down, &up = profile.up;

  ProfileInterval& found = profile.interval;
  found.parameter = parameter;
  found.interval = {.low = down.at_bound ? free.low : free.natural(down.end.searched[parameter]),
                    .high = up.at_bound ? free.high : free.natural(up.end.searched[parameter]),
                    .low_open = down.at_bound || at_anothers_bound(surroundings, down.end, parameter),
                    .high_open = up.at_bound || at_anothers_bound(surroundings, up.end, parameter)};
  found.region = {found.interval};
  found.identifiable = is_identifiable(found.interval, free);
  found.profile.push_back({bottom.searched[parameter], 0, bottom.searched});
  for (const Walk* side : {&down, &up})
    for (const Point& point : side->points)
      if (std::isfinite(point.rise)) found.profile.push_back({point.searched[parameter], point.rise, point.searched});
  std::ranges::sort(found.profile, {}, &ProfilePoint::searched);
  return profile;
}

double effective_degrees_of_freedom(const CalibrationProblem& problem, const Minimum& minimum, const VectorXd& weight) {
  return Surroundings(problem, minimum).degrees_of_freedom(weight);
}

std::vector<ProfileInterval> profile_intervals(const CalibrationProblem& problem, const Minimum& minimum, double level,
                                               const SearchOptions& options, double above) {
  const Surroundings surroundings(problem, minimum);
  std::vector<std::optional<ProfileInterval>> found(problem.parameters.size());
  const auto p = static_cast<int>(found.size());
  Progress progress("intervals", p);
  side_by_side(options.threads, p, [&](int k) {
    found[k] = interval_about(surroundings, k, level, above);
    progress.add();
  });
  std::vector<ProfileInterval> intervals;
  for (auto& one : found)
    if (one) intervals.push_back(std::move(*one));
  return intervals;
}

std::vector<ProfileInterval> region_intervals(const CalibrationProblem& problem, const std::vector<Minimum>& minima,
                                              double level, const SearchOptions& options) {
  auto intervals = profile_intervals(problem, minima.front(), level, options);
  for (std::size_t i = 1; i < minima.size(); ++i) {
    if (!minima[i].converged) continue;
    for (const ProfileInterval& other :
         profile_intervals(problem, minima[i], level, options, above_best(minima[i], minima.front())))
      for (ProfileInterval& one : intervals)
        if (one.parameter == other.parameter) one.region.push_back(other.interval);
  }
  for (ProfileInterval& one : intervals) join(one, problem);
  return intervals;
}

ProfileInterval region_interval(const CalibrationProblem& problem, const std::vector<Minimum>& minima, int parameter,
                                double level) {
  std::optional<ProfileInterval> whole;
  for (const Minimum& minimum : minima) {
    if (whole && !minimum.converged) continue;
    const Surroundings surroundings(problem, minimum);
    auto one = interval_about(surroundings, parameter, level, above_best(minimum, minima.front()));
    if (!whole)
      whole = std::move(one);
    else if (one)
      whole->region.push_back(one->interval);
  }
  join(*whole, problem);
  return *whole;
}

Region united(Region pieces) {
  std::ranges::sort(pieces, {}, &Interval::low);
  Region joined;
  for (const Interval& piece : pieces) {
    if (joined.empty() || piece.low > joined.back().high) {
      joined.push_back(piece);
    } else if (piece.high > joined.back().high) {
      joined.back().high = piece.high;
      joined.back().high_open = piece.high_open;
    }
  }
  return joined;
}

Interval hull(const Region& region) {
  return {region.front().low, region.back().high, region.front().low_open, region.back().high_open};
}

std::string words_of(const Region& region, const std::function<std::string(double)>& shown) {
  std::string text;
  for (const Interval& piece : region)
    text += (text.empty() ? "" : " or ") + shown(piece.low) + " to " + shown(piece.high);
  return text;
}

}  // namespace percal
