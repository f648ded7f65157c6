// Runs of spheres over the box that users live in, and what they say of a sphere at a place in it.
//
//     const percal::Atlas& atlas = percal::own_atlases().front();
//     const percal::Emulator near = percal::emulator_near(atlas, at);     // at: SphereInputs
//     near.depth({at}, 0.1, true);                                        // ln of the reach in radii, on 10 elements per radius
#pragma once
#include "percal/atlas/atlas.hpp"
#include "percal/atlas/check.hpp"
#include "percal/atlas/expected.hpp"
