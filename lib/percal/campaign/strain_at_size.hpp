// The erosion strain that another element size wants: the one that sends a shot as deep.
// docs/theory/errors.md, The erosion strain of another element size
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/campaign/campaign.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

// Element sizes that a strain is looked for, over the radius.
inline constexpr double smallest_element = 1.0 / 40, largest_element = 1.0 / 4;

struct StrainTrial {
  double strain = 0;
  Penetration penetration;
};

struct StrainAtSize {
  std::string why_not = {};              // in words, where none was found; else empty
  double strain = 0;                     // in the scene's measure
  double half_width = 0;                 // 95 %: of both depths' phases, over the depth's slope
  double own_strain = 0;                 // the scene's
  double element = 0;                    // m
  double own_element = 0;                // m
  double radius = 0;                     // m, of the particle
  Penetration own = {};                  // on the scene's own mesh, with its own strain
  std::vector<StrainTrial> trials = {};  // on the other mesh
};

// Throws BadInput at `place` for a scene that does not erode by strain, for elements out of the range above, larger than a third of an
// erosion length, or more than can be run.
void need_element_size(const Scene& scene, double element, const Place& place);

// How many runs strain_at_size() makes, for a progress bar.
long strain_runs(const Scene& scene);

// By phase means on both meshes: a line through ln depth over ln strain of five trials. As need_element_size().
StrainAtSize strain_at_size(const Scene& scene, double element, Campaign& campaign, Progress* progress);

}  // namespace percal
