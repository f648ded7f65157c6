// Conventions of other programs and papers, converted at the edge. Inside percal mu is the true small-strain shear modulus.
#pragma once
#include <string>

namespace percal {

// How a number called mu is meant.
//   true_shear:    W = (2 mu/alpha^2) (sum lambda^alpha - 3), mu_true = mu               "true"
//   mu_over_alpha: W = (mu/alpha) (sum lambda^alpha - 3), LS-DYNA's MU1, mu_true = mu alpha/2    "mu/alpha"
enum class ModulusConvention { true_shear, mu_over_alpha };

// Which strain of the largest principal stretch lambda is meant:
// engineering lambda - 1, true ln lambda, Green-Lagrange (lambda^2 - 1)/2.
enum class StrainMeasure { engineering, true_strain, green_lagrange };

// Pa in, Pa out. alpha must not be 0 with mu_over_alpha.
double true_modulus(double mu_as_given, double alpha, ModulusConvention convention);
double modulus_as_given(double mu_true, double alpha, ModulusConvention convention);

double stretch_at(double strain, StrainMeasure measure);
double strain_at(double stretch, StrainMeasure measure);

// "true", "mu/alpha"; "engineering", "true", "green-lagrange": the words of scenes, jobs and results.
std::string word(ModulusConvention convention);
std::string word(StrainMeasure measure);

// K/mu of a Poisson's ratio, 2 (1 + nu) / (3 (1 - 2 nu)), and back. nu in (-1, 0.5).
double bulk_to_shear(double nu);
double poisson_ratio(double bulk_to_shear);

}  // namespace percal
