// A sphere that deforms, in an axisymmetric scene: a half disc of quads (body.hpp) that meets the target's nodes with its deformed
// outline. docs/theory/elastic_particle.md.
#pragma once
#include <string>
#include <vector>

#include "percal/impact/particle/body.hpp"
#include "percal/impact/particle/outline.hpp"
#include "percal/impact/particle/particle.hpp"

namespace percal {

// What the target does to one node of the outline, y upwards.
struct OutlineLoad {
  Point force{};
  double stiffness = 0;  // of the springs on it, by their shares
};

// One look at the contact. Empty `loads`: nothing touches.
struct ElasticContact : ContactReport {
  std::vector<OutlineLoad> loads;

  ElasticContact& operator+=(const ElasticContact& other);
};

// Of a meshed or drawn sphere: as fine as the target's, to the nearest whole number, or finer.
int elements_on_particle_radius(const Problem& problem);

// What SphereRun does, of a sphere with waves in it. Positions of the target have z downwards, those of the body y upwards:
// y = -z, and only this class changes from one to the other. Both are a radian's share.
class ElasticSphereRun {
 public:
  using Contact = ElasticContact;
  explicit ElasticSphereRun(const Problem& problem);

  template <class Real>
  Contact touch(const Kernel<Real>&, const Block<Real>& block, const NodeForces<Real>& forces,
                const ContactRegion& region) const {
    Contact contact;
    const auto& fields = block.view();
    for (int i = region.column_begin; i < region.column_end; ++i)
      for (int j = region.rows.begin; j < region.rows.end; ++j) {
        const long n = block.at(i, j);
        const double stiffness = fields.contact_stiffness[n];
        if (!(stiffness > 0)) continue;
        const Point at{block.mesh().radius[i] + fields.u_r[n], -(j * block.mesh().row_height + fields.u_z[n])};
        if (!outline_.may_hold(at)) continue;
        const Point push = meet(at, stiffness, contact);
        forces.r[n] += static_cast<Real>(push[0]);
        forces.z[n] -= static_cast<Real>(push[1]);
      }
    return contact;
  }
  void kick(const Contact& contact, double time);
  // As many equal steps of the body's own as it needs.
  void drift(double time);

  double tip() const { return -outline_.lowest(); }
  double top() const { return -outline_.highest(); }
  double speed() const { return -body_.momentum()[1] / mass_; }
  double speed_change(const Contact& contact, double time) const { return -contact.force / mass_ * time; }
  double sideways() const { return 0; }
  double turn() const { return 0; }
  Overlap overlap(double x, double z) const;
  PointVelocity velocity_at(double x, double z) const;
  ParticleEnergy energy() const;
  ParticlePiece piece(const Problem& problem) const;
  // Largest so far, of the contact springs on a node of the outline over its mass, with a margin.
  double spring_stiffness_per_mass() const { return spring_stiffness_per_mass_; }
  // Why the run cannot go on, in words; empty where it can.
  const std::string& failure() const { return failure_; }

  const Body& body() const { return body_; }
  const Outline& outline() const { return outline_; }

 private:
  ElasticSphereRun(const Problem& problem, const Disc& disc);
  // The force on a node of the target that is at `at`; what it does to the outline is added to `contact`.
  Point meet(const Point& at, double stiffness, ElasticContact& contact) const;
  void give_out(double share);
  void look_at_step();
  double steps_in(double time) const;
  void follow_outline();
  Point outline_velocity(const WayOut& way) const;

  Body body_;
  std::vector<int> boundary_;  // nodes of the body, in the order of the outline's points
  Outline outline_;
  std::vector<Point> blow_;  // velocities that kick() gave and drift() has yet to give out
  double mass_ = 0;
  double target_springs_;               // of the target's nodes over their masses
  double own_inverse_square_step_ = 0;  // 1/dt^2 of the body alone
  double spring_stiffness_per_mass_ = 0;
  int moves_to_look_ = 0;
  std::string failure_;
};

}  // namespace percal
