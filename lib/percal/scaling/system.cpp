#include "percal/scaling/system.hpp"

#include <algorithm>
#include <vector>

#include "percal/base/error.hpp"

namespace percal {

std::span<const SystemQuantity> system_quantities() {
  static const std::vector<SystemQuantity> all = {
      {"radius", "a", "particle radius", dimension::length, "m", &System::radius},
      {"particle_density", "rho_p", "particle density", dimension::density, "kg_m3", &System::particle_density},
      {"particle_modulus", "E", "particle modulus", dimension::pressure, "Pa", &System::particle_modulus},
      {"speed", "v", "impact speed", dimension::speed, "m_s", &System::speed},
      {"target_density", "rho_t", "target density", dimension::density, "kg_m3", &System::target_density},
      {"mu", "mu", "true shear modulus", dimension::pressure, "Pa", &System::mu},
      {"alpha", "alpha", "Ogden exponent", dimension::none, "", &System::alpha},
      {"erosion_strain", "eps_t", "erosion strain", dimension::none, "", &System::erosion_strain},
      {"depth", "L", "target depth", dimension::length, "m", &System::depth},
      {"width", "w", "target width", dimension::length, "m", &System::width},
      {"penetration", "P_d", "penetration depth", dimension::length, "m", &System::penetration},
      {"strain_rate", "rate", "strain rate", Dimension{.time = -1}, "1_s", &System::strain_rate},
      {"time", "t", "time", dimension::time, "s", &System::time},
  };
  return all;
}

const SystemQuantity& system_quantity(std::optional<double> System::*member) {
  return *std::ranges::find(system_quantities(), member, &SystemQuantity::member);
}

std::string result_key(const SystemQuantity& quantity) {
  const std::string key = quantity.member == &System::mu ? "mu_true" : quantity.key;
  return quantity.unit.empty() ? key : key + "_" + quantity.unit;
}

double required(const System& system, std::optional<double> System::*member) {
  if (system.*member) return *(system.*member);
  const auto& quantity = system_quantity(member);
  throw BadInput(title(system) + ": the " + quantity.words + " (" + quantity.key + ") is missing");
}

std::optional<double> impact_parameter(const System& system) {
  if (!system.particle_density || !system.speed || !system.radius) return std::nullopt;
  return *system.particle_density * *system.speed * *system.radius;
}

std::optional<double> sectional_density(const System& system) {
  if (!system.particle_density || !system.radius) return std::nullopt;
  return 4.0 / 3 * *system.particle_density * *system.radius;
}

std::string title(const System& system) { return system.particle + " into " + system.target; }

}  // namespace percal
