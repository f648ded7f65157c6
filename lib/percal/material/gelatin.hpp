// Gelatin's small-strain shear modulus from its concentration, and from one rate of strain to another.
#pragma once
#include <span>

#include "percal/math/statistics.hpp"

namespace percal {

// mu = k c^n, c in weight percent (12, not 0.12), mu and k in Pa.                       Guha 2009, Eq. 3-5
using GelatinLaw = PowerLaw;

// The exponent given (1.8 in Guha 2009), or fitted too. Throws BadInput as fit_power_law does.
GelatinLaw fit_gelatin_law(std::span<const double> concentrations, std::span<const double> moduli, double exponent,
                           Misfit misfit);
GelatinLaw fit_gelatin_law(std::span<const double> concentrations, std::span<const double> moduli, Misfit misfit);

// How many times stiffer the material is at the impact's rate of strain: the mean of high-rate over quasi-static
// modulus, with the sample standard deviation of one formulation (0 for a single one). Same length, positive.
struct MeanRateFactor {
  double factor;
  double deviation;
};
MeanRateFactor fit_rate_factor(std::span<const double> quasi_static, std::span<const double> high_rate);

double high_rate_modulus(double mu_quasi_static, double rate_factor);
double quasi_static_modulus(double mu_high_rate, double rate_factor);

// E = 3 mu: Young's modulus of the incompressible solid. mu is the true small-strain shear modulus.
double youngs_modulus_incompressible(double mu);

}  // namespace percal
