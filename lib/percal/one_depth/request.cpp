#include "percal/one_depth/request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/base/error.hpp"
#include "percal/page/numbers.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/scene/scene_toml.hpp"
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

// The number of the two that is given.
void take_given_number(const InvertWords& words, LayerNumber sought, LayerMaterial& material) {
  if (sought == LayerNumber::erosion_strain)
    material.mu_true = needed(words.mu, "--mu", dimension::pressure, "the true modulus, such as 346kPa");
  else
    material.erosion_strain = needed(words.erosion_strain, "--erosion-strain", dimension::none, "a strain");
}

// The scene has what these options say.
void refuse_beside_scene(InvertWords words) {
  for (auto& [name, said] : named_texts(words)) {
    if (said->empty() || said == &words.scene || said == &words.depth || said == &words.depth_error ||
        said == &words.speed_error || said == &words.mu || said == &words.erosion_strain ||
        said == &words.elements_per_radius)
      continue;
    std::string option = std::string("--") + name;
    std::ranges::replace(option, '_', '-');
    refuse_option(option, "this beside --scene", "the scene's own");
  }
}

// Whose one layer erodes by strain.
Scene one_layer_scene(const std::string& file) {
  Scene scene = read_scene(file);
  const auto refuse = [&](const std::string& key, const std::string& found, const std::string& accepted) {
    throw BadInput({scene.source, 0, key}, found, accepted);
  };
  if (!scene.below.empty()) refuse("below", "further layers", "a target of one layer, whose number is looked for");
  const LayerScene& layer = scene.target;
  if (!std::holds_alternative<StrainErosion>(layer.erosion) || layer.further_erosion != FurtherErosion{} ||
      !std::holds_alternative<AnySize>(layer.erosion_by_size))
    refuse("target.erosion", "no erosion, or other limits than one strain", "one strain");
  scene.output = {};
  return scene;
}

// The search begins at the scene's own numbers. A width that the scene leaves to the program is that of the softest layer.
void take_scene(const InvertWords& words, InvertRequest& request) {
  refuse_beside_scene(words);
  Scene scene = one_layer_scene(words.scene);
  LayerScene& layer = scene.target;
  if (!(layer.depth > std::max(request.depth, scene.particle.radius)))
    refuse_option("--depth", format_quantity(request.depth, dimension::length),
                  "less than the depth of the scene's target");
  const auto& strain = std::get<StrainErosion>(layer.erosion);
  request.material = {.density = layer.density,
                      .mu_true = true_modulus(layer.mu_as_given, layer.alpha, layer.convention),
                      .alpha = layer.alpha,
                      .erosion_strain = stretch_at(strain.limit, strain.measure) - 1};
  if (const auto* average = std::get_if<AverageWithin>(&layer.erosion_average))
    request.material.erosion_length = average->length;
  take_given_number(words, request.sought, request.material);
  layer.convention = ModulusConvention::true_shear;
  layer.mu_as_given =
      request.material.mu_true / (request.sought == LayerNumber::mu ? guess_may_be_off : 1 / ridge_factors[0]);
  layer.width = width_of(scene);
  request.shot = {.radius = scene.particle.radius,
                  .density = scene.particle.density,
                  .speed = scene.particle.speed,
                  .layer_depth = layer.depth,
                  .layer_width = *layer.width};
  if (words.elements_per_radius.empty()) request.elements_per_radius = scene.mesh.elements_per_radius;
  request.scene = std::move(scene);
}

// A sphere into a layer, option by option.
void take_sphere(const InvertWords& words, InvertRequest& request) {
  const auto radii = ShotRows().radii(words.sphere);
  if (!radii) refuse_option("--diameter", "nothing", "the sphere's diameter, or its --radius, such as 4.5mm");
  const auto densities = ShotRows().densities(words.sphere, *radii);
  if (!densities)
    refuse_option("--particle-density", "nothing",
                  "the sphere's density, or its --particle-mass, such as \"7800 kg/m3\"");
  request.shot = {
      .radius = radii->front(),
      .density = densities->front(),
      .speed = needed(words.speed, "--speed", dimension::speed, "the sphere's speed, such as \"180 m/s\""),
      .layer_depth = needed(words.layer_depth, "--layer-depth", dimension::length, "the target's depth, such as 150mm"),
      .layer_width = 0};
  if (!(request.shot.layer_depth > std::max(request.depth, request.shot.radius)))
    refuse_option("--layer-depth", format_quantity(request.shot.layer_depth, dimension::length),
                  "more than the depth and the sphere's radius");
  request.material = {
      .density = needed(words.density, "--density", dimension::density, "the layer's density, such as \"1030 kg/m3\""),
      .alpha = alpha_of(words),
      .erosion_strain = 1,
      .erosion_length =
          optional_quantity(words.erosion_length, "--erosion-length", dimension::length, positive("length"))};
  take_given_number(words, request.sought, request.material);
  if (request.sought == LayerNumber::mu) request.material.mu_true = guessed_modulus(request);
  const double softest = request.sought == LayerNumber::mu ? request.material.mu_true / guess_may_be_off
                                                           : request.material.mu_true * ridge_factors[0];
  request.shot.layer_width = optional_quantity(words.layer_width, "--layer-width", dimension::length,
                                               {.low = request.shot.radius,
                                                .high = INFINITY,
                                                .low_open = true,
                                                .words = "a length above the sphere's radius"})
                                 .value_or(usual_layer_width(request, softest));
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
  std::vector<NamedText> texts{{"scene", &words.scene},
                               {"depth", &words.depth},
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
  request.depth = needed(words.depth, "--depth", dimension::length, "the measured depth, such as 85mm");
  request.depth_error = depth_error_of(words, request.depth);
  if (!words.speed_error.empty()) request.speed_error = one_share(words.speed_error, "--speed-error", relative_error);
  if (words.scene.empty())
    take_sphere(words, request);
  else
    take_scene(words, request);
  if (request.elements_per_radius == 0) request.elements_per_radius = elements_of(words, request);
  first_run(request);
  return request;
}

Scene scene_of(const InvertRequest& request, const LayerMaterial& material) {
  if (request.scene) {
    Scene scene = *request.scene;
    scene.target.mu_as_given = material.mu_true;
    scene.target.erosion = StrainErosion{material.erosion_strain, StrainMeasure::engineering};
    scene.mesh.elements_per_radius = request.elements_per_radius;
    return scene;
  }
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
