// The optional part of a card object: intervals, error of the fit, data files.                       docs/formats/cards.md
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "percal/card/card_material.hpp"

namespace percal {

void add_provenance(const CardMaterial& material, nlohmann::json& card);

// Throws BadInput with the full key for what is of another kind.
void read_provenance(const nlohmann::json& card, const Place& place, CardMaterial& material);

}  // namespace percal
