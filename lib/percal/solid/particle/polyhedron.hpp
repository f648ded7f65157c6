// Rigid convex polyhedra, which may turn about all axes. They answer to what bodies answer to (body.hpp); what a plane of symmetry, or a
// scene that holds the body, keeps from moving has no share in it. x to the right, y away, z downwards.     docs/theory/solid.md, "Polyhedra"
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

#include "percal/math/polyhedron.hpp"
#include "percal/solid/particle/body.hpp"

namespace percal {

// How a rigid body turns about its centre of mass.
class Top {
 public:
  // `inertia` about the centre, as the body stands at first; `free`: 1 for axes about which it may turn, else 0.
  Top(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& free);

  // From how it stood at first.
  const Eigen::Matrix3d& attitude() const { return attitude_; }
  // Angular momentum over its inverse is the spin; 0 about axes that are held.
  Eigen::Matrix3d inverse_inertia() const { return inverse_inertia_at(attitude_); }
  Eigen::Vector3d spin() const { return inverse_inertia() * momentum_; }
  const Eigen::Vector3d& momentum() const { return momentum_; }
  double energy() const { return 0.5 * momentum_.dot(spin()); }
  void push(const Eigen::Vector3d& impulse) { momentum_ += free_.cwiseProduct(impulse); }
  // Its angular momentum stays; the spin of the middle of that time turns it.     docs/theory/solid.md (15)
  void turn(double time);

 private:
  Eigen::Matrix3d inverse_inertia_at(const Eigen::Matrix3d& attitude) const;

  Eigen::Matrix3d inverse_inertia_;  // as it stood at first
  Eigen::Vector3d free_;
  Eigen::Matrix3d attitude_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d momentum_ = Eigen::Vector3d::Zero();
};

class PolyhedronRun : public NeverDeforms {
 public:
  explicit PolyhedronRun(const Problem& problem);

  void foresee(double time) {
    ahead_ = here_;
    move(ahead_, time);
  }
  template <class Real>
  int find(const SolidKernel<Real>& kernel, const SolidBlock<Real>& block, const ColumnNodes& nodes, int* found) const {
    return kernel.nodes_in_polyhedron(block.fields(), nodes, ahead_.faces.data(), static_cast<int>(ahead_.faces.size()),
                                      reach_, {ahead_.centre[0], ahead_.centre[1], ahead_.centre[2]}, found);
  }
  SpaceOverlap overlap(const std::array<double, 3>& point) const {
    const auto& c = ahead_.centre;
    return overlap_with(ahead_.faces, {point[0] - c[0], point[1] - c[1], point[2] - c[2]});
  }
  double meet(std::vector<Touch>& touches, ContactColumns columns);
  double rub(std::vector<Touch>& touches, ContactColumns columns, double coefficient);
  void drift(double time);

  double tip() const { return here_.centre[2] + here_.lowest; }
  double top() const { return here_.centre[2] + here_.highest; }
  double speed() const { return velocity_[2]; }
  double sideways() const { return here_.centre[0]; }
  double across() const { return here_.centre[1]; }
  // Anticlockwise about y; of one that turns about all axes the angle of in_space().axis.
  double turn() const;
  std::optional<SpacePath> in_space() const;
  double reach() const { return reach_; }
  std::array<double, 2> along_y(double margin) const;
  std::array<double, 3> velocity_at(const std::array<double, 3>& point) const;
  ParticleEnergy energy() const { return {.kinetic = 0.5 * mass_ * velocity_.squaredNorm() + here_.top.energy()}; }
  // What the plane y = 0 cuts out of it.
  ParticlePiece piece(const Problem& problem) const;
  SpacePiece space_piece(const Problem& problem) const;

 private:
  // The centre of mass, how it has turned, and what follows from that.
  struct Place {
    Eigen::Vector3d centre;
    Top top;
    std::vector<PolyhedronFace> faces;
    double lowest = 0, highest = 0;  // of its corners, from the centre
  };
  // Impulses as impulses(body, its velocities) finds them; the kinetic energy lost.
  template <class Impulses>
  double exchange(const Impulses& impulses);
  void move(Place& place, double time) const;
  void turn_faces(Place& place) const;
  Eigen::Vector3d first_centre() const { return {0, 0, -first_lowest_}; }
  void add_point(SpacePiece& piece, const Eigen::Vector3d& corner) const;

  Polyhedron body_;  // as it stood at first, z upwards
  std::vector<PolyhedronFace> first_faces_;
  std::vector<Eigen::Vector3d> corners_;
  double mass_, reach_, first_lowest_ = 0;
  double angle_ = 0;       // turned about y
  Eigen::Vector3d moves_;  // 1 along axes along which it may move, else 0
  bool all_axes_;          // it may turn about
  Place here_, ahead_;
  Eigen::Vector3d velocity_;
};

}  // namespace percal
