// The particles that the march can shoot. Each keeps its own motion and meets the nodes of the target; the march asks:
//   touch(...)             adds the contact forces to the nodes; the report is what they do to the particle
//   kick(report, time)     velocity by the report's force; speed_change: how much that makes of the speed
//   drift(time)            position by the velocity
//   tip, top               its lowest and highest point, downwards positive
//   speed                  downwards, of the centre of mass
//   overlap, velocity_at   of one point with the particle
//   energy                 kinetic, and what it holds and loses where it deforms
//   failure                why the run cannot go on, in words
//   piece                  what an observer sees of it (frame.hpp)
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "percal/impact/frame.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/impact/target/block.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// How deep a point lies inside the particle (0: outside) and the outward direction there; z downwards.
struct Overlap {
  double gap = 0, normal_x = 0, normal_z = 0;
};
struct PointVelocity {
  double x = 0, z = 0;
};

struct ParticleEnergy {
  double kinetic = 0;
  double stored = 0;   // in its deformation
  double viscous = 0;  // lost to its viscosity up to now
};

// What a particle that does not deform answers to the questions that only others have to think about.
struct NeverDeforms {
  using Contact = ContactReport;
  static constexpr double spring_stiffness_per_mass() { return 0; }  // its nodes do not limit the step
  static constexpr const char* failure() { return ""; }
};

// Columns and rows of nodes that are looked at for contact.
struct ContactRegion {
  int column_begin, column_end;
  Rows rows;
};

// Sums the reports of the columns, from the outermost inwards. Those of a whole mesh are summed in pairs, left and right, so that
// the mirrored scene has the mirrored sum to the last bit, and half a model has half of it.
ContactReport sum_of_columns(std::span<const ContactReport> columns, bool whole);

// The columns' reports of one look, and their sum.
template <class Real, class Touch>
ContactReport touch_columns(const Block<Real>& block, const ContactRegion& region, bool whole,
                            std::vector<ContactReport>& reports, Touch touch) {
  reports.assign(region.column_end - region.column_begin, {});
  for (int i = region.column_begin; i < region.column_end; ++i)
    touch(ContactNodes{i, block.mesh().radius[i], block.mesh().row_height, region.rows},
          reports[i - region.column_begin]);
  return sum_of_columns(reports, whole);
}

// Straight down, as it stands. In plane strain a cylinder.
class SphereRun : public NeverDeforms {
 public:
  explicit SphereRun(const Problem& problem);

  template <class Real>
  ContactReport touch(const Kernel<Real>& kernel, const Block<Real>& block, const NodeForces<Real>& forces,
                      const ContactRegion& region) {
    return touch_columns(block, region, whole_, reports_, [&](const ContactNodes& nodes, ContactReport& report) {
      kernel.sphere_contact(block.view(), forces, nodes, centre(), report);
    });
  }
  void kick(const ContactReport& report, double time) { speed_ += speed_change(report, time); }
  void drift(double time) { tip_ += speed_ * time; }

  double tip() const { return tip_; }
  double top() const { return tip_ - 2; }
  double speed() const { return speed_; }
  double speed_change(const ContactReport& report, double time) const { return -report.force / mass_ * time; }
  double sideways() const { return 0; }
  double turn() const { return 0; }
  Overlap overlap(double x, double z) const {
    const double down = z - centre(), distance = std::sqrt(x * x + down * down);
    if (distance >= 1 || distance == 0) return {};
    return {1 - distance, x / distance, down / distance};
  }
  PointVelocity velocity_at(double, double) const { return {0, speed_}; }
  ParticleEnergy energy() const { return {.kinetic = 0.5 * mass_ * speed_ * speed_}; }
  ParticlePiece piece(const Problem& problem) const;

 private:
  double centre() const { return tip_ - 1; }
  double mass_, speed_, tip_ = 0;
  bool whole_;
  std::vector<ContactReport> reports_;
};

// A convex polygon: a prism in plane strain, a body of revolution in an axisymmetric scene. Straight down, or free to turn and to
// move sideways.
class PolygonRun : public NeverDeforms {
 public:
  explicit PolygonRun(const Problem& problem);

  template <class Real>
  ContactReport touch(const Kernel<Real>& kernel, const Block<Real>& block, const NodeForces<Real>& forces,
                      const ContactRegion& region) {
    return touch_columns(block, region, whole_, reports_, [&](const ContactNodes& nodes, ContactReport& report) {
      kernel.polygon_contact(block.view(), forces, nodes, sides_.data(), static_cast<int>(sides_.size()), x_, z_,
                             report);
    });
  }
  void kick(const ContactReport& report, double time);
  void drift(double time);

  double tip() const { return z_ + lowest_; }
  double top() const { return z_ + highest_; }
  double speed() const { return speed_; }
  double speed_change(const ContactReport& report, double time) const { return -report.force / mass_ * time; }
  double sideways() const { return x_; }
  double turn() const { return angle_; }
  Overlap overlap(double x, double z) const;
  PointVelocity velocity_at(double x, double z) const {
    return {sideways_speed_ + spin_ * (z - z_), speed_ - spin_ * (x - x_)};
  }
  ParticleEnergy energy() const {
    const double moving = mass_ * (speed_ * speed_ + sideways_speed_ * sideways_speed_);
    return {.kinetic = 0.5 * (moving + inertia_ * spin_ * spin_)};
  }
  ParticlePiece piece(const Problem& problem) const;

 private:
  void turn_sides();
  RigidPolygon profile_;
  bool whole_;
  double mass_, inertia_;
  double x_ = 0, z_ = 0, angle_ = 0;                  // of the centre of mass
  double sideways_speed_ = 0, speed_ = 1, spin_ = 0;  // spin anticlockwise
  double lowest_ = 0, highest_ = 0;                   // of the vertices below the centre of mass
  std::vector<PolygonSide> sides_;
  std::vector<ContactReport> reports_;
};

}  // namespace percal
