#include "percal/material/plausible.hpp"

#include <fmt/core.h>

#include <cmath>

#include "percal/units/quantity.hpp"

namespace percal {
namespace {

constexpr double softest = 10, stiffest = 10e9;    // Pa; below are foams of cells and above is bone
constexpr double lightest = 10, heaviest = 25000;  // kg/m3

}  // namespace

std::vector<std::string> implausible_modulus(double mu) {
  if (mu >= softest && mu <= stiffest) return {};
  return {fmt::format("mu = {} is {} than any soft solid (10 Pa to 10 GPa): check the unit of the stress.",
                      format_quantity(mu, dimension::pressure, 4), mu < softest ? "softer" : "stiffer")};
}

std::vector<std::string> implausible_density(double density) {
  if (std::isnan(density) || (density >= lightest && density <= heaviest)) return {};
  return {fmt::format("{:.4g} kg/m3 is no density of a solid (10 to 25000 kg/m3): check the units.", density)};
}

}  // namespace percal
