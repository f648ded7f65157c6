// mu and alpha of the one-term Ogden solid from stress-stretch points: every minimum there is, best first.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "percal/fit/curve_data.hpp"

namespace percal {

// What is squared and summed: (sigma - sigma_hat)/sigma as in Guha 2009, Eq. 3-4, where points of zero stress are left
// out, or sigma - sigma_hat in Pa.
enum class Residual { relative, absolute };

// alpha is searched between -largest_alpha and largest_alpha.
inline constexpr double largest_alpha = 40;

// One minimum of the objective. Standard errors are those of the linearised model, s^2 (J^T J)^-1 with s^2 =
// objective/(n - 2); there are none at a bound, with two points, and where the points cannot tell mu and alpha apart.
struct OgdenMinimum {
  Ogden solid;
  double objective;                         // sum of squared residuals: dimensionless, or Pa^2
  std::optional<double> above_best;         // objective/(best objective) - 1; none where the best is exactly 0
  std::optional<double> r2;                 // 1 - SSE/SST in nominal stress; none where all stresses are equal
  std::optional<double> mu_standard_error;  // Pa
  std::optional<double> alpha_standard_error;
  std::optional<double> correlation;  // of mu and alpha
  bool converged = false;
  bool at_bound = false;  // |alpha| = largest_alpha: the data want more
  int iterations = 0;
};

struct OgdenFit {
  std::vector<OgdenMinimum> minima;  // best first; empty when no positive mu fits better than none
  Residual residual = Residual::relative;
  int points = 0;  // used
  int left_out_zero_stress = 0;
  std::map<Deformation, int> points_of_mode;  // used
  int scanned = 0;                            // values of alpha with mu solved for, both signs
  int starts = 0;                             // of Ceres, one for each minimum of the scan
};

// Scans alpha with mu solved for at each value (the stress is linear in mu), then runs Ceres with automatic derivatives
// from every local minimum of the scan. Throws BadInput with fewer than two different deformed points.
OgdenFit fit_ogden(const CurveData& data, Residual residual);

// What a reader must know beside the numbers, a sentence each: the sign of alpha and how well the other sign fits, a
// bound, a parameter that the points do not determine.
std::vector<std::string> findings(const OgdenFit& fit);

std::string word(Residual residual);  // "relative", "absolute"

}  // namespace percal
