// A calibration as its TOML file says it: parameters, materials, curves, shots, hypotheses. docs/formats/calibrate.md
#pragma once
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "percal/campaign/run_numbers.hpp"
#include "percal/estimate/least_squares.hpp"
#include "percal/fit/points/curve_data.hpp"
#include "percal/material/conventions.hpp"
#include "percal/predict/sphere_shot.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

// mu as given (Pa), alpha, erosion strain, the length over which erosion is judged (m), the exponents of MaterialLaws, a term of its
// relaxation: share and time (s)
enum class ParameterKind {
  modulus,
  exponent,
  erosion_strain,
  erosion_length,
  rate_exponent,
  size_exponent,
  relaxation_share,
  relaxation_time
};

inline constexpr const char* parameter_kinds[] = {"modulus",          "exponent",       "erosion strain",
                                                  "erosion length",   "rate exponent",  "size exponent",
                                                  "relaxation share", "relaxation time"};
inline const char* word(ParameterKind kind) { return parameter_kinds[static_cast<int>(kind)]; }

struct CalibrationParameter {
  ParameterKind kind = ParameterKind::modulus;
  FreeParameter free;
};

// A material's number: fixed, or the index of a parameter; materials that name one parameter share it.
struct SharedParameter {
  int index;
};
using MaterialNumber = std::variant<double, SharedParameter>;

// A term of a Prony series.
struct MaterialRelaxation {
  MaterialNumber share, time;
};

struct CalibrationMaterial {
  std::string name;
  double density = 0;  // kg/m3
  MaterialNumber mu, alpha, erosion_strain;
  std::optional<MaterialNumber> erosion_length = {};  // all materials of a job have one, or none has
  MaterialNumber rate_exponent = 0.0, size_exponent = 0.0;
  double reference_rate = 1, reference_radius = 1;  // 1/s, m: mu and erosion_strain are of these where they have laws
  std::vector<MaterialRelaxation> relaxation = {};  // mu is then the instantaneous one; no rate_exponent beside it
  MaterialNumber erosion_strain_below = 0.0;        // for spheres of a diameter below `cell`
  double cell = 0;                                  // m; 0: none
  std::optional<double>
      rate_factor;  // high-rate over quasi-static modulus: the quasi-static moduli are reported where it is there
  double rate_factor_error = 0;         // relative standard deviation
  std::optional<double> curve_modulus;  // Pa, true, of its stress-stretch curve: shown beside ours, used nowhere
};

// What is shot into: a material, or one with others on top of it. The job's materials themselves come first, in their order.
struct TargetCover {
  int material = 0;      // of CalibrationJob::materials
  double thickness = 0;  // m
};
struct CalibrationTarget {
  std::string name;
  int material = 0;                      // the one below all
  std::vector<TargetCover> covers = {};  // the next to it first
};

// What was seen of a shot: its depth, or another of its numbers; one that is no smaller or no larger than this; whether it passed its layer;
// the speed that was left to it behind the layer.
enum class ShotDatum { depth, at_least, at_most, passed, stopped, speed_left, none };

inline const char* word(ShotDatum datum) {
  constexpr const char* words[] = {"depth", "at least", "at most", "passed", "stopped", "speed left", "none"};
  return words[static_cast<int>(datum)];
}

inline Seen seen_of(ShotDatum datum) {
  constexpr Seen seen[] = {Seen::number, Seen::at_least, Seen::at_most, Seen::above,
                           Seen::below,  Seen::number,   Seen::number};
  return seen[static_cast<int>(datum)];
}

// Whether it is about passing the layer.
inline bool is_of_passage(ShotDatum datum) {
  return datum == ShotDatum::passed || datum == ShotDatum::stopped || datum == ShotDatum::speed_left;
}

// A sphere, or another body, shot into a target.
struct MeasuredShot : SphereShot {  // all spheres of a job have one width in radii
  std::string label;
  int target = 0;          // of CalibrationJob::targets
  double speed_error = 0;  // m/s, standard deviation
  ShotDatum datum = ShotDatum::depth;
  RunNumber number = RunNumber::depth;  // which one was measured, where one was
  double depth =
      0;  // m: that number, or bounded by this; of passed and stopped the layer's depth; of a speed left the reach (invert/reach.hpp)
  double depth_error = 0;  // m, standard deviation of it where one is known
  double speed_left = 0;   // m/s, of a datum that is one

  bool is_number() const { return datum == ShotDatum::depth || datum == ShotDatum::speed_left; }
  bool used = true;                        // fitted; else only predicted
  int group = 0;                           // scatter group
  int set = 0;                             // of CalibrationJob::sets
  std::map<std::string, std::string> row;  // its row of the table, for filters of cross-validation
  std::string file = {};                   // the table; empty where the job says the shot itself
};

inline EmulatorOf emulator_for(const MeasuredShot& shot) { return {place_of_body(shot), shot.number}; }

// Whether what was seen of it says about how deep it went.
inline bool tells_depth(const MeasuredShot& shot) {
  return shot.datum != ShotDatum::none && kind_of(shot.number).over_depth;
}

// "at least", "final depth", "final depth at least": what was seen, with the number that it is of where that is not the deepest depth.
inline std::string seen_words(const MeasuredShot& shot) {
  if (shot.number == RunNumber::depth) return word(shot.datum);
  const std::string words = kind_of(shot.number).words;
  return shot.datum == ShotDatum::depth ? words : words + " " + word(shot.datum);
}

struct ShotSet {
  std::string name;
  bool leave_one_out = false;  // of its shots, those used and not used alike: each from the others' fit
};

// Stress-stretch points of a material. The curve's modulus is mu / rate_factor, at the curve's rate where the material has a law of it;
// where the material relaxes, its points have times and its stress is that of their history.
struct MeasuredCurve {
  std::string name;
  int material = 0;
  CurveData data;
  double relative_error = 0;  // of one stress, standard deviation; scatter is estimated beside it where the job says so
  double rate_factor = 1;
  double rate_factor_error = 0;
  std::optional<double> rate = {};  // 1/s
  int group = 0;
  bool synthetic = false;  // generated: said wherever it is used
};

// One way to read the data: which numbers are held, and the choices that depths cannot settle.
struct Hypothesis {
  std::string name;
  std::map<int, double> held;                                    // parameter -> natural value
  ModulusConvention convention = ModulusConvention::true_shear;  // what mu as given means
  StrainMeasure measure = StrainMeasure::engineering;            // of the held erosion strains, as the job wrote them
};

// Shots by filters "COLUMN=VALUE" of their table's rows, or "set=NAME": all of a list must hold.
using ShotFilter = std::vector<std::string>;
struct CrossValidation {
  std::string name;
  ShotFilter fit, predict;
  std::vector<int> hypotheses;  // empty: every one
  std::optional<double> goal;   // mean relative deviation; said beside the result
};

// Pairs of a modulus and an erosion strain that somebody else found, to be drawn beside the ridge. They are used nowhere else.
struct PublishedPair {
  double mu = 0;  // Pa, as given
  double erosion_strain = 0;
};
struct PublishedPairs {
  std::string name;
  int modulus = 0;  // job parameter beside whose ridge they are drawn
  std::vector<PublishedPair> pairs;
};

inline constexpr int smallest_training = 24;  // runs that an emulator of a job wants

// How many runs are spent.
struct RunCounts {
  int initial = 0, batch = 0, most = 0;
};

// How runs are spent on the emulator.
struct TrainingSettings {
  // Elements per radius, or in the erosion length where the materials have one; training runs draw theirs about the first two.
  double coarse = 6, fine = 8, verify = 10;
  int initial = 160;                                       // runs of the first, space-filling design, coarse
  int batch = 40;                                          // runs of each later round
  int most = 900;                                          // runs altogether, for each emulator
  RunCounts body{.initial = 32, .batch = 10, .most = 80};  // the same of every body that is no sphere
  double fine_share = 0.25;                                // of each round
  double accuracy = 0.2;            // stop where the emulator's error is below this share of the data's
  double failures_tolerated = 0.5;  // share of runs without a depth; above it the job stops and says why
  bool passage =
      false;  // runs that pass their layer go on, and are learnt from, whether or not a shot tells of passing
  std::set<RunNumber> learn = {};  // numbers beside the depth, whether or not a shot tells them
  int verify_replicates = 1;       // all shots together tell whether the emulator holds
  unsigned seed = 20090401;        // of points drawn from the data, and of the phases of the training meshes
};

struct CalibrationJob {
  std::string file, title, text;  // text: the file as it stands
  std::vector<CalibrationParameter> parameters;
  std::vector<CalibrationMaterial> materials;
  std::vector<CalibrationTarget> targets;
  std::vector<ScatterGroup> groups;
  std::vector<ShotSet> sets;
  std::vector<std::shared_ptr<const ShotBody>>
      bodies;  // in the order of their places: what its shots were that are no spheres
  std::vector<MeasuredShot> shots;
  std::vector<MeasuredCurve> curves;
  std::vector<Hypothesis> hypotheses;  // never empty
  std::vector<CrossValidation> cross_validations;
  std::vector<PublishedPairs> published;
  bool width_was_chosen = false;  // farthest_wall, since no shot has one
  TrainingSettings training;
  SolverScene solver;
  bool dehn = true;  // the closed form beside it
  double level = 0.95;
  int bootstrap = 200;
};

// Whether it is the target, or lies on top of it.
inline bool is_in(const CalibrationTarget& target, int material) {
  return target.material == material ||
         std::ranges::any_of(target.covers, [=](const TargetCover& cover) { return cover.material == material; });
}
inline bool meets(const CalibrationJob& job, const MeasuredShot& shot, int material) {
  return is_in(job.targets[shot.target], material);
}

// The most covers that a target of the job has.
inline std::size_t covers_of(const CalibrationJob& job) {
  std::size_t most = 0;
  for (const CalibrationTarget& target : job.targets) most = std::max(most, target.covers.size());
  return most;
}

// Whether erosion is judged over a length. The same share of it is then an element for spheres of every size.
inline bool has_erosion_length(const CalibrationJob& job) {
  return !job.materials.empty() && job.materials.front().erosion_length;
}

// Whether the emulator learns what passes a layer, and with which speed.
inline bool learns_passage(const CalibrationJob& job) {
  return job.training.passage ||
         std::ranges::any_of(job.shots, [](const MeasuredShot& shot) { return is_of_passage(shot.datum); });
}

// The numbers beside the depth that its shots tell, or that it wants to be learnt, each once.
inline std::set<RunNumber> numbers_of(const CalibrationJob& job) {
  std::set<RunNumber> numbers = job.training.learn;
  for (const MeasuredShot& shot : job.shots)
    if (shot.number != RunNumber::depth) numbers.insert(shot.number);
  return numbers;
}

// The places of what was shot, spheres first.
inline std::set<int> bodies_of(const CalibrationJob& job) {
  std::set<int> places;
  for (const MeasuredShot& shot : job.shots) places.insert(place_of_body(shot));
  return places;
}

// What the training meshes count.
inline const char* mesh_words(const CalibrationJob& job) {
  return has_erosion_length(job) ? "elements in the erosion length" : "elements per radius";
}

// Throws BadInput for everything that is wrong with the job and its tables.
CalibrationJob read_calibration_job(const std::string& path);

}  // namespace percal
