// One cube of one element, stretched along one direction with free sides, ready to run: what a card means in its own program.
#pragma once
#include <string>

#include "percal/card/solver.hpp"

namespace percal {

// The deck that goes from stretch 1 to `stretch` in `increments` equal steps of displacement; it asks for reaction force
// and displacement at every step. Contains the card of write_card() as it stands.
std::string uniaxial_deck(Solver solver, const CardMaterial& material, const UnitSystem& units, double stretch,
                          int increments);

}  // namespace percal
