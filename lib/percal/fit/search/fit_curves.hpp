// A hyperelastic solid from stress-stretch points: every minimum there is, best first.          docs/theory/curves.md
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "percal/fit/search/curve_problem.hpp"
#include "percal/fit/search/search_terms.hpp"

namespace percal {

struct CurveOptions {
  Model model = Model::ogden;
  Residual residual = Residual::relative;
  Weighting weighting = EqualPoints{};
  Loss loss = Loss::squares;
  Signs signs = Signs::positive;
};

// Standard errors of one term, those of the linearised model (14); none at a bound, with as many parameters as points,
// and where the points cannot tell the parameters apart.
struct TermErrors {
  std::optional<double> mu;  // Pa
  std::optional<double> alpha;
};

// One minimum of the objective.
struct CurveMinimum {
  Hyperelastic solid;                // alphas from high to low; a term whose best modulus is zero is left out
  double objective;                  // sum of the squared residuals (or of the loss): dimensionless, or Pa^2
  std::optional<double> above_best;  // objective/(best objective) - 1; none where the best is exactly 0
  std::optional<double> r2;          // 1 - SSE/SST in nominal stress, unweighted; none where all stresses are equal
  std::vector<std::optional<double>> r2_of_test;
  std::vector<TermErrors> errors;     // one for each term
  std::optional<double> correlation;  // of mu and alpha, one term with a free alpha
  bool converged = false;
  bool at_bound = false;  // an |alpha| = largest_alpha: the data want more
  int iterations = 0;
};

struct CurveFit {
  CurveOptions options;
  std::vector<CurveMinimum> minima;  // best first; empty when no solid with the signs asked for fits better than none
  std::optional<Hyperelastic> refused = {};  // where there are none: the best whose moduli add up to no positive one
  std::vector<CurveTest> tests;              // points used, and how they counted
  int points = 0;                            // used
  int left_out_zero_stress = 0;
  int left_out_no_error = 0;
  std::map<Deformation, int> points_of_mode;  // used
  std::optional<double> loss_scale;  // of the loss (moduli.hpp), in the unit of the residuals; none for squares
  std::optional<double> aicc;        // of the best minimum (19); none with too few points or an exact fit
  int scanned = 0;                   // sets of alphas with the moduli solved for
  int starts = 0;                    // of Ceres
};

// Scans the exponents with the moduli solved for at each (the stress is linear in them), then runs Ceres over the
// exponents from every local minimum of the scan, the moduli still solved for. Throws BadInput with fewer different
// deformed points than the model has parameters.
CurveFit fit_curves(const CurveData& data, const CurveOptions& options);

// The same for the one-term Ogden solid, every point counting the same.
CurveFit fit_ogden(const CurveData& data, Residual residual);

}  // namespace percal
