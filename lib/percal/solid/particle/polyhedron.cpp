#include "percal/solid/particle/polyhedron.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "percal/impact/particle/impulses.hpp"

namespace percal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const RigidPolyhedron& polyhedron_of(const Problem& problem) { return std::get<RigidPolyhedron>(problem.particle); }

Vector3d downwards(const std::array<double, 3>& point) { return {point[0], point[1], -point[2]}; }
SpacePoint upwards(const Vector3d& vector) { return {vector[0], vector[1], -vector[2]}; }

// Of the computed part of a body that stands as it is given, over its mass; z downwards.
Matrix3d inertia_over_mass(const Polyhedron& body) {
  const MassProperties found = mass_properties(body);
  Matrix3d inertia;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) inertia(i, j) = ((i == 2) == (j == 2) ? 1 : -1) * found.inertia[i][j] / found.volume;
  return inertia;
}

// Planes of symmetry keep a body from leaving them, and from turning but about an axis across one.
Vector3d free_moves(const Problem& problem) {
  const bool free = polyhedron_of(problem).free_rotation;
  return {free && problem.whole ? 1.0 : 0.0, free && problem.block.whole_across ? 1.0 : 0.0, 1.0};
}
Vector3d free_turns(const Problem& problem) {
  const bool x = polyhedron_of(problem).free_rotation && problem.block.whole_across,
             y = polyhedron_of(problem).free_rotation && problem.whole;
  return {x ? 1.0 : 0.0, y ? 1.0 : 0.0, x && y ? 1.0 : 0.0};
}

Vector3d first_velocity(const Problem& problem) {
  return {problem.speed_factor * std::sin(problem.block.angle), 0,
          problem.speed_factor * std::cos(problem.block.angle)};
}

// Along and about all axes.
struct SpaceBody {
  using Velocities = Eigen::Matrix<double, 6, 1>;
  const Vector3d centre;
  const Vector3d inverse_masses;  // 0 along axes that are held
  const Matrix3d inverse_inertia;

  Eigen::Matrix<double, 6, 6> inverse_mass() const {
    Eigen::Matrix<double, 6, 6> W = Eigen::Matrix<double, 6, 6>::Zero();
    W.topLeftCorner<3, 3>() = inverse_masses.asDiagonal();
    W.bottomRightCorner<3, 3>() = inverse_inertia;
    return W;
  }
  Velocities lever(const Touch& touch) const { return lever(touch, {touch.away_x, touch.away_y, touch.away_z}); }
  Velocities sliding_lever(const Touch& touch) const {
    return lever(touch, {touch.along_x, touch.along_y, touch.along_z});
  }
  static bool may_slide(const Touch& touch) { return touch.along_x != 0 || touch.along_y != 0 || touch.along_z != 0; }
  static bool whole() { return false; }

 private:
  Velocities lever(const Touch& touch, const Vector3d& along) const {
    Velocities gains;
    gains << along, (Vector3d(touch.x, touch.y, touch.z) - centre).cross(along);
    return gains;
  }
};

}  // namespace

Top::Top(const Matrix3d& inertia, const Vector3d& free) : inverse_inertia_(inertia.inverse()), free_(free) {}

// Of a body that turns about one axis alone, its moment about that.
Matrix3d Top::inverse_inertia_at(const Matrix3d& attitude) const {
  return free_.asDiagonal() * (attitude * inverse_inertia_ * attitude.transpose()) * free_.asDiagonal();
}

void Top::turn(double time) {
  if (momentum_.isZero(0) || time == 0) return;
  constexpr int most_turn_rounds = 20;  // each takes the error down by the angle of half a step
  constexpr double rounding = 1e-15;
  Vector3d mean_spin = spin();
  const auto turned_by = [&](double share) -> Matrix3d {
    const double angle = mean_spin.norm() * share * time;
    return angle == 0 ? attitude_ : Eigen::AngleAxisd(angle, mean_spin.normalized()) * attitude_;
  };
  for (int round = 0; round < most_turn_rounds; ++round) {
    const Vector3d before = mean_spin;
    mean_spin = inverse_inertia_at(turned_by(0.5)) * momentum_;
    if ((mean_spin - before).norm() <= rounding * mean_spin.norm()) break;
  }
  attitude_ = turned_by(1);
}

PolyhedronRun::PolyhedronRun(const Problem& problem)
    : body_(convex_polyhedron(polyhedron_of(problem).vertices)),
      mass_(computed_share(problem) * polyhedron_of(problem).mass),
      reach_(greatest_distance(body_.vertices)),
      moves_(free_moves(problem)),
      all_axes_(free_turns(problem).minCoeff() > 0),
      here_{.centre = Vector3d::Zero(), .top = Top(mass_ * inertia_over_mass(body_), free_turns(problem)), .faces = {}},
      ahead_(here_),
      velocity_(first_velocity(problem)) {
  for (const auto& vertex : body_.vertices) corners_.push_back(downwards(vertex));
  for (const auto& [normal, offset] : face_planes(body_))
    first_faces_.push_back({{normal[0], normal[1], -normal[2]}, offset});
  here_.faces = first_faces_;
  turn_faces(here_);
  first_lowest_ = here_.lowest;
  here_.centre = first_centre();
  ahead_ = here_;
}

void PolyhedronRun::turn_faces(Place& place) const {
  const Matrix3d& turn = place.top.attitude();
  for (std::size_t k = 0; k < first_faces_.size(); ++k) {
    const auto& n = first_faces_[k].normal;
    const Vector3d normal = turn * Vector3d(n[0], n[1], n[2]);
    place.faces[k].normal = {normal[0], normal[1], normal[2]};
  }
  place.lowest = -std::numeric_limits<double>::infinity();
  place.highest = -place.lowest;
  for (const Vector3d& corner : corners_) {
    const double z = turn.row(2).dot(corner);
    place.lowest = std::max(place.lowest, z);
    place.highest = std::min(place.highest, z);
  }
}

void PolyhedronRun::move(Place& place, double time) const {
  place.centre += time * velocity_;
  if (place.top.momentum().isZero(0)) return;
  place.top.turn(time);
  turn_faces(place);
}

void PolyhedronRun::drift(double time) {
  angle_ += here_.top.spin()[1] * time;
  move(here_, time);
}

template <class Impulses>
double PolyhedronRun::exchange(const Impulses& impulses) {
  const SpaceBody body{ahead_.centre, moves_ / mass_, ahead_.top.inverse_inertia()};
  SpaceBody::Velocities before;
  before << velocity_, ahead_.top.spin();
  const ImpulseChange<SpaceBody> change = impulses(body, before);
  velocity_ += change.velocity.head<3>();
  for (Place* place : {&here_, &ahead_}) place->top.push(change.impulse.tail<3>());
  return change.lost;
}

double PolyhedronRun::meet(std::vector<Touch>& touches, ContactColumns columns) {
  return exchange([&](const auto& body, const auto& before) { return part_touches(body, touches, columns, before); });
}

double PolyhedronRun::rub(std::vector<Touch>& touches, ContactColumns columns, double coefficient) {
  return exchange(
      [&](const auto& body, const auto& before) { return rub_touches(body, touches, columns, coefficient, before); });
}

double PolyhedronRun::turn() const { return all_axes_ ? Eigen::AngleAxisd(here_.top.attitude()).angle() : angle_; }

// A vector about which it turns, z downwards, is mirrored where z is upwards: its part along z stays.
std::optional<SpacePath> PolyhedronRun::in_space() const {
  if (!all_axes_) return std::nullopt;
  const Vector3d axis = Eigen::AngleAxisd(here_.top.attitude()).axis();
  return SpacePath{.across = here_.centre[1], .axis = {-axis[0], -axis[1], axis[2]}};
}

std::array<double, 2> PolyhedronRun::along_y(double margin) const {
  if (all_axes_) return {here_.centre[1] - reach_ - margin, here_.centre[1] + reach_ + margin};
  return extent(body_.vertices, 1);
}

std::array<double, 3> PolyhedronRun::velocity_at(const std::array<double, 3>& point) const {
  const Vector3d from = Vector3d(point[0], point[1], point[2]) - here_.centre;
  const Vector3d velocity = velocity_ + here_.top.spin().cross(from);
  return {velocity[0], velocity[1], velocity[2]};
}

// `corner` from the centre of mass as the body stood at first, z downwards.
void PolyhedronRun::add_point(SpacePiece& piece, const Vector3d& corner) const {
  const Vector3d now = here_.centre + here_.top.attitude() * corner;
  const auto velocity = velocity_at({now[0], now[1], now[2]});
  piece.position.push_back(upwards(now));
  piece.displacement.push_back(upwards(now - first_centre() - corner));
  piece.velocity.push_back({velocity[0], velocity[1], -velocity[2]});
}

ParticlePiece PolyhedronRun::piece(const Problem& problem) const {
  Polyhedron now = body_;
  for (std::size_t k = 0; k < corners_.size(); ++k)
    now.vertices[k] = upwards(here_.centre + here_.top.attitude() * corners_[k]);
  if (!problem.whole) now = upper_part(now, 0);
  Vertices corners = middle_section(now);
  const auto lowest_on_axis = [](const auto& point) { return std::pair(point[0], point[2]); };
  if (!problem.whole) std::ranges::rotate(corners, std::ranges::min_element(corners, {}, lowest_on_axis));
  SpacePiece section;
  for (const auto& point : corners)
    add_point(section, here_.top.attitude().transpose() * (downwards(point) - here_.centre));
  ParticlePiece piece;
  const auto in_plane = [](const std::vector<SpacePoint>& from, std::vector<Point>& to) {
    for (const auto& [x, y, z] : from) to.push_back({x, z});
  };
  in_plane(section.position, piece.position);
  in_plane(section.displacement, piece.displacement);
  in_plane(section.velocity, piece.velocity);
  piece.outline.resize(piece.position.size());
  std::iota(piece.outline.begin(), piece.outline.end(), 0);
  piece.corners = piece.outline;
  if (!piece.corners.empty()) piece.ends = {static_cast<int>(piece.corners.size())};
  return piece;
}

SpacePiece PolyhedronRun::space_piece(const Problem& problem) const {
  Polyhedron part = body_;
  if (!problem.whole) part = upper_part(part, 0);
  if (!problem.block.whole_across) part = upper_part(part, 1);
  SpacePiece piece;
  for (const auto& vertex : part.vertices) add_point(piece, downwards(vertex));
  for (const auto& face : part.faces) {
    piece.corners.insert(piece.corners.end(), face.begin(), face.end());
    piece.ends.push_back(static_cast<int>(piece.corners.size()));
  }
  return piece;
}

}  // namespace percal
