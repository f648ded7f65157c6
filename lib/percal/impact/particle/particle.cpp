#include "percal/impact/particle/particle.hpp"

#include <limits>
#include <numbers>

namespace percal {
namespace {

// The model holds one side of a plane-strain scene that is mirrored: half the particle falls to it.
double share_of(const Problem& problem) {
  return problem.geometry == Geometry::plane_strain && !problem.whole ? 0.5 : 1;
}

double round_mass(const Problem& problem) {
  const double volume =
      problem.geometry == Geometry::plane_strain ? std::numbers::pi : 2.0 / 3;  // per thickness, per radian
  return share_of(problem) * volume * problem.density_ratio;
}

}  // namespace

ContactReport sum_of_columns(std::span<const ContactReport> columns, bool whole) {
  ContactReport sum;
  if (!whole) {
    for (auto column = columns.rbegin(); column != columns.rend(); ++column) sum += *column;
    return sum;
  }
  for (std::size_t left = 0, right = columns.size(); left < right--; ++left) {
    ContactReport pair = columns[left];
    if (left < right) pair += columns[right];
    sum += pair;
  }
  return sum;
}

SphereRun::SphereRun(const Problem& problem)
    : mass_(round_mass(problem)), speed_(problem.speed_factor), whole_(problem.whole) {}

PolygonRun::PolygonRun(const Problem& problem)
    : profile_(std::get<RigidPolygon>(problem.particle)),
      whole_(problem.whole),
      mass_(share_of(problem) * profile_.mass),
      inertia_(share_of(problem) * profile_.inertia),
      speed_(problem.speed_factor) {
  turn_sides();
  z_ = -lowest_;
}

// Sides of the polygon as it stands now. y is upwards in the profile, z downwards in the target.
void PolygonRun::turn_sides() {
  const double cosine = std::cos(angle_), sine = std::sin(angle_);
  std::vector<std::array<double, 2>> turned;  // x, z from the centre of mass
  for (const auto& [x, y] : profile_.vertices) turned.push_back({cosine * x - sine * y, -(sine * x + cosine * y)});
  lowest_ = -std::numeric_limits<double>::infinity();
  highest_ = -lowest_;
  sides_.clear();
  for (std::size_t k = 0; k < turned.size(); ++k) {
    const auto& [x0, z0] = turned[k];
    const auto& [x1, z1] = turned[(k + 1) % turned.size()];
    const double length = std::hypot(x1 - x0, z1 - z0);
    // Anticlockwise with z downwards: outward is to the side of (dz, dx) turned so that x cross z closes.
    const double normal_x = -(z1 - z0) / length, normal_z = (x1 - x0) / length;
    sides_.push_back({normal_x, normal_z, 0.5 * (normal_x * (x0 + x1) + normal_z * (z0 + z1))});
    lowest_ = std::max(lowest_, z0);
    highest_ = std::min(highest_, z0);
  }
}

void PolygonRun::kick(const ContactReport& report, double time) {
  speed_ -= report.force / mass_ * time;
  if (!profile_.free_rotation) return;
  sideways_speed_ += report.sideways / mass_ * time;
  spin_ += report.torque / inertia_ * time;
}

void PolygonRun::drift(double time) {
  z_ += speed_ * time;
  if (!profile_.free_rotation) return;
  x_ += sideways_speed_ * time;
  angle_ += spin_ * time;
  turn_sides();
}

Overlap PolygonRun::overlap(double x, double z) const {
  Overlap nearest{std::numeric_limits<double>::infinity(), 0, 0};
  for (const PolygonSide& side : sides_) {
    const double gap = side.offset - (side.normal_x * (x - x_) + side.normal_z * (z - z_));
    if (gap < nearest.gap) nearest = {gap, side.normal_x, side.normal_z};
  }
  return nearest.gap > 0 ? nearest : Overlap{};
}

}  // namespace percal
