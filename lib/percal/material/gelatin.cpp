#include "percal/material/gelatin.hpp"

#include <string>
#include <vector>

#include "percal/base/error.hpp"

namespace percal {

GelatinLaw fit_gelatin_law(std::span<const double> concentrations, std::span<const double> moduli, double exponent,
                           Misfit misfit) {
  return fit_power_law(concentrations, moduli, exponent, misfit);
}

GelatinLaw fit_gelatin_law(std::span<const double> concentrations, std::span<const double> moduli, Misfit misfit) {
  return fit_power_law(concentrations, moduli, misfit);
}

MeanRateFactor fit_rate_factor(std::span<const double> quasi_static, std::span<const double> high_rate) {
  if (quasi_static.size() != high_rate.size() || quasi_static.empty())
    throw BadInput("rate factor: found " + std::to_string(quasi_static.size()) + " quasi-static and " +
                   std::to_string(high_rate.size()) + " high-rate moduli; accepted: one of each for every formulation");
  std::vector<double> ratios;
  for (std::size_t i = 0; i < high_rate.size(); ++i) ratios.push_back(high_rate[i] / quasi_static[i]);
  return {mean(ratios), ratios.size() > 1 ? sample_deviation(ratios) : 0.0};
}

double high_rate_modulus(double mu_quasi_static, double rate_factor) { return mu_quasi_static * rate_factor; }

double quasi_static_modulus(double mu_high_rate, double rate_factor) { return mu_high_rate / rate_factor; }

double youngs_modulus_incompressible(double mu) { return 3 * mu; }

}  // namespace percal
