#include "percal/scaling/system_toml.hpp"

#include <string>

#include "percal/scene/sphere_toml.hpp"

namespace percal {
namespace {

bool is_response(const SystemQuantity& quantity) {
  return quantity.member == &System::penetration || quantity.member == &System::strain_rate ||
         quantity.member == &System::time;
}

void read_number(const TomlTable& table, const SystemQuantity& quantity, System& system) {
  bool may_be_negative =
      quantity.member == &System::alpha || quantity.member == &System::mu;  // mu: checked once it is true
  auto range = may_be_negative ? any_number() : positive(quantity.words);
  if (auto number = table.optional_quantity(quantity.key, quantity.dimension, range)) system.*quantity.member = number;
}

// What says radius and density in other words.
void read_diameter_and_mass(const TomlTable& table, System& system) {
  if (const auto diameter = table.optional_quantity("diameter", dimension::length, positive("length"))) {
    if (system.radius) table.refuse("diameter", "this beside radius", "one of the two");
    system.radius = *diameter / 2;
  }
  if (const auto mass = table.optional_quantity("particle_mass", dimension::mass, positive("mass"))) {
    if (system.particle_density) table.refuse("particle_mass", "this beside particle_density", "one of the two");
    if (!system.radius) table.refuse("particle_mass", "this without a radius", "radius or diameter beside it");
    system.particle_density = sphere_density(*mass, *system.radius);
  }
}

void take_true_modulus(const TomlTable& table, SystemInput& input, const SystemInput& otherwise) {
  if (!input.system.mu) return;
  if (input.convention == ModulusConvention::true_shear) {
    if (!(*input.system.mu > 0))
      table.refuse("mu", format_quantity(*input.system.mu, dimension::pressure), "a positive pressure");
    return;
  }
  auto alpha = input.system.alpha ? input.system.alpha : otherwise.system.alpha;
  if (!alpha) table.refuse("mu", "a modulus of convention \"mu/alpha\" and no alpha", "alpha beside it");
  double modulus = true_modulus(*input.system.mu, *alpha, input.convention);
  if (!(modulus > 0))
    table.refuse("mu",
                 "a modulus that makes the true one, mu alpha/2, " + format_quantity(modulus, dimension::pressure),
                 "mu and alpha of one sign");
  input.system.mu = modulus;
}

}  // namespace

SystemInput read_system(const TomlTable& table, const SystemInput& otherwise) {
  SystemInput input;
  input.system.particle = table.text("particle", input.system.particle);
  input.system.target = table.text("target", input.system.target);
  input.convention = static_cast<ModulusConvention>(
      table.word("convention", {word(ModulusConvention::true_shear), word(ModulusConvention::mu_over_alpha)},
                 static_cast<int>(otherwise.convention)));
  input.measure = static_cast<StrainMeasure>(table.word(
      "strain_measure",
      {word(StrainMeasure::engineering), word(StrainMeasure::true_strain), word(StrainMeasure::green_lagrange)},
      static_cast<int>(otherwise.measure)));
  for (const auto& quantity : system_quantities()) read_number(table, quantity, input.system);
  read_diameter_and_mass(table, input.system);
  if (input.system.erosion_strain && input.measure != StrainMeasure::engineering)
    input.system.erosion_strain =
        strain_at(stretch_at(*input.system.erosion_strain, input.measure), StrainMeasure::engineering);
  take_true_modulus(table, input, otherwise);
  return input;
}

void read_response(const TomlTable& table, System& system) {
  for (const auto& quantity : system_quantities())
    if (is_response(quantity)) read_number(table, quantity, system);
}

}  // namespace percal
