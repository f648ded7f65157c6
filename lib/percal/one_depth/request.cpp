#include "percal/one_depth/request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/base/error.hpp"
#include "percal/page/numbers.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/scene/width.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr double usual_level = 0.95;
// A first guess of the modulus: depth/radius = this (rho_p/rho_t) pi4^exponent/(erosion strain)^exponent, within these pi4.
constexpr double guess_factor = 0.8, guess_exponent = 0.4, least_pi4 = 0.5, most_pi4 = 3000;
constexpr double guess_may_be_off = 4;   // factor of the modulus
constexpr double smallest_alpha = 1e-3;  // the solver divides by alpha
const Range relative_error{.low = 0, .high = 0.5, .words = "a share from 0 to 50 %"};

double needed(const std::string& text, const char* option, const Dimension& dimension, const std::string& accepted) {
  if (text.empty()) refuse_option(option, "nothing", accepted);
  const Range range = positive(dimension == dimension::none ? "number" : name_of(dimension));
  return one_quantity(text, option, dimension, range);
}

LayerNumber sought_by(const InvertWords& words) {
  if (words.mu.empty() == words.erosion_strain.empty())
    refuse_option("--mu", words.mu.empty() ? "neither this nor --erosion-strain" : "this beside --erosion-strain",
                  "one of the two; the other is looked for");
  return words.mu.empty() ? LayerNumber::mu : LayerNumber::erosion_strain;
}

double alpha_of(const InvertWords& words) {
  const std::string accepted = "the layer's Ogden exponent, from 0.001 up or from -0.001 down";
  if (words.alpha.empty()) refuse_option("--alpha", "nothing", accepted);
  const double alpha = one_quantity(words.alpha, "--alpha", dimension::none, any_number());
  if (std::abs(alpha) < smallest_alpha) refuse_option("--alpha", in_quotes(words.alpha), accepted);
  return alpha;
}

// A share, or a length.
std::optional<double> depth_error_of(const InvertWords& words, double depth) {
  if (words.depth_error.empty()) return std::nullopt;
  if (trimmed(words.depth_error).ends_with('%')) return one_share(words.depth_error, "--depth-error", relative_error);
  const Range range{.low = 0,
                    .high = relative_error.high * depth,
                    .words = "a standard deviation up to half of the depth, as a share (5 %) or a length"};
  return one_quantity(words.depth_error, "--depth-error", dimension::length, range) / depth;
}

double guessed_modulus(const InvertRequest& request) {
  const SphereShot& shot = request.shot;
  const double reach = request.depth / shot.radius / (guess_factor * shot.density / request.material.density);
  const double pi4 = std::clamp(std::pow(reach, 1 / guess_exponent), least_pi4, most_pi4);
  return request.material.density * shot.speed * shot.speed / pi4 / request.material.erosion_strain;
}

// The rule of scenes, for the softest layer of the search.
double usual_layer_width(const InvertRequest& request, double softest) {
  const SphereShot& shot = request.shot;
  const double pi4 = request.material.density * shot.speed * shot.speed / softest;
  return usual_width(pi4, shot.density / request.material.density) * shot.radius;
}

double elements_of(const InvertWords& words, const InvertRequest& request) {
  const double usual = MeshScene{}.elements_per_radius;
  if (!words.elements_per_radius.empty())
    return one_quantity(words.elements_per_radius, "--elements-per-radius", dimension::none,
                        {.low = 1, .high = 1000, .words = "a number from 1 to 1000"});
  if (!request.material.erosion_length) return usual;
  return std::max(usual, std::ceil(mesh_of(request.shot, request.material, 1 / largest_element_in_length)));
}

}  // namespace

std::vector<NamedText> named_texts(InvertWords& words) {
  std::vector<NamedText> texts{{"depth", &words.depth},
                               {"depth_error", &words.depth_error},
                               {"speed", &words.speed},
                               {"speed_error", &words.speed_error},
                               {"density", &words.density},
                               {"alpha", &words.alpha},
                               {"mu", &words.mu},
                               {"erosion_strain", &words.erosion_strain},
                               {"erosion_length", &words.erosion_length},
                               {"layer_depth", &words.layer_depth},
                               {"layer_width", &words.layer_width},
                               {"elements_per_radius", &words.elements_per_radius}};
  for (const NamedText& text : named_texts(words.sphere)) texts.push_back(text);
  return texts;
}

double& number_of(LayerMaterial& material, LayerNumber number) {
  return number == LayerNumber::mu ? material.mu_true : material.erosion_strain;
}

double number_of(const LayerMaterial& material, LayerNumber number) {
  return number == LayerNumber::mu ? material.mu_true : material.erosion_strain;
}

std::string name_of(LayerNumber number) { return number == LayerNumber::mu ? "true modulus" : "erosion strain"; }

std::string words_of(LayerNumber number, double value) {
  return number == LayerNumber::mu ? page::pressure(value, 3) : page::shown(value, 3);
}

InvertRequest understood(const InvertWords& words) {
  InvertRequest request{.words = words,
                        .sought = sought_by(words),
                        .shot = {},
                        .material = {},
                        .depth_error = {},
                        .speed_error = {},
                        .level = words.level.value_or(usual_level)};
  const auto radii = ShotRows().radii(words.sphere);
  if (!radii) refuse_option("--diameter", "nothing", "the sphere's diameter, or its --radius, such as 4.5mm");
  const auto densities = ShotRows().densities(words.sphere, *radii);
  if (!densities)
    refuse_option("--particle-density", "nothing",
                  "the sphere's density, or its --particle-mass, such as \"7800 kg/m3\"");
  request.depth = needed(words.depth, "--depth", dimension::length, "the measured depth, such as 85mm");
  request.depth_error = depth_error_of(words, request.depth);
  request.shot = {
      .radius = radii->front(),
      .density = densities->front(),
      .speed = needed(words.speed, "--speed", dimension::speed, "the sphere's speed, such as \"180 m/s\""),
      .layer_depth = needed(words.layer_depth, "--layer-depth", dimension::length, "the target's depth, such as 150mm"),
      .layer_width = 0};
  if (!words.speed_error.empty()) request.speed_error = one_share(words.speed_error, "--speed-error", relative_error);
  if (!(request.shot.layer_depth > std::max(request.depth, request.shot.radius)))
    refuse_option("--layer-depth", format_quantity(request.shot.layer_depth, dimension::length),
                  "more than the depth and the sphere's radius");
  request.material = {
      .density = needed(words.density, "--density", dimension::density, "the layer's density, such as \"1030 kg/m3\""),
      .alpha = alpha_of(words),
      .erosion_strain = 1,
      .erosion_length =
          optional_quantity(words.erosion_length, "--erosion-length", dimension::length, positive("length"))};
  double softest = 0;
  if (request.sought == LayerNumber::erosion_strain) {
    request.material.mu_true = needed(words.mu, "--mu", dimension::pressure, "the true modulus, such as 346kPa");
    softest = request.material.mu_true * ridge_factors[0];
  } else {
    request.material.erosion_strain = needed(words.erosion_strain, "--erosion-strain", dimension::none, "a strain");
    request.material.mu_true = guessed_modulus(request);
    softest = request.material.mu_true / guess_may_be_off;
  }
  request.shot.layer_width = optional_quantity(words.layer_width, "--layer-width", dimension::length,
                                               {.low = request.shot.radius,
                                                .high = INFINITY,
                                                .low_open = true,
                                                .words = "a length above the sphere's radius"})
                                 .value_or(usual_layer_width(request, softest));
  request.elements_per_radius = elements_of(words, request);
  first_run(request);
  return request;
}

Scene scene_of(const InvertRequest& request, const LayerMaterial& material) {
  Scene scene;
  scene.mesh.elements_per_radius = request.elements_per_radius;
  return scene_of_shot(std::move(scene), request.shot, material);
}

RunSize first_run(const InvertRequest& request) {
  const Scene scene = scene_of(request, request.material);
  need_elements_in_erosion_length(scene, {"", 0, "--erosion-length"});
  const Problem problem = reduce(scene).problem;
  refuse_what_is_too_large(problem, "", {"--elements-per-radius", "--layer-depth", "--layer-width"});
  return size_of(problem);
}

}  // namespace percal
