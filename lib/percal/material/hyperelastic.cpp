#include "percal/material/hyperelastic.hpp"

#include <cmath>

namespace percal {
namespace {

// d(sinh(x)/x)/dx = (cosh(x) - sinh(x)/x)/x, near zero by its series.                      docs/theory/curves.md (17)
double slope_of_sinh_over(double x) {
  if (std::abs(x) >= 1) return (std::cosh(x) - std::sinh(x) / x) / x;
  double sum = 1;
  for (int k = 10; k >= 2; --k) sum = 1 + sum * x * x / ((2.0 * k - 2) * (2.0 * k + 1));
  return x * sum / 3;
}

}  // namespace

int terms_of(Model model) {
  switch (model) {
    case Model::ogden3: return 3;
    case Model::ogden2:
    case Model::mooney_rivlin: return 2;
    default: return 1;
  }
}

std::vector<double> fixed_alphas(Model model) {
  if (model == Model::neo_hooke) return {2};
  if (model == Model::mooney_rivlin) return {2, -2};
  return {};
}

int parameters_of(Model model) { return terms_of(model) * (fixed_alphas(model).empty() ? 2 : 1); }

std::string word(Model model) {
  switch (model) {
    case Model::ogden2: return "ogden2";
    case Model::ogden3: return "ogden3";
    case Model::neo_hooke: return "neo-hooke";
    case Model::mooney_rivlin: return "mooney-rivlin";
    case Model::ogden: break;
  }
  return "ogden";
}

std::optional<Model> model_of(const std::string& text) {
  for (const Model model : all_models)
    if (text == word(model)) return model;
  return std::nullopt;
}

double small_strain_modulus(const Hyperelastic& solid) {
  double sum = 0;
  for (const auto& term : solid.terms) sum += term.mu;
  return sum;
}

double nominal_stress(const Hyperelastic& solid, const PrincipalPair& pair) {
  double sum = 0;
  for (const auto& term : solid.terms) sum += nominal_stress(term, pair);
  return sum;
}

double nominal_stress(const Hyperelastic& solid, const Strained& strained) {
  return nominal_stress(solid, principal_pair(strained));
}

UnitTerm unit_term(double alpha, const PrincipalPair& pair) {
  const double mean = (pair.log_i + pair.log_j) / 2, half = (pair.log_i - pair.log_j) / 2;
  const double factor = 4 * half * pair.nominal_factor * std::exp(alpha * mean), x = alpha * half;
  const double shape = sinh_over(x);
  return {factor * shape, factor * (mean * shape + half * slope_of_sinh_over(x))};
}

}  // namespace percal
