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

SphereRun::SphereRun(const Problem& problem)
    : mass_(round_mass(problem)), speed_(problem.speed_factor), whole_(problem.whole) {}

PolygonRun::PolygonRun(const Problem& problem)
    : profile_(std::get<RigidPolygon>(problem.particle)),
      whole_(problem.whole),
      mass_(share_of(problem) * profile_.mass),
      inertia_(share_of(problem) * profile_.inertia),
      motion_{.down = problem.speed_factor} {
  turn_sides(here_);
  here_.z = -here_.lowest;
}

// Sides of the polygon as it stands now. y is upwards in the profile, z downwards in the target.
void PolygonRun::turn_sides(Place& place) const {
  const double cosine = std::cos(place.angle), sine = std::sin(place.angle);
  std::vector<std::array<double, 2>> turned;  // x, z from the centre of mass
  for (const auto& [x, y] : profile_.vertices) turned.push_back({cosine * x - sine * y, -(sine * x + cosine * y)});
  place.lowest = -std::numeric_limits<double>::infinity();
  place.highest = -place.lowest;
  place.sides.clear();
  for (std::size_t k = 0; k < turned.size(); ++k) {
    const auto& [x0, z0] = turned[k];
    const auto& [x1, z1] = turned[(k + 1) % turned.size()];
    const double length = std::hypot(x1 - x0, z1 - z0);
    // Anticlockwise with z downwards: outward is to the side of (dz, dx) turned so that x cross z closes.
    const double normal_x = -(z1 - z0) / length, normal_z = (x1 - x0) / length;
    place.sides.push_back({normal_x, normal_z, 0.5 * (normal_x * (x0 + x1) + normal_z * (z0 + z1))});
    place.lowest = std::max(place.lowest, z0);
    place.highest = std::min(place.highest, z0);
  }
}

void PolygonRun::move(Place& place, double time) const {
  place.z += motion_.down * time;
  if (!profile_.free_rotation) return;
  place.x += motion_.right * time;
  place.angle += motion_.spin * time;
  turn_sides(place);
}

void PolygonRun::foresee(double time) {
  ahead_ = here_;
  move(ahead_, time);
}

void PolygonRun::drift(double time) { move(here_, time); }

RigidBody PolygonRun::body() const {
  BodyMotion free{.down = 1 / mass_};
  if (profile_.free_rotation) free = {1 / mass_, 1 / mass_, 1 / inertia_};
  return {free, ahead_.x, ahead_.z, whole_};
}

// Across the nearest side; where two are as near, along the mean of their normals, so that a tip pushes straight ahead.
Overlap PolygonRun::overlap(double x, double z) const {
  Overlap nearest{std::numeric_limits<double>::infinity(), 0, 0};
  int as_near = 1;
  for (const PolygonSide& side : ahead_.sides) {
    const double gap = side.offset - (side.normal_x * (x - ahead_.x) + side.normal_z * (z - ahead_.z));
    if (gap < nearest.gap) {
      nearest = {gap, side.normal_x, side.normal_z};
      as_near = 1;
    } else if (gap == nearest.gap) {
      nearest = {gap, nearest.normal_x + side.normal_x, nearest.normal_z + side.normal_z};
      ++as_near;
    }
  }
  if (!(nearest.gap > 0)) return {};
  return {nearest.gap, nearest.normal_x / as_near, nearest.normal_z / as_near};
}

}  // namespace percal
