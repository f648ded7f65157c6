// Stress of the incompressible one-term Ogden solid in the homogeneous deformations of the test bench.
// docs/theory/curves.md
#pragma once
#include <cmath>
#include <optional>
#include <string>

#include "percal/material/ogden.hpp"

namespace percal {

// What is stretched, and what is free.
//   uniaxial      lambda; both sides free (tension and compression)
//   equibiaxial   lambda in two directions; the third free
//   planar        lambda; the width held at 1; the thickness free; stress in the loaded direction ("pure shear")
//   planar_held   as planar; stress in the held direction
//   simple_shear  gamma; shear stress
//   biaxial       two stretches, the third direction free; stress along the first
enum class Deformation { uniaxial, equibiaxial, planar, planar_held, simple_shear, biaxial };

// How far. `amount` is the stretch along the measured stress, in simple shear gamma; `across` is the second stretch of
// biaxial.
struct Strained {
  Deformation deformation;
  double amount;
  double across = 1;
};

// A deformation's stress is a difference of two principal Cauchy stresses, times a factor that makes it nominal.
struct PrincipalPair {
  double log_i, log_j;    // ln of the principal stretches: the loaded and a free direction
  double nominal_factor;  // nominal stress over (sigma_i - sigma_j)
};

// Needs stretches > 0.
PrincipalPair principal_pair(const Strained& strained);

// Nominal (first Piola) stress, Pa; in simple shear the shear stress, where nominal and Cauchy are the same.
template <class T>
T nominal_stress(const OgdenOf<T>& solid, const PrincipalPair& pair) {
  return cauchy_difference(solid, pair.log_i, pair.log_j) * pair.nominal_factor;
}

template <class T>
T nominal_stress(const OgdenOf<T>& solid, const Strained& strained) {
  return nominal_stress(solid, principal_pair(strained));
}

// d(nominal stress)/d(amount), Pa. 3 mu, 6 mu, 4 mu, 2 mu and mu in the undeformed state for uniaxial, equibiaxial,
// planar, planar_held and simple shear; biaxial with `across` kept.
double nominal_stiffness(const Ogden& solid, const Strained& strained);

// Nominal stress of a Cauchy stress measured along `amount`: sigma/lambda; unchanged in simple shear and where the
// width is held.
double nominal_of_cauchy(double cauchy, const Strained& strained);

// The deformation that a word means, without regard to case, '-', '_' and blanks: UT, uniaxial, tension, compression,
// tension_compression, ET, equibiaxial, biaxial (both the same stretch), PS, planar, pure_shear, planar_held, SS,
// shear, simple_shear, general_biaxial. nullopt for other words.
std::optional<Deformation> deformation_of(const std::string& word);

// Whether the word says that the test is compression: compression, uniaxial_compression.
bool says_compression(const std::string& word);
// Whether it says tension and nothing else: tension, uniaxial_tension.
bool says_tension(const std::string& word);

// "uniaxial", "equibiaxial", "planar", "planar_held", "simple_shear", "general_biaxial".
std::string word(Deformation deformation);

// The words above, for messages.
std::string deformation_words();

}  // namespace percal
