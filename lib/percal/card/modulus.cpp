#include "percal/card/modulus.hpp"

namespace percal {

double modulus_field(const Ogden& term, CardModulus meaning) {
  switch (meaning) {
    case CardModulus::two_mu_over_alpha: return 2 * term.mu / term.alpha;
    case CardModulus::two_mu: return 2 * term.mu;
    case CardModulus::mu: break;
  }
  return term.mu;
}

Ogden term_of_field(double field, double alpha, CardModulus meaning) {
  switch (meaning) {
    case CardModulus::two_mu_over_alpha: return {field * alpha / 2, alpha};
    case CardModulus::two_mu: return {field / 2, alpha};
    case CardModulus::mu: break;
  }
  return {field, alpha};
}

std::string formula(CardModulus meaning) {
  switch (meaning) {
    case CardModulus::two_mu_over_alpha: return "2 mu/alpha";
    case CardModulus::two_mu: return "2 mu";
    case CardModulus::mu: break;
  }
  return "mu";
}

}  // namespace percal
