// What a material card says, in SI and in percal's own convention. The writers and readers convert at the edge.
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/material/conventions.hpp"
#include "percal/material/hyperelastic.hpp"

namespace percal {

inline constexpr std::size_t most_card_terms = 3;  // CalculiX takes no more

// Largest principal strain at which an element is removed. It holds for the elements that it was found with: with others the same
// strain gives another depth (docs/theory/errors.md).
struct CardErosion {
  double limit;  // > 0
  StrainMeasure measure;
  std::optional<double> element_over_radius = {};  // side of an element over the particle's radius, where it is known
  std::optional<double> element = {};              // m, where the particles have one radius
};

// The interval of one parameter, named as in the card object: mu_true_Pa (the sum of all terms), mu_over_alpha_Pa
// (2 mu/alpha), alpha, erosion_strain; of single terms mu_true_Pa_1, alpha_1, mu_true_Pa_2, ... An end that the data
// leave open is missing.
struct CardInterval {
  std::string parameter;
  std::optional<double> low, high;
};

struct CardIntervals {
  double level;  // of confidence, between 0 and 1
  std::vector<CardInterval> of;
};

// A file that the numbers come from, and the SHA-256 of its bytes in 64 hexadecimal digits.
struct CardData {
  std::string file, sha256;
};

// The files that can be read, each once, without their folders.
std::vector<CardData> card_data(const std::vector<std::string>& files);

// Density and bulk modulus of a material of which only curves are known; the bulk modulus of an incompressible one.
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
inline constexpr double without_limit = std::numeric_limits<double>::infinity();

// W = sum_k (2 mu_k/alpha_k^2) (sum_i lambda_bar_i^alpha_k - 3) + U(J), U ~ K (J - 1)^2 / 2 near J = 1.
struct CardMaterial {
  std::string name = {};            // any text; each writer makes it fit its format
  double density = not_known;       // kg/m3
  std::vector<Ogden> terms = {};    // 1 to 3; mu in Pa; the sum of all mu is the small-strain shear modulus
  double bulk_modulus = not_known;  // Pa
  std::optional<CardErosion> erosion = {};
  std::vector<std::string> comments = {};  // sources of the data, one text each; written as comment lines
  std::optional<CardIntervals> intervals = {};
  std::string fit_error = {};      // a sentence; empty where it is not known
  std::string contradiction = {};  // why the data behind it contradict each other, a sentence; empty: they do not
  std::vector<CardData> data = {};
};

// The sum of all mu, Pa.
double shear_modulus(const CardMaterial& material);

// Throws BadInput for a number that no solid has: not finite, not positive, alpha = 0, K of 2/3 mu or less (no rubber is auxetic), no
// term or more than three. A single mu may be negative where the sum is positive; density and bulk modulus may be unknown, the latter
// without limit. The message names place.file and the key of the result file ("card.mu_true_Pa" where place.key is "card").
void check_solid(const CardMaterial& material, const Place& place);

// As above, and for a density or bulk modulus that is not known or has no limit: a card carries both.
void check(const CardMaterial& material, const Place& place);

// Sentences about numbers that a unit system read wrongly makes: a modulus or density of no soft solid.
std::vector<std::string> implausible(const CardMaterial& material);

// The material with the erosion strain of other elements (side and radius in m), its interval by the same factor; `how` becomes a
// comment. Of a material that erodes.
CardMaterial for_elements(const CardMaterial& material, double strain, double element, double radius,
                          const std::string& how);

// The number in a program's modulus field for a term of W = (2 mu/alpha^2) (sum lambda^alpha - 3), and back: the one place of
// this conversion.                                                                               docs/formats/cards.md
//   mu                 W = (2 field/alpha^2) (...)     Abaqus, CalculiX, OpenRadioss LAW82
//   two_mu_over_alpha  W = (field/alpha) (...)         LS-DYNA, OpenRadioss LAW42, Ansys
//   two_mu             W = (field/alpha^2) (...)       FEBio
enum class CardModulus { mu, two_mu_over_alpha, two_mu };

double modulus_field(const Ogden& term, CardModulus meaning);
Ogden term_of_field(double field, double alpha, CardModulus meaning);  // alpha not 0 with two_mu_over_alpha

std::string formula(CardModulus meaning);  // "mu", "2 mu/alpha", "2 mu"

}  // namespace percal
