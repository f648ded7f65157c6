// The particles that the march can shoot. Each keeps its own motion and meets the nodes of the target; the march asks:
//   foresee(time)          where it would be so much later
//   find(...), overlap     the nodes of one column that would then be inside it; how deep, and the way out
//   meet(touches, ...)     their impulses, its own velocities after them, and the kinetic energy lost
//   rub(touches, ...)      rigid ones: their impulses along the surface, its own velocities after them, and the energy that takes
//   drift(time)            position by the velocity
//   tip, top               its lowest and highest point, downwards positive
//   speed                  downwards, of the centre of mass
//   velocity_at            of one of its points
//   energy                 kinetic, and what it holds and loses where it deforms
//   failure                why the run cannot go on, in words
//   piece                  what an observer sees of it (frame.hpp)
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "percal/impact/frame.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/impact/particle/touch.hpp"
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
  double stored = 0;      // in its deformation
  double viscous = 0;     // lost to its viscosity up to now
  double collisions = 0;  // lost up to now where its outline took the target's impulses in parts
};

// Of a convex polygon, counter-clockwise, what is right of x = 0: from the lower crossing to the upper one.
std::vector<Point> right_half(const std::vector<Point>& polygon);

// The place of a body's centre of mass, z downwards, and how far it has turned anticlockwise.
struct BodyPlace {
  double x, z, angle;
};
// A rigid outline as it is now; y upwards. It stood on the surface at first, its lowest point `lowest` from the centre of mass.
ParticlePiece moved_piece(const std::vector<Point>& outline, double lowest, const BodyPlace& place,
                          const std::function<PointVelocity(double x, double z)>& velocity_at);

// What a particle that does not deform answers to the questions that only others have to think about.
struct NeverDeforms {
  static constexpr const char* failure() { return ""; }
};

// Straight down, as it stands. In plane strain a cylinder.
class SphereRun : public NeverDeforms {
 public:
  explicit SphereRun(const Problem& problem);

  void foresee(double time) { ahead_ = centre() + speed_ * time; }
  template <class Real>
  int find(const Kernel<Real>& kernel, const Block<Real>& block, const ContactNodes& nodes, int* found) const {
    return kernel.nodes_in_sphere(block.view(), nodes, ahead_, found);
  }
  double meet(std::vector<Touch>& touches, ContactColumns columns) {
    BodyMotion motion{.down = speed_};
    const double lost = body().part(touches, columns, motion);
    speed_ = motion.down;
    return lost;
  }
  double rub(std::vector<Touch>& touches, ContactColumns columns, double coefficient) {
    BodyMotion motion{.down = speed_};
    const double lost = body().rub(touches, columns, coefficient, motion);
    speed_ = motion.down;
    return lost;
  }
  void drift(double time) { tip_ += speed_ * time; }

  double tip() const { return tip_; }
  double top() const { return tip_ - 2; }
  double speed() const { return speed_; }
  double sideways() const { return 0; }
  double turn() const { return 0; }
  Overlap overlap(double x, double z) const {
    const double down = z - ahead_, distance = std::sqrt(x * x + down * down);
    if (distance >= 1 || distance == 0) return {};
    return {1 - distance, x / distance, down / distance};
  }
  PointVelocity velocity_at(double, double) const { return {0, speed_}; }
  ParticleEnergy energy() const { return {.kinetic = 0.5 * mass_ * speed_ * speed_}; }
  ParticlePiece piece(const Problem& problem) const;

 private:
  double centre() const { return tip_ - 1; }
  RigidBody body() const { return {{.down = 1 / mass_}, 0, ahead_, whole_}; }
  double mass_, speed_, tip_ = 0, ahead_ = 0;
  bool whole_;
};

// A convex polygon: a prism in plane strain, a body of revolution in an axisymmetric scene. Straight down, or free to turn and to
// move sideways.
class PolygonRun : public NeverDeforms {
 public:
  explicit PolygonRun(const Problem& problem);

  void foresee(double time);
  template <class Real>
  int find(const Kernel<Real>& kernel, const Block<Real>& block, const ContactNodes& nodes, int* found) const {
    return kernel.nodes_in_polygon(block.view(), nodes, ahead_.sides.data(), static_cast<int>(ahead_.sides.size()),
                                   ahead_.x, ahead_.z, found);
  }
  double meet(std::vector<Touch>& touches, ContactColumns columns) { return body().part(touches, columns, motion_); }
  double rub(std::vector<Touch>& touches, ContactColumns columns, double coefficient) {
    return body().rub(touches, columns, coefficient, motion_);
  }
  void drift(double time);

  double tip() const { return here_.z + here_.lowest; }
  double top() const { return here_.z + here_.highest; }
  double speed() const { return motion_.down; }
  double sideways() const { return here_.x; }
  double turn() const { return here_.angle; }
  Overlap overlap(double x, double z) const;
  PointVelocity velocity_at(double x, double z) const {
    return {motion_.right + motion_.spin * (z - here_.z), motion_.down - motion_.spin * (x - here_.x)};
  }
  ParticleEnergy energy() const {
    const double moving = mass_ * (motion_.down * motion_.down + motion_.right * motion_.right);
    return {.kinetic = 0.5 * (moving + inertia_ * motion_.spin * motion_.spin)};
  }
  ParticlePiece piece(const Problem& problem) const;

 private:
  // Where it is, by its centre of mass, with z downwards.
  struct Place {
    double x = 0, z = 0, angle = 0;
    double lowest = 0, highest = 0;  // of the vertices, from the centre of mass
    std::vector<PolygonSide> sides;
  };
  RigidBody body() const;
  void move(Place& place, double time) const;
  void turn_sides(Place& place) const;

  RigidPolygon profile_;
  bool whole_;
  double mass_, inertia_;
  BodyMotion motion_;
  Place here_, ahead_;
};

}  // namespace percal
