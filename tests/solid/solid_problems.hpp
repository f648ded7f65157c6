// Problems of a block in three dimensions that tests start from.
#pragma once
#include "percal/impact/frame.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// Gold at 651 m/s into skin, as impact/setting_s.hpp, on four elements; a quarter of it.
inline Problem block_setting_s(double elements_per_radius = 4) {
  Problem p;
  p.geometry = Geometry::block;
  p.pi4 = 6.6474;
  p.density_ratio = 16.8;
  p.alpha = 8.5;
  p.erosion = StrainErosion{0.7};
  p.depth = 45;
  p.bottom = Bottom::fixed;
  p.elements_per_radius = elements_per_radius;
  p.graded_columns = 0;
  p.hourglass = 2;
  p.rates = 1;
  p.block.fine_depth = p.depth;
  return p;
}

// Nothing erodes: the sphere makes a dent of some 2.4 radii.
inline Problem block_dent(double elements_per_radius = 4) {
  Problem p = block_setting_s(elements_per_radius);
  p.pi4 = 1;
  p.erosion = NoErosion{};
  p.depth = p.block.fine_depth = 15;
  return p;
}

// A cube on its side, 2 x 2 x 2 radii, of a block's density ratio: as a prism.
inline RigidPolygon cube_prism(double density_ratio) {
  return {.vertices = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},
          .mass = 8 * density_ratio,
          .inertia = 8 * density_ratio * 2 / 3,
          .half_thickness = 1};
}

// The last frame of a run.
struct LastFrame : FrameObserver {
  bool is_due(const Moment&) override { return false; }
  void see(const Frame& seen) override {
    frame = seen;
    space = seen.in_space();
  }
  Frame frame;
  SpaceFrame space;
};

}  // namespace percal
