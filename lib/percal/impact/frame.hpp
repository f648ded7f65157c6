// What an observer of a run sees: target and particle at one time, velocities and displacements alike. Dimensionless; x (or r)
// to the right, y upwards, the undeformed surface at y = 0. In space z is upwards. docs/formats/fields.md.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "percal/mesh/quads.hpp"

namespace percal {

// Of one cell, at its centre.
struct CellState {
  std::array<double, 3> stretches{1, 1, 1};  // principal, the largest first
  // Cauchy stress xx, yy, zz (hoop), xy, yz, xz over rho_t v^2, without bulk viscosity.
  std::array<double, 6> stress{};
  double energy_density = 0;  // stored by the deformation, per undeformed volume, over rho_t v^2

  bool operator==(const CellState&) const = default;
};

using SpacePoint = std::array<double, 3>;

// Points and polygons between them; of a target in space, hexahedra.
template <class Coordinates>
struct PieceOf {
  std::vector<Coordinates> position, displacement, velocity;
  // Corners of all cells, cell k has those before ends[k]: of a polygon counter-clockwise where it is not turned over; of a hexahedron the
  // lower four, seen from above, then the four above them.
  std::vector<int> corners, ends;
  std::vector<CellState> states;  // of cells; none where the piece does not deform
};

using FramePiece = PieceOf<Point>;
using SpacePiece = PieceOf<SpacePoint>;

template <class Coordinates>
struct TargetPieceOf : PieceOf<Coordinates> {
  // Of cells.
  std::vector<std::uint8_t> eroded;  // 1: taken out; its state is that of an undeformed cell
  std::vector<int> layer;            // 0: the uppermost
  std::vector<double> volume;        // undeformed; of a plane piece per radian or per thickness
};
using TargetPiece = TargetPieceOf<Point>;
using SpaceTarget = TargetPieceOf<SpacePoint>;

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

// What is computed of a block and of the particle in it, a quarter or a half of either.
struct SpaceFrame {
  SpaceTarget target;
  SpacePiece particle;
};

struct Frame {
  Moment moment;
  bool is_last = false;
  TargetPiece target;  // of a block its cut, the plane y = 0 in space
  ParticlePiece particle;
  std::function<SpaceFrame()> in_space = {};  // of a block alone; to be asked while the frame is seen
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
