#include "percal/card/header.hpp"

#include <fmt/core.h>

#include "percal/base/version.hpp"
#include "percal/card/field.hpp"
#include "percal/material/stability.hpp"

namespace percal {
namespace {

struct NamedMeasure {
  StrainMeasure measure;
  const char* name;
};
constexpr NamedMeasure measures[] = {{StrainMeasure::engineering, "engineering"},
                                     {StrainMeasure::true_strain, "true"},
                                     {StrainMeasure::green_lagrange, "Green-Lagrange"}};

std::string stability(const CardMaterial& material) {
  const StretchRange searched;
  return stability_sentence(stable_ranges({{{material.mu_true, material.alpha}}}, searched), searched);
}

}  // namespace

std::string card_header(const std::string& prefix, const CardMaterial& material, const UnitSystem& units,
                        const ModulusField& modulus) {
  const double ratio = material.bulk_modulus / material.mu_true;
  std::string text;
  const auto add = [&](const std::string& line) { text += comment_lines(prefix, line); };
  add(fmt::format("percal {}: one-term Ogden material '{}'", version(), material.name));
  add(fmt::format("unit system: {} (length {}, mass {}, time {}, stress {})", units.name, units.length_unit,
                  units.mass_unit, units.time_unit, units.stress_unit));
  add("W = (2 mu/alpha^2) (l1^alpha + l2^alpha + l3^alpha - 3) + U(J), mu the small-strain shear modulus");
  add(fmt::format("mu: {:.9g} Pa; alpha: {:.9g}; 2 mu/alpha: {:.9g} Pa", material.mu_true, material.alpha,
                  2 * material.mu_true / material.alpha));
  add(fmt::format("this card's modulus is {}: {:.9g} Pa = {:.9g} {}", modulus.meaning, modulus.in_pascals,
                  modulus.in_pascals / units.stress, units.stress_unit));
  add(fmt::format("bulk modulus K: {:.9g} Pa = {:.6g} mu; Poisson's ratio: {:.12g}", material.bulk_modulus, ratio,
                  poisson_ratio(ratio)));
  add(fmt::format("density: {:.9g} kg/m3", material.density));
  add(stability(material));
  return text;
}

std::string in_all_measures(const CardErosion& erosion) {
  const double stretch = stretch_at(erosion.limit, erosion.measure);
  std::string text;
  for (const auto& [measure, name] : measures) {
    const double strain = measure == erosion.measure ? erosion.limit : strain_at(stretch, measure);
    text += fmt::format("{}{:.6g} {}", text.empty() ? "" : " = ", strain, name);
  }
  return text + fmt::format(" (stretch {:.6g})", stretch);
}

std::string card_sources(const std::string& prefix, const CardMaterial& material) {
  std::string text;
  for (const std::string& comment : material.comments) text += comment_lines(prefix, comment);
  return text;
}

}  // namespace percal
