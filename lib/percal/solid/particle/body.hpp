// Spheres and prisms in three dimensions, which move in the plane y = 0 and turn about y (polyhedra: polyhedron.hpp). They answer to what particles answer to in
// impact/particle/particle.hpp; a body is a shape with a motion. Of the modelled part: a quarter or a half of the whole.
#pragma once
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "percal/impact/particle/particle.hpp"
#include "percal/impact/result.hpp"
#include "percal/solid/target/block.hpp"

namespace percal {

// How deep a point lies inside a body (0: outside) and the outward direction there; z downwards.
struct SpaceOverlap {
  double gap = 0;
  std::array<double, 3> normal{};
};

// Of a point as it lies from the centre of a convex polyhedron: across its nearest face; where several are as near, along the mean of
// their normals, so that an edge pushes straight ahead.
SpaceOverlap overlap_with(const std::vector<PolyhedronFace>& faces, const std::array<double, 3>& from);

// The outline of a body, times `scale`, at this y.
struct Section {
  double y, scale;
};
// The surface between the sections of a body from y = 0 outwards, each with the same number of points, and the first and last of them.
SpacePiece lofted(const std::vector<Section>& sections, const std::function<ParticlePiece(double scale)>& outline_at);

class SphereShape {
 public:
  explicit SphereShape(const Problem&) {}
  void turn(double) {}
  template <class Real>
  int find(const SolidKernel<Real>& kernel, const SolidBlock<Real>& block, const ColumnNodes& nodes,
           const std::array<double, 3>& centre, int* found) const {
    return kernel.nodes_in_sphere(block.fields(), nodes, centre, found);
  }
  // Of a point as it lies from the centre.
  SpaceOverlap overlap(const std::array<double, 3>& from) const;
  double lowest() const { return 1; }  // from the centre, downwards
  double highest() const { return -1; }
  double reach() const { return 1; }  // in the plane y = 0, whichever way it is turned
  double half_thickness() const { return 1; }
  double mass(const Problem& problem) const;
  double inertia(const Problem&) const { return 1; }  // nothing turns it
  std::vector<Point> outline()
      const;  // in the plane y = 0 before it is turned, y upwards, from the centre, counter-clockwise
  std::vector<Section> sections() const;
  static bool may_turn(const Problem&) { return false; }
  static bool may_go_sideways(const Problem& problem) { return problem.whole; }
};

// A prism: its convex profile in the plane y = 0.
class PrismShape {
 public:
  explicit PrismShape(const Problem& problem);
  void turn(double angle);  // anticlockwise from where it stood at first, seen with y away from the viewer
  template <class Real>
  int find(const SolidKernel<Real>& kernel, const SolidBlock<Real>& block, const ColumnNodes& nodes,
           const std::array<double, 3>& centre, int* found) const {
    return kernel.nodes_in_polyhedron(block.fields(), nodes, faces_.data(), static_cast<int>(faces_.size()),
                                      std::hypot(reach_, half_thickness_), centre, found);
  }
  SpaceOverlap overlap(const std::array<double, 3>& from) const { return overlap_with(faces_, from); }
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }
  double reach() const { return reach_; }
  double half_thickness() const { return half_thickness_; }
  double mass(const Problem& problem) const;
  double inertia(const Problem& problem) const;
  std::vector<Point> outline() const { return vertices_; }
  std::vector<Section> sections() const { return {{0, 1}, {half_thickness_, 1}}; }
  static bool may_turn(const Problem& problem);
  static bool may_go_sideways(const Problem& problem) { return may_turn(problem); }

 private:
  std::vector<std::array<double, 2>> vertices_;  // RigidPolygon::vertices
  double half_thickness_, reach_ = 0, lowest_ = 0, highest_ = 0;
  std::vector<PolyhedronFace> faces_;
};

template <class Shape>
class BodyRun : public NeverDeforms {
 public:
  explicit BodyRun(const Problem& problem)
      : here_{.shape = Shape(problem)},
        mass_(computed_share(problem) * here_.shape.mass(problem)),
        inertia_(computed_share(problem) * here_.shape.inertia(problem)),
        free_{.down = 1 / mass_,
              .right = Shape::may_go_sideways(problem) ? 1 / mass_ : 0,
              .spin = Shape::may_turn(problem) ? 1 / inertia_ : 0},
        motion_{.down = problem.speed_factor * std::cos(problem.block.angle),
                .right = problem.speed_factor * std::sin(problem.block.angle)} {
    here_.z = -here_.shape.lowest();
  }

  void foresee(double time) {
    ahead_ = here_;
    move(ahead_, time);
  }
  template <class Real>
  int find(const SolidKernel<Real>& kernel, const SolidBlock<Real>& block, const ColumnNodes& nodes, int* found) const {
    return ahead_.shape.find(kernel, block, nodes, {ahead_.x, 0, ahead_.z}, found);
  }
  SpaceOverlap overlap(const std::array<double, 3>& point) const {
    return ahead_.shape.overlap({point[0] - ahead_.x, point[1], point[2] - ahead_.z});
  }
  double meet(std::vector<Touch>& touches, ContactColumns columns) {
    return RigidBody{free_, ahead_.x, ahead_.z}.part(touches, columns, motion_);
  }
  double rub(std::vector<Touch>& touches, ContactColumns columns, double coefficient) {
    return RigidBody{free_, ahead_.x, ahead_.z}.rub(touches, columns, coefficient, motion_);
  }
  void drift(double time) { move(here_, time); }

  double tip() const { return here_.z + here_.shape.lowest(); }
  double top() const { return here_.z + here_.shape.highest(); }
  double speed() const { return motion_.down; }
  double sideways() const { return here_.x; }
  static double across() { return 0; }
  double turn() const { return here_.angle; }
  static std::optional<SpacePath> in_space() { return std::nullopt; }
  double reach() const { return here_.shape.reach(); }
  // From where to where it reaches along y. Nothing of it moves there, whatever the margin.
  std::array<double, 2> along_y(double) const { return {0, here_.shape.half_thickness()}; }
  std::array<double, 3> velocity_at(const std::array<double, 3>& point) const {
    const auto [x, z] = velocity_in_plane(point[0], point[2]);
    return {x, 0, z};
  }
  ParticleEnergy energy() const {
    const double moving = mass_ * (motion_.down * motion_.down + motion_.right * motion_.right);
    return {.kinetic = 0.5 * (moving + inertia_ * motion_.spin * motion_.spin)};
  }
  ParticlePiece piece(const Problem& problem) const { return outline(problem, 1); }
  SpacePiece space_piece(const Problem& problem) const {
    return lofted(Shape(problem).sections(), [&](double scale) { return outline(problem, scale); });
  }

 private:
  struct Place {
    double x = 0, z = 0, angle = 0;  // of the centre of mass
    Shape shape;
  };

  // As it is now.
  ParticlePiece outline(const Problem& problem, double scale) const {
    const Shape shape(problem);
    std::vector<Point> outline = problem.whole ? shape.outline() : right_half(shape.outline());
    for (auto& [x, y] : outline) {
      x *= scale;
      y *= scale;
    }
    return moved_piece(outline, -shape.lowest(), {here_.x, here_.z, here_.angle},
                       [&](double x, double z) { return velocity_in_plane(x, z); });
  }

  PointVelocity velocity_in_plane(double x, double z) const {
    return {motion_.right + motion_.spin * (z - here_.z), motion_.down - motion_.spin * (x - here_.x)};
  }

  void move(Place& place, double time) const {
    place.z += motion_.down * time;
    place.x += motion_.right * time;
    if (free_.spin == 0) return;
    place.angle += motion_.spin * time;
    place.shape.turn(place.angle);
  }

  Place here_, ahead_ = here_;
  double mass_, inertia_;
  BodyMotion free_;  // inverse masses
  BodyMotion motion_;
};

}  // namespace percal
