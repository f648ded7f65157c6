#include "percal/card/card_material.hpp"

#include <fmt/core.h>

#include <cmath>

namespace percal {
namespace {

void need(bool good, const Place& place, const std::string& key, double found, const std::string& accepted) {
  if (good) return;
  const std::string whole_key = place.key.empty() ? key : place.key + "." + key;
  throw BadInput(Place{place.file, place.line, whole_key}, fmt::format("{}", found), accepted);
}

void need_positive(double value, const Place& place, const std::string& key, const std::string& what) {
  need(std::isfinite(value) && value > 0, place, key, value, "a positive " + what);
}

}  // namespace

void check(const CardMaterial& material, const Place& place) {
  need_positive(material.density, place, "density_kg_m3", "density in kg/m3");
  need_positive(material.mu_true, place, "mu_true_Pa", "shear modulus in Pa");
  need(std::isfinite(material.alpha) && material.alpha != 0, place, "alpha", material.alpha, "a number other than 0");
  need_positive(material.bulk_modulus, place, "bulk_modulus_Pa", "bulk modulus in Pa");
  if (material.erosion) need_positive(material.erosion->limit, place, "erosion.strain", "strain");
}

}  // namespace percal
