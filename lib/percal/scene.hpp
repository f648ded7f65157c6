// scene: an impact as the user wrote it.
//
// A particle, the layers that it hits, mesh and solver settings, in SI. Read from TOML and written to it.
//
//     percal::Scene scene = percal::read_scene("gold.toml");
//     scene.particle.speed = 500;  // m/s
//     std::cout << percal::scene_to_toml(scene, "slower");
//
// See docs/formats/scene.md.
#pragma once
#include "percal/scene/profile.hpp"
#include "percal/scene/scene.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/scene/width.hpp"
