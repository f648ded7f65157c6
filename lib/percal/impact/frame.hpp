// What an observer of a run sees: target and particle at one time, velocities and displacements alike. Dimensionless; x (or r)
// to the right, y upwards, the undeformed surface at y = 0. docs/formats/fields.md.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "percal/mesh/quads.hpp"

namespace percal {

// Of one cell, at its centre.
struct CellState {
  std::array<double, 3> stretches{1, 1, 1};  // principal, the largest first
  // Cauchy stress xx, yy, zz (hoop), xy over rho_t v^2, without bulk viscosity.
  std::array<double, 4> stress{};
  double energy_density = 0;  // stored by the deformation, per undeformed volume, over rho_t v^2

  bool operator==(const CellState&) const = default;
};

// Points and polygons between them.
struct FramePiece {
  std::vector<Point> position, displacement, velocity;
  // Corners of all cells, each counter-clockwise where it is not turned over; cell k has those before ends[k].
  std::vector<int> corners, ends;
  std::vector<CellState> states;  // of cells; none where the piece does not deform
};

struct TargetPiece : FramePiece {
  // Of cells.
  std::vector<std::uint8_t> eroded;  // 1: taken out; its state is that of an undeformed cell
  std::vector<int> layer;            // 0: the uppermost
  std::vector<double> volume;        // undeformed, per radian or per thickness
};

struct ParticlePiece : FramePiece {
  // Points around it, counter-clockwise; where the piece is half of the particle, from the axis at the bottom to the axis at
  // the top.
  std::vector<int> outline;
};

// When a frame is taken.
struct Moment {
  double time = 0;  // radii over impact speed
  double tip = 0;   // depth of the particle's lowest point
  long step = 0;    // of the longer kind
};

struct Frame {
  Moment moment;
  bool is_last = false;
  TargetPiece target;
  ParticlePiece particle;
};

// Looks at a run from outside and changes nothing in it. Both are called on the thread that called run_impact; what they throw
// ends the run.
class FrameObserver {
 public:
  virtual ~FrameObserver() = default;
  // Asked at every long step, in order.
  virtual bool is_due(const Moment& now) = 0;
  // A frame that was due; and the run's last state, due or not.
  virtual void see(const Frame& frame) = 0;
};

}  // namespace percal
