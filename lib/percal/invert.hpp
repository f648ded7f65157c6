// invert: from depths back to materials.
//
// An emulator of the solver that states its own error, a closed form of the depth, and the modulus that gives a depth.
// The forward model is a function.
//
// See docs/theory/emulator.md.
#pragma once
#include "percal/invert/dehn.hpp"
#include "percal/invert/emulator.hpp"
#include "percal/invert/emulator_search.hpp"
#include "percal/invert/modulus.hpp"
