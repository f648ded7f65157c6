// Incompressible solids whose energy is a sum of Ogden terms, each linear in its modulus:
//   W = sum_k (2 mu_k/alpha_k^2) (lambda_1^alpha_k + lambda_2^alpha_k + lambda_3^alpha_k - 3)
// Neo-Hooke is the term alpha = 2; Mooney-Rivlin has alpha = 2 and alpha = -2, C10 = mu_1/2 and C01 = mu_2/2.
// docs/theory/curves.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/material/homogeneous.hpp"

namespace percal {

enum class Model { ogden, ogden2, ogden3, neo_hooke, mooney_rivlin };
inline constexpr Model all_models[] = {Model::neo_hooke, Model::mooney_rivlin, Model::ogden, Model::ogden2,
                                       Model::ogden3};

int terms_of(Model model);
// The exponents that the model fixes, one for each term; empty where they are free.
std::vector<double> fixed_alphas(Model model);
// Moduli and free exponents.
int parameters_of(Model model);

// "ogden", "ogden2", "ogden3", "neo-hooke", "mooney-rivlin"; nullopt for other words.
std::string word(Model model);
std::optional<Model> model_of(const std::string& word);

struct Hyperelastic {
  std::vector<Ogden> terms;  // mu in Pa; a single mu may be negative where the sum is a solid
};

// The sum of all mu_k, Pa.
double small_strain_modulus(const Hyperelastic& solid);

// Nominal stress, Pa; in simple shear the shear stress. As for one term (homogeneous.hpp).
double nominal_stress(const Hyperelastic& solid, const PrincipalPair& pair);
double nominal_stress(const Hyperelastic& solid, const Strained& strained);

// Of a term with mu = 1: nominal stress, and its derivative with respect to alpha. The term's own is mu times as much,
// and the derivative with respect to mu is `stress`.                                                        (16)
struct UnitTerm {
  double stress;
  double by_alpha;
};
UnitTerm unit_term(double alpha, const PrincipalPair& pair);

}  // namespace percal
