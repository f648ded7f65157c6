// What a finished calibration knows about shots that were not fired, without its job, its tables and its runs: the emulator, and for each
// hypothesis the materials' numbers that the data do not rule out.                              docs/theory/prediction.md
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "percal/campaign/run_numbers.hpp"
#include "percal/invert/emulator.hpp"
#include "percal/page/result.hpp"
#include "percal/predict/sphere_shot.hpp"

namespace percal {

// Standard deviation of the logarithm of what one shot shows about the model; degrees of freedom that tell it, 0: it is known.
struct SampleScatter {
  double scatter = 0, freedom = 0;
};

// What can be shot into, a material or one with covers, under one hypothesis.
struct MaterialSample {
  std::string name;
  std::vector<CoveredMaterial> points;             // the best first, then a sample of those that the data allow
  double scatter = 0;                              // of ln depth of one shot about the model, standard deviation
  double freedom = 0;                              // degrees of freedom that tell it; 0: it is known
  std::map<RunNumber, SampleScatter> beside = {};  // of the numbers that the model knows beside the depth
};

struct ShotHypothesis {
  std::string name;
  bool contradicted = false;              // its data disagree under it
  double mesh_error = 0;                  // relative: depth on no mesh over depth on the predicting one, less 1
  std::vector<MaterialSample> materials;  // in the order of the job's targets, the same under every hypothesis
};

// A shot that was fired.
struct FiredShot : SphereShot {
  std::string label;
  int material = 0;                  // index
  std::string seen = "depth";        // what was seen of it, as the calibration's data have it
  std::optional<double> depth = {};  // m; seen, or the least that was; nothing where none was
  bool fitted = true;
};

// Ends of an interval, in the unit of what it is of.
struct Between {
  double low = 0, high = 0;
};

// The range of a number over the shots into a material, all or those that were fitted; nothing where there are none.
enum class Shots { all, fitted };
std::optional<Between> numbers_of_shots(const std::vector<FiredShot>& shots, int material, Shots which,
                                        const std::function<double(const FiredShot&)>& number);

inline constexpr double rounding = 1e-6;  // relative: numbers of two shots that differ by rounding alone
inline bool is_one(const Between& range) { return range.high <= range.low * (1 + rounding); }

// The number of the material's fitted shots where all have the same; of all its shots where none is fitted.
std::optional<double> number_in_common(const std::vector<FiredShot>& shots, int material,
                                       const std::function<double(const FiredShot&)>& number);

// What the emulator of a number beside the depth has learnt.
struct LearntNumber {
  std::vector<TrainingRun> runs = {};  // log_depth: ln of what is learnt (campaign/run_numbers.hpp)
  EmulatorSettings settings = {};
};

// What was shot besides spheres, and what the emulator of its depths has learnt.
struct KeptBody {
  std::shared_ptr<const ShotBody> body;
  LearntNumber depth;
  std::string scene = {};  // TOML of a run
};

struct ShotModel {
  double level = 0.95;
  double elements = 0;     // of the mesh that predictions are of: per radius, or in the erosion length
  bool passage = false;    // it knows what passes a layer: its depths are reaches (invert/reach.hpp)
  int replicates = 1;      // of a run that checks a prediction
  std::string scene = {};  // TOML of a sphere's run: its solver's settings
  std::vector<FiredShot> shots;
  std::vector<TrainingRun> runs;  // of spheres; empty where none was shot
  EmulatorSettings settings;
  std::map<RunNumber, LearntNumber> beside = {};
  std::vector<KeptBody> bodies = {};       // in the order of their places
  std::vector<ShotHypothesis> hypotheses;  // never empty
};
Emulators emulators_of(const ShotModel& model);

// The shots of what has this place (ShotBody::place; 0: spheres).
std::vector<FiredShot> shots_of_body(const std::vector<FiredShot>& shots, int body);

// What it knows about spheres alone. Throws BadInput with the file where it knows nothing of them.
ShotModel of_spheres(ShotModel model, const std::string& file);

page::Json shot_model_to_json(const ShotModel& model);

// The model of a result.json. Throws BadInput where `result` is no result of percal calibrate, or one without shots; page::MissingKey and
// Json's own exceptions where it was cut by hand.
ShotModel shot_model_of(const page::Json& result, const std::string& file);

// The same with BadInput for one that was cut by hand, too.
ShotModel kept_shot_model(const page::Json& result, const std::string& file);

}  // namespace percal
