#include "percal/solid/particle/body.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>

namespace percal {

SpacePiece lofted(const std::vector<Section>& sections, const std::function<ParticlePiece(double scale)>& outline_at) {
  SpacePiece piece;
  int around = 0;
  const auto in_space = [](const Point& point, double y) { return SpacePoint{point[0], y, point[1]}; };
  for (const auto& [y, scale] : sections) {
    const ParticlePiece outline = outline_at(scale);
    around = static_cast<int>(outline.position.size());
    for (int k = 0; k < around; ++k) {
      piece.position.push_back(in_space(outline.position[k], y));
      piece.displacement.push_back(in_space(outline.displacement[k], 0));
      piece.velocity.push_back(in_space(outline.velocity[k], 0));
    }
  }
  const auto add_cell = [&piece](const std::vector<int>& corners) {
    piece.corners.insert(piece.corners.end(), corners.begin(), corners.end());
    piece.ends.push_back(static_cast<int>(piece.corners.size()));
  };
  const int last = (static_cast<int>(sections.size()) - 1) * around;
  std::vector<int> end(around);
  std::iota(end.begin(), end.end(), 0);
  add_cell(end);
  for (int first = 0; first < last; first += around)
    for (int k = 0; k < around; ++k) {
      const int next = (k + 1) % around;
      add_cell({first + k, first + next, first + around + next, first + around + k});
    }
  std::iota(end.begin(), end.end(), last);
  add_cell(end);
  return piece;
}

std::vector<Section> SphereShape::sections() const {
  constexpr int sections = 24;
  std::vector<Section> all;
  for (int k = 0; k <= sections; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / sections;
    all.push_back({std::sin(angle), std::cos(angle)});
  }
  return all;
}

SpaceOverlap SphereShape::overlap(const std::array<double, 3>& from) const {
  const double distance = std::hypot(from[0], from[1], from[2]);
  if (distance >= 1 || distance == 0) return {};
  return {1 - distance, {from[0] / distance, from[1] / distance, from[2] / distance}};
}

double SphereShape::mass(const Problem& problem) const { return 4.0 / 3 * std::numbers::pi * problem.density_ratio; }

std::vector<Point> SphereShape::outline() const {
  constexpr int corners = 96;
  std::vector<Point> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    points.push_back({std::sin(angle), -std::cos(angle)});
  }
  return points;
}

PrismShape::PrismShape(const Problem& problem)
    : vertices_(std::get<RigidPolygon>(problem.particle).vertices),
      half_thickness_(std::get<RigidPolygon>(problem.particle).half_thickness) {
  for (const auto& [x, y] : vertices_) reach_ = std::max(reach_, std::hypot(x, y));
  turn(0);
}

// y is upwards in the profile, z downwards in the target.
void PrismShape::turn(double angle) {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  std::vector<std::array<double, 2>> turned;  // x, z
  for (const auto& [x, y] : vertices_) turned.push_back({cosine * x - sine * y, -(sine * x + cosine * y)});
  lowest_ = -std::numeric_limits<double>::infinity();
  highest_ = -lowest_;
  faces_.clear();
  for (std::size_t k = 0; k < turned.size(); ++k) {
    const auto& [x0, z0] = turned[k];
    const auto& [x1, z1] = turned[(k + 1) % turned.size()];
    const double length = std::hypot(x1 - x0, z1 - z0);
    const double normal_x = -(z1 - z0) / length, normal_z = (x1 - x0) / length;
    faces_.push_back({{normal_x, 0, normal_z}, 0.5 * (normal_x * (x0 + x1) + normal_z * (z0 + z1))});
    lowest_ = std::max(lowest_, z0);
    highest_ = std::min(highest_, z0);
  }
  faces_.push_back({{0, 1, 0}, half_thickness_});  // the other end is mirrored
}

SpaceOverlap overlap_with(const std::vector<PolyhedronFace>& faces, const std::array<double, 3>& from) {
  SpaceOverlap nearest{.gap = std::numeric_limits<double>::infinity()};
  int as_near = 1;
  for (const PolyhedronFace& face : faces) {
    const auto& n = face.normal;
    const double gap = face.offset - (n[0] * from[0] + n[1] * from[1] + n[2] * from[2]);
    if (gap > nearest.gap) continue;
    if (gap < nearest.gap) {
      nearest = {gap, n};
      as_near = 1;
      continue;
    }
    for (int d = 0; d < 3; ++d) nearest.normal[d] += n[d];
    ++as_near;
  }
  if (!(nearest.gap > 0)) return {};
  for (double& component : nearest.normal) component /= as_near;
  return nearest;
}

double PrismShape::mass(const Problem& problem) const { return std::get<RigidPolygon>(problem.particle).mass; }
double PrismShape::inertia(const Problem& problem) const { return std::get<RigidPolygon>(problem.particle).inertia; }
bool PrismShape::may_turn(const Problem& problem) {
  return problem.whole && std::get<RigidPolygon>(problem.particle).free_rotation;
}

}  // namespace percal
