// Every minimum of a relaxing solid's fit: a scan of exponents and times with the moduli solved for, then Ceres.   docs/theory/relaxation.md
#pragma once
#include <memory>
#include <vector>

#include "percal/fit/relaxation/relaxation_problem.hpp"

namespace percal {

struct RelaxationMinimum {
  RelaxingSolid solid;  // times from short to long
  Minimum minimum;      // of relaxation_problem with the instantaneous modulus first and the terms in order

  double sum_of_squares() const { return minimum.residual.squaredNorm(); }
};

// Solids with a small-strain modulus of 1 from which the scan may take its instantaneous shape.
std::vector<Hyperelastic> shapes_to_scan(Model model, const CurveFit& rate_blind);
// Those of one exponent about the exponents of these minima; of other models the minima's own.
std::vector<Hyperelastic> shapes_about(Model model, const std::vector<RelaxationMinimum>& minima);

RelaxationParameters usual_parameters(Model model, int terms);

// Best first; empty where no positive moduli fit.
std::vector<RelaxationMinimum> relaxation_minima(const std::shared_ptr<const RelaxationData>& data, Model model,
                                                 int terms, const std::vector<Hyperelastic>& shapes);

}  // namespace percal
