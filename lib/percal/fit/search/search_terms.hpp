// Every minimum of a model's objective: a scan of the exponents, then Ceres from each of its minima.
#pragma once
#include <optional>
#include <vector>

#include "percal/fit/search/polish.hpp"

namespace percal {

inline constexpr double largest_alpha = 40;  // exponents are searched between -largest_alpha and largest_alpha

struct FoundMinima {
  std::vector<Polished> minima =
      {};  // moduli in the scale of the points; without terms whose modulus is zero; unordered
  std::optional<Polished> refused = {};  // the best whose moduli add up to no positive one
  int scanned = 0;                       // sets of exponents with the moduli solved for
  int starts = 0;                        // of Ceres
};

// The minimum with the lowest objective; nullptr where there is none.
const Polished* best_of(const FoundMinima& found);

FoundMinima search_terms(Model model, const std::vector<WeightedPoint>& points, Signs signs, const ScaledLoss& loss);

}  // namespace percal
