// Parameters fitted to data of any kind at once: weighted least squares with priors, bounds, a scatter that the data tell, and
// data that only say on which side of a number they lie. What the model is, nobody here knows.        docs/theory/calibration.md
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace percal {

// A parameter is searched on a scale of its own: its logarithm, or itself.
struct FreeParameter {
  std::string name;
  std::string unit;          // SI, for messages; empty where it has none
  double low = 0, high = 0;  // natural values
  bool logarithmic = true;
  std::optional<double> prior = {};  // natural value
  double prior_error = 0;            // standard deviation on the searched scale: relative where logarithmic

  double searched(double natural) const;
  double natural(double searched) const;
  double middle() const { return (searched(low) + searched(high)) / 2; }  // of the bounds, searched
};

// What a datum tells of its number: itself; that it is no smaller or no larger than the value, where it would have been measured
// otherwise; or on which side of the value it lies, of which nothing else is ever seen.
enum class Seen { number, at_least, at_most, above, below };

// +1: from the value upwards; -1: downwards; 0: the number itself.
inline int side(Seen seen) {
  constexpr int sides[] = {0, 1, -1, 1, -1};
  return sides[static_cast<int>(seen)];
}

// One measured number on the scale on which its errors are normal: ln depth, a stress.
struct Datum {
  std::string label;
  double value = 0;
  double error = 0;  // known standard deviation
  int group = 0;     // index of its ScatterGroup
  Seen seen = Seen::number;

  bool is_number() const { return seen == Seen::number; }
};

// What the data of a group scatter about any model, beyond their known errors: a standard deviation, added in squares.
struct ScatterGroup {
  std::string name;
  bool estimated = true;  // from the fit itself; else `fixed`
  double fixed = 0;
};

// The model at one point of the searched scale. `covariance` is that of the model's own errors; empty: exact.
struct ModelAnswer {
  Eigen::VectorXd value;       // one for each datum
  Eigen::MatrixXd jacobian;    // data x parameters, d value / d searched parameter
  Eigen::MatrixXd covariance;  // data x data
};
// The Jacobian comes with the values. Where a model has no answer, its values are not finite.
enum class Want { values, values_and_covariance };
// May be called from one thread only.
using CalibrationModel = std::function<ModelAnswer(const Eigen::VectorXd& searched, Want want)>;

struct CalibrationProblem {
  std::vector<FreeParameter> parameters;
  std::vector<Datum> data;
  std::vector<ScatterGroup> groups;
  CalibrationModel model;
};

struct Minimum {
  Eigen::VectorXd searched;
  double objective = 0;         // sum of squared whitened residuals, priors included
  double deviance = 0;          // objective + ln det V: what minima with scatters of their own are compared by
  std::vector<double> scatter;  // of each group, standard deviation
  Eigen::VectorXd residual;     // model - datum, on the data's scale; 0 for a side that is met
  // Of the parameters, linearised, searched scale; 0 for held ones. Finite always: a direction that the data leave wider than
  // the box has the box's width as its standard deviation.
  Eigen::MatrixXd covariance;
  Eigen::MatrixXd information;  // J^T W J with the priors
  std::vector<bool> at_bound;
  bool converged = false;
  int degrees_of_freedom = 0;  // data + priors - free parameters; a side that is met is not counted
  int evaluations = 0;
};

struct SearchOptions {
  int global_evaluations = 4000;  // of NLopt, spread over the box
  int starts = 8;                 // of Ceres: the best separate points of the global search
  int scatter_rounds = 20;        // fixed-point rounds for scatter and model covariance
  // Of profiles, bootstraps and ridges: above 1 the model is called from several threads at once. The numbers are the same.
  int threads = 1;
};

// Every distinct minimum, least deviance first; never empty, but see `converged`. Global search by NLopt over the box, then Ceres
// (Levenberg-Marquardt with the model's derivatives) from its best points; the weights (known errors, estimated scatter, model
// covariance) are settled by repetition. Throws BadInput where there are no data, or a bound is not ordered.
std::vector<Minimum> find_minima(const CalibrationProblem& problem, const SearchOptions& options);

// Ceres alone from one point, with the weights settled in the same way; `held` (parameter index, searched value) stay as given.
struct Held {
  int parameter;
  double searched;
};
Minimum refine(const CalibrationProblem& problem, const Eigen::VectorXd& start, const std::vector<Held>& held,
               const SearchOptions& options);

}  // namespace percal
