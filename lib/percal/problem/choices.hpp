// Everything that a scene may ask for and may leave out, on one page. Each is a variant with an empty alternative: what is
// left out has no state and costs no work. The march is composed once a run from these.
#pragma once
#include <variant>

#include "percal/scene/scene.hpp"

namespace percal {

// Elements that are stretched too far are taken out of the mesh, or nothing is.
//   NoErosion, StrainErosion: scene/scene.hpp

// The penetration history, or nothing.
struct NoHistory {};
struct History {
  int samples = 400;
};  // about this many, evenly spaced in steps
using HistoryChoice = std::variant<NoHistory, History>;

static_assert(std::is_empty_v<NoErosion> && std::is_empty_v<NoHistory>);

}  // namespace percal
