// How well data determine parameters: profile likelihood, bootstrap, correlation, and what no amount of fitting can tell.
// docs/theory/calibration.md
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "percal/estimate/least_squares.hpp"

namespace percal {

struct ProfilePoint {
  double searched = 0;
  double rise = 0;         // of the objective above the minimum, the others fitted anew
  Eigen::VectorXd others;  // all parameters at this point, this one among them
};

// An end that a bound cut off is open, its own or that of another parameter which would have to go on as well: the data say
// nothing against it.
struct Interval {
  double low = 0, high = 0;  // natural values
  bool low_open = false, high_open = false;
};

// What data allow of a parameter may lie in several pieces, one about each minimum that fits about as well: from low to high.
using Region = std::vector<Interval>;

// Pieces that overlap become one.
Region united(Region pieces);
// From the lowest end to the highest.
Interval hull(const Region& region);
// "1 to 2 or 4 to 5".
std::string words_of(const Region& region, const std::function<std::string(double)>& shown);

struct ProfileInterval {
  int parameter = 0;
  Interval interval;                  // the hull of the region
  std::vector<ProfilePoint> profile;  // from low to high
  // False where both ends are its own bounds, or wider than a factor of `hopeless_factor` on a logarithmic scale.
  bool identifiable = true;
  double level = 0.95;
  double degrees_of_freedom = 0;  // of the threshold's Student t; infinite where no scatter is estimated
  Region region = {};             // one piece where a single minimum was looked at
};
inline constexpr double hopeless_factor = 4;

// One for each parameter, at a confidence level such as 0.95: where the rise of the objective meets t^2, Student's t with the
// effective degrees of freedom of that parameter's variance. The weights stay those of the minimum. An interval is the one around
// this minimum, whose deviance lies `above` that of the best: only t^2 - above is left to rise by, and a parameter is missing where
// nothing is.                                                                              docs/theory/calibration.md (11a)
std::vector<ProfileInterval> profile_intervals(const CalibrationProblem& problem, const Minimum& minimum, double level,
                                               const SearchOptions& options, double above = 0);

// The same over the whole region: one for each parameter, with the pieces about all converged minima (the first is the best). The
// profile is that of the best.
std::vector<ProfileInterval> region_intervals(const CalibrationProblem& problem, const std::vector<Minimum>& minima,
                                              double level, const SearchOptions& options);
// Of one parameter alone.
ProfileInterval region_interval(const CalibrationProblem& problem, const std::vector<Minimum>& minima, int parameter,
                                double level);

// Degrees of freedom of the variance of weight . parameters (Satterthwaite): n - p where one scatter is estimated and no error is
// known, more where known errors carry a part of it, infinite where no scatter is estimated. At least 1.
double effective_degrees_of_freedom(const CalibrationProblem& problem, const Minimum& minimum,
                                    const Eigen::VectorXd& weight);

// Data drawn anew from the fitted model with the fitted errors (parametric), or residuals drawn with return (residual), each
// fitted from the minimum with its weights. A prior is drawn anew as well; an "at least" whose drawn number is smaller is from
// then on a plain measurement, and what is only ever seen on one side may come out on the other. The same seed gives the same numbers.
enum class BootstrapKind { parametric, residual };
struct Bootstrap {
  Eigen::MatrixXd searched;         // replicates x parameters
  std::vector<Interval> intervals;  // percentiles, natural values
  int failed = 0;                   // replicates without a converged fit: counted, left out
};
Bootstrap bootstrap(const CalibrationProblem& problem, const Minimum& minimum, BootstrapKind kind, int replicates,
                    double level, unsigned seed, const SearchOptions& options);

// The combinations of parameters that the data determine, best first: eigenvectors of the information matrix (searched scale,
// priors left out). Its standard deviation says how well, and is no larger than 1e6; above ln(hopeless_factor)/4 it is not
// determined.
struct Combination {
  Eigen::VectorXd weight;  // of each searched parameter, unit length
  double standard_deviation = 0;
  bool determined = true;
};
std::vector<Combination> combinations(const CalibrationProblem& problem, const Minimum& minimum);
Eigen::MatrixXd correlation(const Minimum& minimum);

// What no number alone says, in sentences: which parameter cannot be known from these data, along which combination it may move
// freely, which sits at a bound, which second minimum is as good.
std::vector<std::string> findings(const CalibrationProblem& problem, const std::vector<Minimum>& minima,
                                  const std::vector<ProfileInterval>& intervals);

// A level set of the objective over two parameters, the others fitted anew at every point: the ridge as it is. The grid is even on
// the searched scale, over the part of the box that holds the region.
inline constexpr double no_answer_rise = 1e6;
struct RidgeMap {
  int first = 0, second = 0;  // parameters
  std::vector<double> x, y;   // natural grid values
  Eigen::MatrixXd rise;       // y.size() x x.size()
  double threshold = 0;       // of the 95 % region
  // At the threshold, natural values: closed outlines of the region around the minimum, along the box where it cuts them.
  std::vector<std::vector<std::array<double, 2>>> contours;
};
RidgeMap ridge_map(const CalibrationProblem& problem, const Minimum& minimum, int first, int second, int grid,
                   const SearchOptions& options);

// What one more measurement would do: a shot that has not been made, with its gradient at the minimum and the error it would have.
struct Candidate {
  std::string label;
  Eigen::VectorXd gradient;  // d value / d searched parameter
  double error = 0;          // standard deviation it would have, scatter included
};
struct Advice {
  std::string label;
  double width_ratio = 1;  // of the target's interval afterwards over now, linearised
};
// Best first, for the parameter (or combination) with this weight.
std::vector<Advice> next_experiments(const Minimum& minimum, const Eigen::VectorXd& target_weight,
                                     const std::vector<Candidate>& candidates);

}  // namespace percal
