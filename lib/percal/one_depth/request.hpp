// One shot with its depth and all but one number of the layer, as a user says it and as it is understood.   docs/formats/invert.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/impact/target/size.hpp"
#include "percal/predict/shot_words.hpp"
#include "percal/predict/sphere_shot.hpp"

namespace percal {

// Texts with units, as options have them; empty where nothing is said.
struct InvertWords {
  std::string scene = {};  // a file: of any shot and target, in place of sphere, speed and layer
  std::string depth = {}, depth_error = {};
  SphereWords sphere = {};
  std::string speed = {}, speed_error = {};
  std::string density = {}, alpha = {};
  std::string mu = {}, erosion_strain = {};  // one of the two
  std::string erosion_length = {};
  std::string layer_depth = {}, layer_width = {};
  std::string elements_per_radius = {};
  std::optional<double> level = {};
};
// Its texts by their names.
std::vector<NamedText> named_texts(InvertWords& words);

// A number of the layer that the depth falls with: one is given, the other looked for.
enum class LayerNumber { mu, erosion_strain };
inline LayerNumber other(LayerNumber number) {
  return number == LayerNumber::mu ? LayerNumber::erosion_strain : LayerNumber::mu;
}
double& number_of(LayerMaterial& material, LayerNumber number);
double number_of(const LayerMaterial& material, LayerNumber number);
std::string name_of(LayerNumber number);                 // "true modulus", "erosion strain"
std::string words_of(LayerNumber number, double value);  // "346 kPa", "0.58"

// By which the ridge multiplies the given number, and the place of the one that leaves it.
inline constexpr double ridge_factors[] = {0.5, 0.7, 1, 1.4, 2};
inline constexpr int own_factor = 2;

struct InvertRequest {
  InvertWords words;
  LayerNumber sought = LayerNumber::mu;
  std::optional<Scene> scene = {};  // where one is given; the shot's and the material's numbers are then its own
  SphereShot shot;                  // of another particle: its radius as a scene has it, its density where it has one
  LayerMaterial material;           // the number that is looked for: where the search begins
  double depth = 0;                 // m
  std::optional<double> depth_error, speed_error;  // relative standard deviations
  double elements_per_radius = 0;
  double level = 0.95;
};

// Throws BadInput by the name of the option, or the scene's key, that is missing or cannot be understood.
InvertRequest understood(const InvertWords& words);

// A run of the request, of another material of its kind.
Scene scene_of(const InvertRequest& request, const LayerMaterial& material);

// Of the first run. Throws BadInput where it is too large.
RunSize first_run(const InvertRequest& request);

}  // namespace percal
