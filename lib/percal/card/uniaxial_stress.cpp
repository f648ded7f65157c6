#include "percal/card/uniaxial_stress.hpp"

#include <cmath>

namespace percal {
namespace {

// J U'(J)
double volumetric_kirchhoff(double bulk_modulus, double J, VolumetricLaw law) {
  switch (law) {
    case VolumetricLaw::quadratic: return bulk_modulus * J * (J - 1);
    case VolumetricLaw::logarithmic: return bulk_modulus * std::log(J);
    case VolumetricLaw::difference: return bulk_modulus * (J - 1);
  }
  return 0;
}

// tau_1 - tau_2 of isochoric stretches s and s^(-1/2): sum (2 mu/alpha) (s^alpha - s^(-alpha/2)), s = lambda J^(-1/3).
double kirchhoff_difference(const CardMaterial& material, double stretch, double log_J) {
  const double log_s = std::log(stretch) - log_J / 3;
  double sum = 0;
  for (const Ogden& term : material.terms) sum += cauchy_difference(term, log_s, -log_s / 2);
  return sum;
}

// tau_2 = J U' - (tau_1 - tau_2)/3: grows with J, from below 0 to above.
double side_stress(const CardMaterial& material, double stretch, double log_J, VolumetricLaw law) {
  return volumetric_kirchhoff(material.bulk_modulus, std::exp(log_J), law) -
         kirchhoff_difference(material, stretch, log_J) / 3;
}

}  // namespace

double uniaxial_stress(const CardMaterial& material, double stretch, VolumetricLaw law) {
  double low = 0, high = 0;  // ln J
  for (double step = 1e-3; side_stress(material, stretch, low, law) > 0 && step < 10; step *= 2) low -= step;
  for (double step = 1e-3; side_stress(material, stretch, high, law) < 0 && step < 10; step *= 2) high += step;
  for (int halving = 0; halving < 100; ++halving) {
    const double middle = (low + high) / 2;
    (side_stress(material, stretch, middle, law) < 0 ? low : high) = middle;
  }
  return kirchhoff_difference(material, stretch, (low + high) / 2) / stretch;
}

double incompressible_uniaxial_stress(const CardMaterial& material, double stretch) {
  return kirchhoff_difference(material, stretch, 0) / stretch;
}

}  // namespace percal
