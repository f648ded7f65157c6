#include "percal/impact/particle/touch.hpp"

#include "percal/impact/particle/impulses.hpp"

namespace percal {
namespace {

// Down, right and spin.
struct PlaneBody {
  using Velocities = Eigen::Vector3d;
  const RigidBody& body;

  Eigen::DiagonalMatrix<double, 3> inverse_mass() const {
    return Eigen::DiagonalMatrix<double, 3>(of(body.inverse_mass));
  }
  Velocities lever(const Touch& touch) const { return lever(touch, touch.away_x, touch.away_z); }
  Velocities sliding_lever(const Touch& touch) const { return lever(touch, touch.along_x, touch.along_z); }
  static bool may_slide(const Touch& touch) { return touch.along_x != 0 || touch.along_z != 0; }
  bool whole() const { return body.whole; }

  static Velocities of(const BodyMotion& motion) { return {motion.down, motion.right, motion.spin}; }

 private:
  Velocities lever(const Touch& touch, double x, double z) const {
    return {z, x, x * (touch.z - body.z) - z * (touch.x - body.x)};
  }
};

double take(const ImpulseChange<PlaneBody>& change, BodyMotion& motion) {
  const auto& q = change.velocity;
  motion = {motion.down + q[0], motion.right + q[1], motion.spin + q[2]};
  return change.lost;
}

}  // namespace

double RigidBody::part(std::vector<Touch>& touches, ContactColumns among, BodyMotion& motion) const {
  return take(part_touches(PlaneBody{*this}, touches, among, PlaneBody::of(motion)), motion);
}

double RigidBody::rub(std::vector<Touch>& touches, ContactColumns among, double coefficient, BodyMotion& motion) const {
  return take(rub_touches(PlaneBody{*this}, touches, among, coefficient, PlaneBody::of(motion)), motion);
}

}  // namespace percal
