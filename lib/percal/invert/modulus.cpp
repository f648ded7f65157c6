#include "percal/invert/modulus.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "percal/math/root.hpp"

namespace percal {
namespace {

// Of ln modulus, where the expected slope is the usual one.
constexpr double usual_slope = 0.4;
constexpr double usual_first_step = 0.3;  // when looking for the other side of the target
constexpr double usual_window = 0.5;      // answers within this of the root belong to the local line
// Where further answers for the line are asked for, about the best one.
constexpr std::array<double, 10> sides{-0.12, 0.12, -0.24, 0.24, -0.06, 0.06, -0.18, 0.18, -0.3, 0.3};
constexpr double least_slope = 0.05;

struct EndOfSearch {
  InversionOutcome outcome;
};

class Search {
 public:
  Search(const DepthOfModulus& forward, const InversionOptions& options)
      : forward_(forward), options_(options), scale_(usual_slope / options.expected_slope) {}

  Inversion run() {
    try {
      const auto [soft, stiff] = bracket();
      close_in(soft, stiff);
      fit_line();
      result_.outcome = InversionOutcome::found;
    } catch (const EndOfSearch& end) {
      result_.outcome = end.outcome;
    }
    return std::move(result_);
  }

 private:
  // ln(depth / target): positive where the material is too soft.
  double misfit(double log_modulus) {
    for (const auto& point : result_.points)
      if (point.log_modulus == log_modulus) return std::log(point.answer.depth / options_.target);
    if (static_cast<int>(result_.points.size()) >= options_.most_evaluations)
      throw EndOfSearch{InversionOutcome::out_of_evaluations};
    const DepthAnswer answer = forward_(log_modulus);
    result_.points.push_back({log_modulus, answer});
    if (!answer.valid || !(answer.depth > 0)) {
      result_.why = answer.why;
      throw EndOfSearch{InversionOutcome::failed};
    }
    return std::log(answer.depth / options_.target);
  }

  struct Bracket {
    double soft, stiff;
  };
  Bracket bracket() {
    double at = options_.start, value = misfit(at), step = usual_first_step * scale_;
    for (;;) {
      const double next = at + (value > 0 ? step : -step);
      if (std::abs(next - options_.start) > options_.most_step) throw EndOfSearch{InversionOutcome::out_of_reach};
      const double next_value = misfit(next);
      if ((next_value > 0) != (value > 0)) return value > 0 ? Bracket{at, next} : Bracket{next, at};
      at = next;
      value = next_value;
      step *= 1.5;
    }
  }

  void close_in(double soft, double stiff) {
    const double narrow = options_.noise / options_.expected_slope;
    root([this](double log_modulus) { return misfit(log_modulus); }, soft, stiff,
         [&](double estimate, double width) { return std::abs(misfit(estimate)) < options_.noise || width < narrow; });
  }

  struct Line {
    double slope, at_root, scatter, error;
    int points;
  };
  bool counts(const InversionPoint& p, double centre) const {
    return !p.answer.censored && std::abs(p.log_modulus - centre) <= usual_window * scale_;
  }
  // Least squares of ln depth on ln modulus over the uncensored answers near `centre`.
  Line line_near(double centre) const {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& p : result_.points)
      if (counts(p, centre)) {
        const double dx = p.log_modulus - centre, dy = std::log(p.answer.depth / options_.target);
        n += 1;
        x += dx;
        y += dy;
        xx += dx * dx;
        xy += dx * dy;
      }
    const double spread = xx - x * x / n;
    // The expected slope as answers of that spread about their mean, if it counts.
    const double beforehand = options_.slope_error ? std::pow(options_.noise / *options_.slope_error, 2) : 0;
    const double known = spread + beforehand;
    Line line{-options_.expected_slope, centre, options_.noise, 0, static_cast<int>(n)};
    if (n >= 2 && known > 1e-6) line.slope = (xy - x * y / n - beforehand * options_.expected_slope) / known;
    if (!(line.slope < -least_slope / scale_))
      line.slope = -options_.expected_slope;  // noise over too short a span: the depth does fall with stiffness
    const double level = y / n - line.slope * x / n;
    line.at_root = centre - level / line.slope;
    double squares = 0;
    for (const auto& p : result_.points)
      if (counts(p, centre)) {
        const double residual =
            std::log(p.answer.depth / options_.target) - level - line.slope * (p.log_modulus - centre);
        squares += residual * residual;
      }
    if (n > 2) line.scatter = std::max(options_.noise, std::sqrt(squares / (n - 2)));
    const double off = line.at_root - centre - x / n;
    line.error = line.scatter / std::abs(line.slope) * std::sqrt(1 / n + (known > 1e-6 ? off * off / known : 0));
    return line;
  }

  void fit_line() {
    double centre = best_answer();
    // A few more answers on both sides, where Brent's method came down on one point.
    const auto most_sides = std::clamp<std::size_t>(options_.fewest_in_line - 1, 0, sides.size());
    for (const double side : std::span(sides).first(most_sides))
      if (line_near(centre).points < options_.fewest_in_line &&
          static_cast<int>(result_.points.size()) < options_.most_evaluations)
        misfit(centre + side * scale_);
    Line line{};
    for (int k = 0; k < 5; ++k) {
      line = line_near(centre);
      for (auto& p : result_.points) p.in_line = counts(p, centre);
      centre = std::clamp(line.at_root, centre - usual_window * scale_ / 2, centre + usual_window * scale_ / 2);
    }
    result_.log_modulus = line.at_root;
    result_.log_modulus_error = line.error;
    result_.slope = line.slope;
    result_.scatter = line.scatter;
    result_.points_in_line = line.points;
  }

  double best_answer() const {
    const auto distance = [&](const InversionPoint& p) {
      return std::abs(std::log(p.answer.depth / options_.target)) + (p.answer.censored ? 1e3 : 0);
    };
    return std::min_element(result_.points.begin(), result_.points.end(),
                            [&](const auto& a, const auto& b) { return distance(a) < distance(b); })
        ->log_modulus;
  }

  const DepthOfModulus& forward_;
  const InversionOptions& options_;
  const double scale_;  // of steps
  Inversion result_;
};

}  // namespace

std::string word(InversionOutcome outcome) {
  switch (outcome) {
    case InversionOutcome::found: return "found";
    case InversionOutcome::out_of_reach: return "out of reach";
    case InversionOutcome::failed: return "failed";
    case InversionOutcome::out_of_evaluations: break;
  }
  return "out of evaluations";
}

Inversion invert_modulus(const DepthOfModulus& forward, const InversionOptions& options) {
  return Search(forward, options).run();
}

}  // namespace percal
