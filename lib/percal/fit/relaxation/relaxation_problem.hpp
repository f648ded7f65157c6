// A relaxing solid's fit as a calibration problem, in more than one set of parameters.             docs/theory/relaxation.md
#pragma once
#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "percal/fit/interval/curve_calibration.hpp"
#include "percal/fit/relaxation/relaxing_curves.hpp"

namespace percal {

// Weighted points, and the histories they stand in.
struct RelaxationData {
  CurveProblem points;
  std::vector<RelaxingRow> rows;  // one for each of CurveData::points
  TimeScales scales;
};

// The modulus that is a parameter: the other one follows from it and the shares.
enum class LeadingModulus { instantaneous, long_term };

// Which numbers are searched. Shares g are s_1, (1 - s_1) s_2, (1 - s_1)(1 - s_2) s_3 with each s_i free in [0, 1]: they cannot add up to
// more than 1. `order` says whose share is the first s, the parameter that is g itself.                        (6)
struct RelaxationParameters {
  Model model = Model::ogden;
  LeadingModulus leads = LeadingModulus::instantaneous;
  std::vector<int> order;  // of the series' terms: a permutation of 0, 1, ..

  int terms() const { return terms_of(model); }
  int relaxing() const { return static_cast<int>(order.size()); }
  int alphas() const { return fixed_alphas(model).empty() ? terms() : 0; }
  int first_alpha() const { return terms(); }
  int first_share() const { return terms() + alphas(); }
  int first_time() const { return first_share() + relaxing(); }
  int count() const { return first_time() + relaxing(); }
};

inline constexpr double largest_share = 0.9999;  // of each s: nearly all relaxes
inline constexpr double beyond_the_record =
    10;  // times are searched from the shortest interval over it to the longest record times it

// `start` gives the box its place. The data must outlive the problem. Times in the order of the series, whatever `order` is.
CalibrationProblem relaxation_problem(std::shared_ptr<const RelaxationData> data,
                                      const RelaxationParameters& parameters, const RelaxingSolid& start,
                                      ErrorSource errors);

// A solid on the searched scale of such a problem, moved into its box; and back.
Eigen::VectorXd searched(const CalibrationProblem& problem, const RelaxationParameters& parameters,
                         const RelaxingSolid& solid);
RelaxingSolid solid_at(const RelaxationParameters& parameters, const Eigen::VectorXd& searched);

}  // namespace percal
