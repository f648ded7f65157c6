// A sphere that deforms, in an axisymmetric scene: a half disc of quads (body.hpp) that meets the target's nodes with its deformed
// outline. docs/theory/elastic_particle.md.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "percal/impact/particle/body.hpp"
#include "percal/impact/particle/outline.hpp"
#include "percal/impact/particle/particle.hpp"

namespace percal {

// A touch of the target as the outline sees it: the nodes of the outline that the gap hangs on, and its derivatives by them.
struct OutlineTouch {
  int count = 0;
  std::array<int, 4> node{};
  std::array<Point, 4> by{};
};

// Of a meshed or drawn sphere: as fine as the target's, to the nearest whole number, or finer.
int elements_on_particle_radius(const Problem& problem);

// What SphereRun does, of a sphere with waves in it. Positions of the target have z downwards, those of the body y upwards:
// y = -z, and only this class changes from one to the other. Both are a radian's share.
class ElasticSphereRun {
 public:
  explicit ElasticSphereRun(const Problem& problem);

  void foresee(double time);
  template <class Real>
  int find(const Kernel<Real>&, const Block<Real>& block, const ContactNodes& nodes, int* found) const {
    const auto& fields = block.view();
    int count = 0;
    for (int j = nodes.rows.begin; j < nodes.rows.end; ++j) {
      const long n = block.at(nodes.column, j);
      const double x = nodes.x + fields.u_r[n], z = j * nodes.row_height + fields.u_z[n];
      if (fields.touchable[n] > 0 && outline_.may_hold(seen_from_here(x, z))) found[count++] = j;
    }
    return count;
  }
  // Goes through the touches in turn until none needs a larger impulse.
  double meet(std::vector<Touch>& touches, ContactColumns columns);
  // As many equal steps of the body's own as it needs.
  void drift(double time);

  double tip() const { return -outline_.lowest(); }
  double top() const { return -outline_.highest(); }
  double speed() const { return -body_.momentum()[1] / mass_; }
  double sideways() const { return 0; }
  double turn() const { return 0; }
  Overlap overlap(double x, double z) const;
  PointVelocity velocity_at(double x, double z) const;
  ParticleEnergy energy() const;
  ParticlePiece piece(const Problem& problem) const;
  // Why the run cannot go on, in words; empty where it can.
  const std::string& failure() const { return failure_; }

  const Body& body() const { return body_; }
  const Outline& outline() const { return outline_; }

 private:
  ElasticSphereRun(const Problem& problem, const Disc& disc);
  Point seen_from_here(double x, double z) const { return {x, -z + way_ahead_}; }
  OutlineTouch on_outline(const Touch& touch) const;
  void kick(const std::vector<Point>& impulses);
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
  double ahead_ = 0, way_ahead_ = 0;      // the time that is foreseen, and how far down it leads
  double rest_work_ = 0;                  // done on the body by what drift() gave out
  double own_inverse_square_step_ = 0;    // 1/dt^2 of the body
  double first_inverse_step_ = 0;         // 1/dt of the body at rest
  int moves_to_look_ = 0;
  std::string failure_;
};

}  // namespace percal
