// The `card` object of a result file:
//   {"name", "density_kg_m3", "mu_true_Pa", "alpha", "bulk_modulus_Pa",
//    "erosion": {"strain", "measure"} or null, "comments": ["...", ...],
//    "intervals": {"level", "mu_true_Pa": {"low", "high"}, ...}, "fit_error", "data": [{"file", "sha256"}, ...]}
// With several Ogden terms "terms": [{"mu_true_Pa", "alpha"}, ...] stands for mu_true_Pa and alpha.  docs/formats/cards.md
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "percal/card/card_material.hpp"

namespace percal {

nlohmann::json card_to_json(const CardMaterial& material);

// Throws BadInput with place.file and the full key for what is missing, of another kind or out of range. A missing
// "erosion" is none, missing "comments" are none; the numbers and the name must be there.
CardMaterial card_from_json(const nlohmann::json& card, const Place& place);

// What a result does not say itself. A result of percal fit needs density and bulk_to_shear; name chooses among several
// cards and names the card of a fit. What is given stands over what a card object says.
struct CardRequest {
  std::string name = {};
  std::optional<double> density = {};        // kg/m3
  std::optional<double> bulk_to_shear = {};  // K over the small-strain shear modulus
};

// The card of a result file's whole text: its `card` object, one of its `cards`, or made from the best minimum of a result of
// percal fit. Throws BadInput where the text is not JSON (with the line), has no card, or leaves open which.
CardMaterial card_of_result(const std::string& text, const std::string& file, const CardRequest& request = {});

}  // namespace percal
