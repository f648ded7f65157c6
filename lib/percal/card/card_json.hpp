// The `card` object of a result file:
//   {"name", "density_kg_m3", "mu_true_Pa", "alpha", "bulk_modulus_Pa",
//    "erosion": {"strain", "measure"} or null, "comments": ["...", ...]}
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "percal/card/card_material.hpp"

namespace percal {

nlohmann::json card_to_json(const CardMaterial& material);

// Throws BadInput with place.file and the full key for what is missing, of another kind or out of range. A missing
// "erosion" is none, missing "comments" are none; the numbers and the name must be there.
CardMaterial card_from_json(const nlohmann::json& card, const Place& place);

// The card of a result file's whole text: its `card` object. Throws BadInput where the text is not JSON (with the line)
// or has no card, as the results of `percal fit` and `percal impact`, which know no density.
CardMaterial card_of_result(const std::string& text, const std::string& file);

}  // namespace percal
