// The chain of Guha 2009's scaling, from the files of data/guha2009: what the tests and the verification page both
// read.
#pragma once
#include <string>
#include <vector>

#include "percal/material/gelatin.hpp"
#include "percal/scaling/similar.hpp"
#include "percal/scaling/trend.hpp"
#include "percal/text/csv.hpp"

namespace percal::guha2009 {

inline CsvTable table(const std::string& name) {
  return read_csv(std::string(PERCAL_DATA) + "/guha2009/" + name + ".csv");
}

// A constant of the text, in SI.
inline double constant(const std::string& name) {
  auto row = table("constants").where({"name=" + name});
  return row.numbers("value", dimension::none).at(0) * parse_unit(row.texts("unit").at(0)).value;
}

// Gold of the calibration impact in skin of unit density, as far as similarity needs it.
inline System gold() {
  System gold;
  gold.particle = "gold";
  gold.target = "skin";
  gold.radius = constant("calibration_radius");
  gold.particle_density = constant("gold_density");
  gold.speed = constant("calibration_velocity");
  gold.target_density = 1000;  // not stated; README, erratum 5
  gold.penetration = constant("calibration_penetration");
  gold.mu = 15e6;  // as given: ratios of moduli do not depend on the convention
  gold.depth = constant("skin_thickness");
  gold.width = constant("target_width_over_radius") * constant("calibration_radius");
  return gold;
}

inline System steel() {
  System steel;
  steel.particle = "steel";
  steel.target = "gelatin";
  steel.radius = constant("model_radius");
  steel.particle_density = constant("steel_density");
  steel.speed = constant("model_velocity");
  return complete(gold(), steel).model;
}

inline GelatinLaw gelatin_law(const std::vector<std::string>& rows, Misfit misfit) {
  auto chosen = table("gelatin_formulations").where(rows);
  return fit_gelatin_law(chosen.numbers("concentration", dimension::none),
                         chosen.numbers("mu_quasistatic", dimension::pressure),
                         constant("gelatin_concentration_exponent"), misfit);
}

inline GelatinLaw gelatin_law_with_free_exponent() {
  auto chosen = table("gelatin_formulations").where({"source_of_mu=curve"});
  return fit_gelatin_law(chosen.numbers("concentration", dimension::none),
                         chosen.numbers("mu_quasistatic", dimension::pressure), Misfit::absolute);
}

inline MeanRateFactor rate_factor() {
  auto chosen = table("gelatin_formulations").where({"source_of_mu=curve"});
  return fit_rate_factor(chosen.numbers("mu_quasistatic", dimension::pressure),
                         chosen.numbers("mu_highrate", dimension::pressure));
}

// Depth [m] of the 3.18 mm steel ball against rho v a.
inline Line steel_line() {
  auto shots = table("gelatin_shots").where({"material=steel", "diameter_corrected_mm=3.18"});
  return depth_trend(read_shots(shots, {.diameter = "diameter_corrected"}));
}

// The same line with the two numbers that the text prints.
inline Line printed_steel_line() {
  Line line;
  line.slope = 0.0049e-2;
  line.intercept = -0.7794e-2;
  return line;
}

struct GoldCase {
  double radius, speed, measured, printed, fe, scaled;
};

// Table 4-4 with its scaled column computed anew.
inline std::vector<GoldCase> gold_cases(const Line& line) {
  auto rows = table("gold_skin");
  auto column = [&](const char* name, const Dimension& dimension) { return rows.numbers(name, dimension); };
  auto radii = column("radius", dimension::length), speeds = column("velocity", dimension::speed);
  auto measured = column("penetration", dimension::length), printed = column("scaled", dimension::length);
  auto fe = column("fe", dimension::length);
  double speed_ratio = constant("model_velocity") / constant("calibration_velocity");
  std::vector<GoldCase> cases;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    System particle;
    particle.radius = radii[i];
    particle.speed = speeds[i];
    cases.push_back(
        {radii[i], speeds[i], measured[i], printed[i], fe[i], depth_from_model(line, steel(), speed_ratio, particle)});
  }
  return cases;
}

inline double mean_error(const std::vector<GoldCase>& cases, double GoldCase::*prediction) {
  std::vector<double> computed, measured;
  for (const auto& one : cases) {
    computed.push_back(one.*prediction);
    measured.push_back(one.measured);
  }
  return mean_relative_error(computed, measured);
}

// Depth [m] of a prism against its speed.
inline Line angular_line(const std::string& angularity) {
  auto rows = table("angular_shots").where({"angularity_deg=" + angularity});
  return linear_trend(rows.numbers("velocity", dimension::speed), rows.numbers("penetration", dimension::length));
}

// Table 5-3's three depths [m] at 40 m/s and the rhombus's mass.
struct EqualMassDepths {
  double rhombus, square, sphere;
};
inline EqualMassDepths equal_mass_depths() {
  constexpr double speed = 40;
  auto mass = [](const char* angularity) {
    return table("angular_shots")
        .where({std::string("angularity_deg=") + angularity})
        .numbers("mass", dimension::mass)
        .at(0);
  };
  auto as_measured = table("angular_shots").where({"angularity_deg=60", "velocity_m_s=40"});
  auto ball = steel();
  auto sphere = ball;
  sphere.radius = equal_mass_radius(mass("60"), *ball.particle_density);
  sphere.speed = speed;
  return {as_measured.numbers("penetration", dimension::length).at(0),
          angular_line("45").at(speed) * equal_mass_prism_scale(mass("45"), mass("60")),
          depth_from_model(steel_line(), ball, 1, sphere)};
}

// Mean |FE/measured - 1| of a prism's shots, with or without the one that it was calibrated at.
inline double angular_fe_error(const std::string& angularity, double left_out_speed) {
  auto rows = table("angular_shots").where({"angularity_deg=" + angularity});
  auto speeds = rows.numbers("velocity", dimension::speed);
  auto measured = rows.numbers("penetration", dimension::length), fe = rows.numbers("fe", dimension::length);
  std::vector<double> kept_fe, kept_measured;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (speeds[i] == left_out_speed) continue;
    kept_fe.push_back(fe[i]);
    kept_measured.push_back(measured[i]);
  }
  return mean_relative_error(kept_fe, kept_measured);
}

}  // namespace percal::guha2009
