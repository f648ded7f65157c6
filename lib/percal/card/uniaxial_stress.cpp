#include "percal/card/uniaxial_stress.hpp"

#include <cmath>

namespace percal {
namespace {

// J U'(J)
double volumetric_kirchhoff(double bulk_modulus, double J, SolverLaw law) {
  switch (law) {
    case SolverLaw::quadratic: return bulk_modulus * J * (J - 1);
    case SolverLaw::logarithmic: return bulk_modulus * std::log(J);
    case SolverLaw::difference: return bulk_modulus * (J - 1);
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
double side_stress(const CardMaterial& material, double stretch, double log_J, SolverLaw law) {
  return volumetric_kirchhoff(material.bulk_modulus, std::exp(log_J), law) -
         kirchhoff_difference(material, stretch, log_J) / 3;
}

// Of free sides.
double log_volume(const CardMaterial& material, double stretch, SolverLaw law) {
  double low = 0, high = 0;
  for (double step = 1e-3; side_stress(material, stretch, low, law) > 0 && step < 10; step *= 2) low -= step;
  for (double step = 1e-3; side_stress(material, stretch, high, law) < 0 && step < 10; step *= 2) high += step;
  for (int halving = 0; halving < 100; ++halving) {
    const double middle = (low + high) / 2;
    (side_stress(material, stretch, middle, law) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

double uniaxial_stress(const CardMaterial& material, double stretch, SolverLaw law) {
  return kirchhoff_difference(material, stretch, log_volume(material, stretch, law)) / stretch;
}

double incompressible_uniaxial_stress(const CardMaterial& material, double stretch) {
  return kirchhoff_difference(material, stretch, 0) / stretch;
}

double side_stretch(const CardMaterial& material, double stretch, SolverLaw law) {
  return std::exp((log_volume(material, stretch, law) - std::log(stretch)) / 2);
}

std::optional<double> stretch_where_largest_is(double limit, const CardMaterial& material, double end, SolverLaw law) {
  if (end > 1) return limit <= end ? std::optional(limit) : std::nullopt;
  constexpr int steps = 200, halvings = 50;
  const double whole = std::log(end);
  const auto passed = [&](double log_stretch) { return side_stretch(material, std::exp(log_stretch), law) >= limit; };
  double before = 0;
  for (int i = 1; i <= steps; ++i) {
    double at = whole * i / steps;
    if (!passed(at)) {
      before = at;
      continue;
    }
    for (int halving = 0; halving < halvings; ++halving) {
      const double middle = (before + at) / 2;
      (passed(middle) ? at : before) = middle;
    }
    return std::exp(at);
  }
  return std::nullopt;
}

}  // namespace percal
