// A particle and the layer it is shot into, as far as they are known, in SI. What is not known is not there.
#pragma once
#include <optional>
#include <span>
#include <string>

#include "percal/units/quantity.hpp"

namespace percal {

struct System {
  std::string particle = "particle";
  std::string target = "target";
  std::optional<double> radius;            // m
  std::optional<double> particle_density;  // kg/m3
  std::optional<double> particle_modulus;  // Pa, Young's
  std::optional<double> speed;             // m/s
  std::optional<double> target_density;    // kg/m3
  std::optional<double> mu;                // Pa, the target's true small-strain shear modulus
  std::optional<double> alpha;             // Ogden's exponent
  std::optional<double> erosion_strain;    // engineering: the largest principal stretch less 1
  std::optional<double> depth;             // m, the target's
  std::optional<double> width;             // m, the target's, from the axis to the wall
  std::optional<double> penetration;       // m
  std::optional<double> strain_rate;       // 1/s
  std::optional<double> time;              // s
};

// One of a system's numbers. `key` is its name in jobs, `unit` the SI unit of the result's keys ("kg_m3").
struct SystemQuantity {
  std::string key;
  std::string symbol;
  std::string words;
  Dimension dimension;
  std::string unit;
  std::optional<double> System::*member;
};

// All thirteen, in the order of the struct.
std::span<const SystemQuantity> system_quantities();
const SystemQuantity& system_quantity(std::optional<double> System::*member);

// Its key in results, which says the unit and that mu is the true one: "mu_true_Pa".
std::string result_key(const SystemQuantity& quantity);

// The number, or BadInput that names the system and what it lacks.
double required(const System& system, std::optional<double> System::*member);

// Of a sphere: rho_p v a, kg/(m s), and m/(pi a^2) = 4/3 rho_p a, kg/m2. nullopt where a number is missing.
std::optional<double> impact_parameter(const System& system);
std::optional<double> sectional_density(const System& system);

// "steel into gelatin"
std::string title(const System& system);

}  // namespace percal
