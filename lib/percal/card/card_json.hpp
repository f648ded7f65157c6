// The common card block of results. Every result of identify, calibrate and fit has the array `cards` of objects
//   {"name", "density_kg_m3", "mu_true_Pa", "alpha", "bulk_modulus_Pa",
//    "erosion": {"strain", "measure", "element_over_radius" or null, "element_m" or null} or null, "comments": ["...", ...],
//    "intervals": {"level", "mu_true_Pa": {"low", "high"}, ...}, "fit_error", "contradiction", "data": [{"file", "sha256"}, ...]}
// With several Ogden terms "terms": [{"mu_true_Pa", "alpha"}, ...] stands for mu_true_Pa and alpha. Density and bulk modulus are
// null where the data do not tell them: a fit's.                                                  docs/formats/cards.md
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "percal/card/card_material.hpp"
#include "percal/card/solver.hpp"

namespace percal {

nlohmann::json card_to_json(const CardMaterial& material);
// A card that was read: the object under `card`, its program and units, and what a reader should know of it (passed_over,
// erodes_otherwise, warnings).
nlohmann::json read_card_to_json(const ReadCard& read);
nlohmann::json cards_to_json(const std::vector<CardMaterial>& materials);

// Throws BadInput with place.file and the full key for what is missing, of another kind or out of range. A missing
// "erosion" is none, missing "comments" are none; the numbers and the name must be there.
CardMaterial card_from_json(const nlohmann::json& card, const Place& place);

// What a user says beside a result: the name chooses among several cards, and names the only one. Density and bulk_to_shear
// stand over what the card says; that of a fit needs them to be written.
struct CardRequest {
  std::string name = {};
  std::optional<double> density = {};        // kg/m3
  std::optional<double> bulk_to_shear = {};  // K over the small-strain shear modulus
  bool complete = true;                      // refuse a card without density or bulk modulus; a curve needs neither
};

// The card of a result file's whole text: one of its `cards`, or the object `card` of percal card read --json. Throws BadInput
// where the text is not JSON (with the line), has no card, leaves open which, or lacks a number.
CardMaterial card_of_result(const std::string& text, const std::string& file, const CardRequest& request = {});

}  // namespace percal
