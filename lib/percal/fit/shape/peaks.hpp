// What the peaks of curves say of an erosion strain.                                             docs/formats/fit.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/fit/points/curve_data.hpp"

namespace percal {

// "none", "held", "falls".
std::string word(CurvePeak::End end);

struct ErosionPrior {
  double strain;  // engineering: the largest principal stretch less 1, the geometric mean over the curves
  double error;   // standard deviation of its logarithm
  int curves;     // that fall behind their peak
};

// One specimen's failure is not the particle's: the error is never below this.
inline constexpr double least_prior_error = 0.4;

// None where no curve falls.
std::optional<ErosionPrior> prior_of_peaks(const std::vector<CurveSource>& sources);

}  // namespace percal
