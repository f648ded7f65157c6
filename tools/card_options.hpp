// What the card commands share: the material of a result, or of a card of any program.
#pragma once
#include "commands.hpp"
#include "percal/card/card_json.hpp"
#include "percal/card/curve.hpp"
#include "percal/card/solver.hpp"

namespace percal::tools {

// --density, --bulk-to-shear or --nu, and --name or --card. Throws BadInput for numbers that are none.
CardRequest card_request(const CardArguments& card);

// --mode, --range and --points.
CurveRange curve_range(const CardArguments& card);

// A material read from a card.
struct ReadCard {
  FoundCard found;
  std::string solver;  // its word; empty where the file was a result of percal
  std::string units;
};

// Recognises the program by --solver or by its keywords and the units by --units or by the comment of a percal card. A result of
// percal is taken as well.
ReadCard read_any_card(const CardArguments& card);

// Throws IoFailure where standard output cannot be written.
void print_text(const std::string& text);

}  // namespace percal::tools
