#include "percal/material/isochoric.hpp"

#include <cmath>

namespace percal {
namespace {

// Logarithms of the principal stretches: along the measured stress, across, along the free face's normal.
std::array<double, 3> principal_logs(const Strained& strained) {
  const double along = std::log(strained.amount);
  switch (strained.deformation) {
    case Deformation::equibiaxial: return {along, along, -2 * along};
    case Deformation::planar: return {along, 0, -along};
    case Deformation::planar_held: return {0, along, -along};
    case Deformation::biaxial: return {along, std::log(strained.across), -along - std::log(strained.across)};
    default: return {along, -along / 2, -along / 2};
  }
}

// The principal stretches in the plane of shear are lambda and 1/lambda, the third is 1.
IsochoricState sheared(double gamma) {
  const double along = std::asinh(gamma / 2), root = std::hypot(gamma, 2);
  const std::array<double, 2> normal = {-1.0 / 6 - gamma / (2 * root), 1.0 / 3};
  return {.differences = {{{along, -along, 1}, {along, 0, 1}}},
          .of_difference = {{{1 / root - gamma * normal[0], -gamma * normal[1]}, normal}},
          .to_nominal = {1, gamma}};
}

}  // namespace

IsochoricState isochoric_state(const Strained& strained) {
  if (strained.deformation == Deformation::simple_shear) return sheared(strained.amount);
  const auto [along, across, normal] = principal_logs(strained);
  const double per_along = std::exp(-2 * along) / 3, per_normal = std::exp(-2 * normal) / 3;
  return {.differences = {{{along, across, 1}, {along, normal, 1}}},
          .of_difference = {{{per_along, per_along}, {per_normal, -2 * per_normal}}},
          .to_nominal = {std::exp(along), -std::exp(2 * normal - along)}};
}

UnitIsochoric unit_isochoric(double alpha, const IsochoricState& state) {
  const UnitTerm across = unit_term(alpha, state.differences[0]), normal = unit_term(alpha, state.differences[1]);
  UnitIsochoric unit{};
  for (std::size_t c = 0; c < 2; ++c) {
    const auto& [by_across, by_normal] = state.of_difference[c];
    unit.stress[c] = by_across * across.stress + by_normal * normal.stress;
    unit.by_alpha[c] = by_across * across.by_alpha + by_normal * normal.by_alpha;
  }
  return unit;
}

}  // namespace percal
