#include "percal/material/conventions.hpp"

#include <cmath>

namespace percal {

double true_modulus(double mu_as_given, double alpha, ModulusConvention convention) {
  return convention == ModulusConvention::mu_over_alpha ? mu_as_given * alpha / 2 : mu_as_given;
}

double modulus_as_given(double mu_true, double alpha, ModulusConvention convention) {
  return convention == ModulusConvention::mu_over_alpha ? mu_true * 2 / alpha : mu_true;
}

double stretch_at(double strain, StrainMeasure measure) {
  switch (measure) {
    case StrainMeasure::true_strain: return std::exp(strain);
    case StrainMeasure::green_lagrange: return std::sqrt(1 + 2 * strain);
    case StrainMeasure::engineering: break;
  }
  return 1 + strain;
}

double strain_at(double stretch, StrainMeasure measure) {
  switch (measure) {
    case StrainMeasure::true_strain: return std::log(stretch);
    case StrainMeasure::green_lagrange: return (stretch * stretch - 1) / 2;
    case StrainMeasure::engineering: break;
  }
  return stretch - 1;
}

std::string word(ModulusConvention convention) {
  return convention == ModulusConvention::mu_over_alpha ? "mu/alpha" : "true";
}

std::string word(StrainMeasure measure) {
  switch (measure) {
    case StrainMeasure::true_strain: return "true";
    case StrainMeasure::green_lagrange: return "green-lagrange";
    case StrainMeasure::engineering: break;
  }
  return "engineering";
}

double bulk_to_shear(double nu) { return 2 * (1 + nu) / (3 * (1 - 2 * nu)); }

double poisson_ratio(double ratio) { return (3 * ratio - 2) / (6 * ratio + 2); }

}  // namespace percal
