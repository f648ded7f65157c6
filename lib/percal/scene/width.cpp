#include "percal/scene/width.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "percal/scene/profile.hpp"

namespace percal {
namespace {

constexpr double near_wall = 5, far_wall = 12;  // radii
constexpr double fast_from = 30;                // pi4
constexpr double heavy_above = 10;              // particle's density over the target's

}  // namespace

double usual_width(double pi4, double density_ratio) {
  if (pi4 < fast_from) return near_wall;
  return density_ratio > heavy_above ? farthest_wall : far_wall;
}

double usual_width_in_reaches(const Scene& scene) {
  const double speed = scene.particle.speed;
  const auto pi4 = [&](double density, double mu_as_given, double alpha) {
    return density * speed * speed / true_modulus(mu_as_given, alpha, scene.target.convention);
  };
  double largest = pi4(scene.target.density, scene.target.mu_as_given, scene.target.alpha);
  for (const LowerLayerScene& layer : scene.below)
    largest = std::max(largest, pi4(layer.density, layer.mu_as_given, layer.alpha));
  return usual_width(largest, particle_density(scene) / scene.target.density);
}

double reach_of(const Scene& scene) { return std::max(scene.particle.radius, reach(scene.particle, scene.geometry)); }

double usual_width(const Scene& scene) { return usual_width_in_reaches(scene) * reach_of(scene); }

std::string width_warning(double width, double usual) {
  if (width >= usual * (1 - 1e-9)) return "";
  return fmt::format(
      "the wall at {:.4g} radii is nearer than the {:.4g} that so fast a shot wants: expect an error of up to 6 % in "
      "depth at "
      "5 radii, with either sign, and of up to 15 % where graded columns grow fast; left out, the width is chosen",
      width, usual);
}

double width_of(const Scene& scene) { return scene.target.width ? *scene.target.width : usual_width(scene); }

}  // namespace percal
