// What is asked of a finished calibration, as a user says it and as it is understood.             docs/formats/predict.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/predict/predictor.hpp"
#include "percal/predict/shot_words.hpp"

namespace percal {

// Texts with units, as options have them; empty where nothing is said.
struct PredictWords {
  std::string material = {}, hypothesis = {};  // names; a hypothesis also by its number, from 1
  std::string body = {};                       // "sphere" or the name of another body that was shot
  std::string speed = {};                      // a quantity, or a range "50..250 m/s"
  SphereWords sphere = {};
  std::string layer_depth = {};
  std::string speed_error = {};  // a share: standard deviation of every speed
  std::string shots = {};        // CSV of many shots; a column stands before the option of its name
  std::string depth = {};        // given: what gives it is looked for
  std::string solve_for = {};    // speed, diameter, density
  bool v50 = false;              // the number at which half of the shots pass the layer is looked for
  std::optional<double> level = {};
};

// Its texts by their names.
std::vector<NamedText> named_texts(PredictWords& words);

struct NamedShot : SphereShot {
  std::string label;
};

struct PredictRequest {
  PredictWords words;
  int hypothesis = 0, material = 0;           // indices
  std::shared_ptr<const ShotBody> body = {};  // none: spheres
  double level = 0.95;
  double speed_error = 0;        // relative
  std::vector<NamedShot> shots;  // of which depths are asked; one where a number is looked for: what it has in common
  std::vector<std::string> columns_passed_over;  // of the table of shots: headers that say nothing of a shot
  std::optional<QuantityRange> speeds;           // of a curve of depth over speed, m/s
  std::optional<ShotNumber> looked_for;          // the number at which the depth is
  double depth = 0;                              // this one, m; the layer's where passing is asked for
};

inline const char* word(ShotNumber number) {
  constexpr const char* words[] = {"speed", "diameter", "density"};
  return words[static_cast<int>(number)];
}

// The hypothesis of that name or number, from 1; the first where nothing is said.
int hypothesis_named(const std::string& name, const ShotModel& model, const Place& place);
// The material of that name; where nothing is said, the one that there is, or that shots were fitted into. Throw BadInput with the place.
int material_named(const std::string& name, const ShotModel& model, const Place& place);

// What the shots are of: the body of that name; where nothing is said, what the material's fitted shots have in common. None: spheres. Throws
// BadInput.
std::shared_ptr<const ShotBody> body_named(const std::string& name, const ShotModel& model, int material);

// What is left out is what the material's fitted shots have in common. Throws BadInput for what is not understood, for a number that they do
// not have in common and nobody says.
PredictRequest understood(const PredictWords& words, const ShotModel& model);

}  // namespace percal
