#include "percal/card/card_curve.hpp"

#include <fmt/core.h>

#include <cmath>

#include "percal/card/card_comments.hpp"

namespace percal {
namespace {

constexpr int most_points = 100000;

void check(const CurveRange& range) {
  const bool shear = range.deformation == Deformation::simple_shear;
  if (range.deformation == Deformation::planar_held || range.deformation == Deformation::biaxial)
    throw BadInput(Place{"", 0, "--mode"}, word(range.deformation), "uniaxial, equibiaxial, planar or shear");
  const bool finite = std::isfinite(range.low) && std::isfinite(range.high) && range.low < range.high;
  if (!finite || (!shear && range.low <= 0))
    throw BadInput(Place{"", 0, "--stretch"}, fmt::format("{}:{}", range.low, range.high),
                   shear ? "LOW:HIGH, two shears, such as 0:1" : "LOW:HIGH, two stretches above 0, such as 0.5:2");
  if (range.points < 2 || range.points > most_points)
    throw BadInput(Place{"", 0, "--points"}, std::to_string(range.points), "2 to 100000");
}

}  // namespace

std::vector<CurvePoint> card_curve(const CardMaterial& material, const CurveRange& range) {
  check(range);
  std::vector<CurvePoint> curve;
  for (int i = 0; i < range.points; ++i) {
    const double share = static_cast<double>(i) / (range.points - 1);
    const double amount = range.low + share * (range.high - range.low);
    curve.push_back({amount, nominal_stress(Hyperelastic{material.terms}, Strained{range.deformation, amount})});
  }
  return curve;
}

std::string csv_card(const CardMaterial& material, const UnitSystem& units, const CurveRange& range) {
  check_solid(material, Place{});
  std::string text = card_comments(
      {"#", "mu_", CardModulus::mu, "no volumetric law: the stresses are those of the incompressible solid"}, material,
      units);
  const bool shear = range.deformation == Deformation::simple_shear;
  text += fmt::format("mode,{},{} [{}]\n", shear ? "gamma" : "stretch", shear ? "shear_stress" : "nominal_stress",
                      units.stress_unit);
  for (const CurvePoint& point : card_curve(material, range))
    text += fmt::format("{},{:.15g},{:.15g}\n", word(range.deformation), point.amount, point.stress / units.stress);
  return text;
}

}  // namespace percal
