// Depth against the impact parameter rho v a: the shots, their straight line, and depths that follow from it in a
// similar system (Guha 2009, Figure 4-2 and Table 4-4).
#pragma once
#include <span>
#include <string>
#include <vector>

#include "percal/math/statistics.hpp"
#include "percal/scaling/system.hpp"
#include "percal/text/csv.hpp"

namespace percal {

// One ball into the target, SI.
struct Shot {
  double density = 0;
  double radius = 0;
  double speed = 0;
  double depth = 0;  // measured
};

double impact_parameter(double density, double speed, double radius);  // rho v a, kg/(m s)
double impact_parameter(const Shot& shot);

// Columns of a table of shots; exactly one of radius and diameter is named.
struct ShotColumns {
  std::string density = "density";
  std::string radius = "";
  std::string diameter = "diameter";
  std::string speed = "velocity";
  std::string depth = "penetration";
};

// Throws BadInput for missing columns, bad cells and numbers that are not positive.
std::vector<Shot> read_shots(const CsvTable& table, const ShotColumns& columns);

// Depth [m] against impact parameter [kg/(m s)]. Throws BadInput as linear_trend does.
Line depth_trend(std::span<const Shot> shots);

// The depth in `prototype` (its speed and radius) that a line of depths measured in `model` gives: the line at
// rho_p,m (v times speed_ratio) a_m, taken back with the ratio of radii (pi8). speed_ratio is the similar systems'
// v_m / v (pi4). `model` needs radius and particle density; BadInput says which one is missing.
double depth_from_model(const Line& line, const System& model, double speed_ratio, const System& prototype);

// The radius of a sphere of this mass, and the scale of an equally thick prism that brings its mass from one to
// another.
double equal_mass_radius(double mass, double density);
double equal_mass_prism_scale(double mass_from, double mass_to);

}  // namespace percal
