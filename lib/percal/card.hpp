// card: material cards.
//
// What a card says, in SI and in percal's own convention; writers and readers for six programs, each with its own
// convention and your units.
//
//     const percal::CardMaterial gel = percal::card_of_result(percal::read_file("result.json"), "result.json");
//     std::cout << percal::solver_named("lsdyna").card(gel, percal::unit_system("mm-t-s-MPa"));
//
// See docs/formats/cards.md.
#pragma once
#include "percal/card/card_json.hpp"
#include "percal/card/card_material.hpp"
#include "percal/card/solver.hpp"
#include "percal/card/uniaxial_deck.hpp"
#include "percal/card/unit_system.hpp"
