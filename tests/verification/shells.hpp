// Thick spheres and tubes under pressure, inner radius 1: the bodies of the inflation and oscillation tests.
#pragma once
#include "verification/verification.hpp"

namespace percal {

enum class Shell { sphere, tube_in_the_plane, tube_in_the_half_plane };

inline std::string name_of(Shell shell) {
  return shell == Shell::sphere              ? "sphere"
         : shell == Shell::tube_in_the_plane ? "tube, plane strain"
                                             : "tube, axisymmetric, held in z";
}
inline bool is_sphere(Shell shell) { return shell == Shell::sphere; }

struct ShellMesh {
  double outer = 2;
  int across = 16, along = 12;  // elements through the wall, and over a quarter of the circle
  double growth = 1.05;
  std::string text() const { return fmt::format("{} x {}, growth {}", across, along, growth); }
};

// A shell with pressures inside and outside, held where it is cut.
class ShellBody {
 public:
  ShellBody(Shell shell, const ShellMesh& mesh, const BodySolid& solid)
      : block_(shell == Shell::tube_in_the_half_plane ? rectangle({.left = 1,
                                                                   .right = mesh.outer,
                                                                   .bottom = 0,
                                                                   .top = 0.2,
                                                                   .across = mesh.across,
                                                                   .along = 2,
                                                                   .growth_x = mesh.growth})
                                                      : sector({.inner = 1,
                                                                .outer = mesh.outer,
                                                                .across = mesh.across,
                                                                .along = mesh.along,
                                                                .growth = mesh.growth})),
        body(block_.mesh, shell == Shell::tube_in_the_plane ? Geometry::plane_strain : Geometry::axisymmetric, solid),
        inside_(body.press(block_.inner, 0)),
        outside_(body.press(block_.outer, 0)) {
    for (const int n : block_.first) body.hold(n, 1);
    if (shell == Shell::tube_in_the_plane)
      for (const int n : block_.last) body.hold(n, 0);
    if (shell == Shell::tube_in_the_half_plane)
      for (int n = 0; n < body.nodes(); ++n) body.hold(n, 1);
    axial_ = shell == Shell::tube_in_the_half_plane;
    dimensions_ = is_sphere(shell) ? 3 : 2;
    press(1, 0);
    body.forces();
    for (const int n : block_.inner)
      work_of_unit_pressure_ +=
          body.force(n)[0] * block_.mesh.nodes[n][0] + (axial_ ? 0 : body.force(n)[1] * block_.mesh.nodes[n][1]);
    press(0, 0);
    body.forces();
  }

  void press(double inside, double outside) {
    body.set_pressure(inside_, inside);
    body.set_pressure(outside_, outside);
  }

  // Puts every node where it is in an incompressible solid whose inner radius is `stretch`, and keeps the inner ones there.
  void expand(double stretch) {
    for (int n = 0; n < body.nodes(); ++n) {
      const Point& at = block_.mesh.nodes[n];
      const double R = axial_ ? at[0] : std::hypot(at[0], at[1]);
      const double volume = std::pow(R, dimensions_) + std::pow(stretch, dimensions_) - 1;
      const double share = std::pow(volume, 1.0 / dimensions_) / R - 1;
      body.set_displacement(n, {share * at[0], axial_ ? 0 : share * at[1]});
    }
    for (const int n : block_.inner)
      for (int d = 0; d < 2; ++d) body.hold(n, d);
    expanded_to_ = stretch;
  }

  // The pressure that holds the inner nodes where expand() put them: their forces and a pressure do the same work when the inner
  // radius grows. Needs forces().
  double inner_pressure() const {
    double work = 0;
    for (const int n : block_.inner)
      work -= body.force(n)[0] * block_.mesh.nodes[n][0] + (axial_ ? 0 : body.force(n)[1] * block_.mesh.nodes[n][1]);
    return work / (work_of_unit_pressure_ * std::pow(expanded_to_, dimensions_ - 1));
  }
  double inner_stretch() const { return mean_radius(block_.inner, true) / mean_radius(block_.inner, false); }

 private:
  QuadBlock block_;
  bool axial_ = false;
  int dimensions_ = 3;  // of the space in which the cavity grows
  double expanded_to_ = 1, work_of_unit_pressure_ = 0;

  double mean_radius(const std::vector<int>& nodes, bool now) const {
    double sum = 0;
    for (const int n : nodes) {
      const Point at = now ? body.position(n) : block_.mesh.nodes[n];
      sum += axial_ ? at[0] : std::hypot(at[0], at[1]);
    }
    return sum / static_cast<double>(nodes.size());
  }

 public:
  PressedBody body;

 private:
  int inside_, outside_;
};

}  // namespace percal
