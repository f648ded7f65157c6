// A deformable body of one-point quads on an unstructured mesh, in double precision: an elastic particle, and what
// closed forms are held against. Total Lagrangian, explicit; the solid and the viscosity are the block's
// (docs/theory/impact.md (2) to (9)), the element is QuadForm. Any consistent units. docs/verification/closed_forms.md
// describes element and tests.
#pragma once
#include <array>
#include <vector>

#include "percal/impact/kernel/element.hpp"
#include "percal/mesh/quads.hpp"
#include "percal/problem/choices.hpp"

namespace percal {

struct BodySolid {
  double mu = 1, bulk = 50, alpha = 2;  // small-strain shear and bulk modulus, Ogden's exponent (not 0)
  double density = 1;
  double hourglass = 0.5;          // stiffness of the hourglass mode over mu
  double linear_viscosity = 0;     // times wave speed; the block has 0.06
  double quadratic_viscosity = 0;  // not squared; the block has 1.2

  scalar::ElasticConstants elastic() const { return {mu, bulk, alpha}; }
  double lame_modulus() const { return bulk + mu * 4 / 3; }  // of a plane wave
  double wave_speed() const;
};
// From Young's modulus and Poisson's ratio (between -1 and 1/2), alpha 2.
BodySolid elastic_solid(double young, double poisson, double density);

struct BodyEnergy {
  double kinetic = 0, elastic = 0, hourglass = 0;
  double viscous = 0;  // lost to viscosity up to now
};

// What a one-point quad needs to know of its undeformed shape.
// In an axisymmetric Geometry x = r, y = z, and volumes, masses and forces are those of one radian; in plane strain those of a unit
// thickness. The displacement gradient of an element is its mean over the element's volume V = int w dA, with w = r or 1:
//   F = 1 + sum_a u_a (dx_a, dy_a),   dx_a = (1/V) int dN_a/dx w dA,   hoop stretch = 1 + sum_a hoop_a u_r,a,
//   hoop_a = (1/V) int N_a dA  (0 in plane strain).
// The mean of what is constant is exact: rigid motions and linear fields make the F that they have, on any quad, and forces
// V P grad balance at every inner node of a homogeneous state (Flanagan and Belytschko, Int. J. Numer. Methods Eng. 17, 1981).
struct QuadForm {
  std::array<double, 4> dx, dy, hoop;
  std::array<double, 4> mode;  // the hourglass pattern: 0 against every linear field; +1 -1 +1 -1 on a parallelogram
  std::array<double, 4> mass_share;  // int N_a w dA: lumped mass at density 1
  double volume;                     // V
  double area;                       // int dA
};

// The march of its owner, each step:  forces(); [add_force(...);]  step(kick, drift).
// With kick = half the last step plus half the next, drift = the next, velocities live between the displacements; two steps
// (kick/2, 0) and (kick/2, drift) have them at the same time in between, where energy() belongs.
class Body {
 public:
  // In axisymmetry nodes on the axis are held in r. Throws BadInput for an element that is not convex.
  Body(const QuadMesh& mesh, Geometry geometry, const BodySolid& solid);

  int nodes() const { return static_cast<int>(mesh_.nodes.size()); }
  int elements() const { return static_cast<int>(mesh_.elements.size()); }
  const QuadMesh& mesh() const { return mesh_; }
  const BodySolid& solid() const { return solid_; }
  Point position(int node) const;
  const Point& displacement(int node) const { return displacement_[node]; }
  const Point& velocity(int node) const { return velocity_[node]; }
  const Point& force(int node) const { return force_[node]; }  // also where held: minus the reaction
  double mass(int node) const { return mass_[node]; }
  Point momentum() const;

  void set_displacement(int node, const Point& u) { displacement_[node] = u; }
  void set_velocity(int node, const Point& v) { velocity_[node] = v; }
  // From now on the velocity in this direction (0 or 1) stays what it is, and is set to zero here.
  void hold(int node, int direction);
  bool held(int node, int direction) const { return inverse_mass_[node][direction] == 0; }

  // Internal and viscous forces where the nodes stand now.
  void forces();
  void add_force(int node, const Point& force);
  // v += kick f/m, then u += drift v.
  void step(double kick, double drift);

  BodyEnergy energy() const;
  double kinetic_energy() const;
  // A step for which central differences are stable at this state, never longer than 2/omega of the mesh; without a
  // safety factor. Springs that others add are not in it.
  double stable_step() const;

  // The state of one element's point.
  scalar::Gradient<double> gradient(int element) const;
  scalar::Piola<double> first_piola(int element) const;  // without viscosity
  double energy_density(int element) const;              // elastic, per undeformed volume
  double smallest_jacobian() const;  // not positive: the body is inverted, and its results mean nothing

 private:
  struct Viscosity {
    double jacobian = 1;  // at the last forces()
    double closing = 0;   // rate -J'/J where it closes, else 0
    double pressure = 0;
  };

  double viscous_pressure(int element, const scalar::Stretches<double>& s);
  double hourglass_stiffness(int element) const;
  void share_masses_for_step();
  double inverse_square_step(int element, const scalar::Gradient<double>& F, const scalar::Stretches<double>& s) const;
  double viscous_inverse_step(int element, const scalar::Gradient<double>& F, const scalar::Stretches<double>& s) const;

  QuadMesh mesh_;
  Geometry geometry_;
  BodySolid solid_;
  std::vector<QuadForm> forms_;
  std::vector<Viscosity> viscosity_;
  std::vector<Point> displacement_, velocity_, force_;
  std::vector<Point> inverse_mass_;  // 0 where held
  std::vector<double> mass_;
  std::vector<std::array<double, 4>>
      mass_in_step_;  // what each corner of an element has of its node's mass in stable_step()
  double last_drift_ = 0, viscous_work_ = 0;
};

}  // namespace percal
