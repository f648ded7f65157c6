// What a calibration found: for every hypothesis the parameters with their intervals, every shot beside its model, what was predicted
// from what, where the error comes from, and what it cost.                                      docs/formats/calibrate.md
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "percal/calibrate/job.hpp"
#include "percal/estimate/intervals.hpp"
#include "percal/invert/emulator.hpp"
#include "percal/predict/shot_model.hpp"

namespace percal {

// A number with a central value and an interval at the job's level.
struct Estimate {
  double value = 0;
  Interval interval;
};

// What was measured of a shot (MeasuredShot::number), as a model gives it, and what a new shot of the kind would do.
struct ShotDepth {
  int shot = 0;              // of CalibrationJob::shots
  double depth = 0;          // m; of a job that learns passing the reach (invert/reach.hpp)
  double model_error = 0;    // relative standard deviation of the model itself (emulator)
  double low = 0, high = 0;  // m: prediction interval of one shot (parameters, solver noise, scatter)
  bool fitted = true;        // it was among the data of this fit
  double passes = 0;         // probability that one such shot goes as deep as its layer
  // ours / measured - 1; none for a shot of which only a least depth is known.
  std::optional<double> deviation = {};
  std::optional<double> deepest = {};  // m, of a shot of which another number than the deepest depth was measured
};

// The stresses that a model gives for the points of a curve, in their order, and where one more such point would lie; Pa.
struct CurveStresses {
  int curve = 0;  // of CalibrationJob::curves
  std::vector<double> stress = {};
  std::vector<double> low = {}, high = {};  // parameters, rate factor, scatter and the point's own error
};

// Mean of |deviation| over the shots of a set or filter, and how many of the measured depths lie within the intervals.
struct Deviation {
  std::string name;
  int shots = 0;
  double mean_absolute = 0;
  double mean_signed = 0;
  int within = 0;
};

// A fresh run at the optimum, on a finer mesh than the emulator's: no final point is taken from the emulator alone.
struct FreshRun {
  int shot = 0;
  double elements_per_radius = 0;
  std::optional<double> depth = {};  // m; none where it did not stop
  std::string outcome;
  double emulated = 0;      // m, on the same mesh
  double standardised = 0;  // (ln depth - ln emulated) over the emulator's standard deviation, noise included
  std::optional<double> elements_in_length = {};  // in the erosion length, where there is one
  int runs = 0;                                   // whose mean it is: one for each phase of the mesh that was tried
};

struct CrossValidationResult {
  std::string name;
  int fitted = 0;                     // shots that the fit saw
  std::vector<ShotDepth> shots = {};  // predicted
  Deviation fit = {}, prediction = {};
  std::optional<double> goal = {};
};

// Shares of the variance of one quantity.
struct ErrorShare {
  std::string name;
  double standard_deviation = 0;  // relative, of the quantity
  double share = 0;               // of the variance
};
struct ErrorBudget {
  std::string quantity;
  std::vector<ErrorShare> sources = {};
  double standard_deviation = 0;      // of ln of the quantity, all sources
  Estimate total = {};                // natural value with the interval of all sources
  std::string most_influential = {};  // the datum that moves it most, and d ln quantity / d ln depth of it
  double influence = 0;
};

// The moduli of a material under one hypothesis, in both conventions, Pa: mu, and LS-DYNA's MU1 = 2 mu/alpha. E = 3 mu, or 3 MU1 as
// whoever takes MU1 for a shear modulus would say.
struct MaterialModuli {
  std::string material;
  Estimate mu_true = {}, mu_over_alpha = {};
  std::optional<Estimate> youngs_quasi_static_true = {},
                          youngs_quasi_static_over_alpha = {};  // where a rate factor is known
  std::optional<double> curve_modulus;                          // the job's, beside it
};

// Whether the kinds of data of a job say one thing.
enum class DataAgreement { agrees, cannot_tell, disagrees };

inline const char* word(DataAgreement agreement) {
  constexpr const char* words[] = {"agrees", "cannot tell", "disagrees"};
  return words[static_cast<int>(agreement)];
}

// Of a material with curves and fitted shots: by how much its modulus at the shots' rate exceeds that of its curves, as the data have it
// when the factor is free, beside the job's.
struct ImpliedRateFactor {
  int material = 0;
  Estimate implied = {};
  double given = 1, given_error = 0;  // relative standard deviation
  Estimate modulus_of_depths = {};    // Pa, as given; the interval is its own point where the modulus is held
  double modulus_of_curves = 0;       // Pa, as given
  DataAgreement agreement = DataAgreement::cannot_tell;
};

struct Verdict {
  DataAgreement agreement = DataAgreement::cannot_tell;
  std::vector<std::string> sentences;  // why; and what else no reader may miss
  std::vector<ImpliedRateFactor> rate_factors;
};

struct HypothesisResult {
  int index = 0;  // of CalibrationJob::hypotheses
  Verdict verdict = {};
  std::vector<Minimum> minima;  // best first; parameters: those of the job that are not held
  std::vector<int> parameters;  // job parameter of each fitted one
  std::vector<ProfileInterval> intervals;
  std::optional<Bootstrap> bootstrap;
  std::vector<Combination> combinations;
  std::optional<double> aicc =
      {};  // of the best minimum: comparable among the hypotheses of a job; nothing where data are too few
  std::vector<RidgeMap>
      ridges;  // each fitted modulus over the erosion strain of its material, where that is fitted too
  std::vector<ShotDepth> shots;            // every shot of the job
  std::vector<CurveStresses> curves = {};  // every curve of the job
  std::vector<Deviation> sets;             // by set
  std::vector<FreshRun> fresh;
  std::vector<CrossValidationResult> cross_validations, leave_one_out;
  std::vector<MaterialModuli> moduli;
  std::vector<ErrorBudget> budgets;
  std::vector<Advice> advice;  // what to measure next
  ShotHypothesis for_shots;    // what predictions need of it
  double mesh_error = 0;       // relative: depth on no mesh over depth on the finest, less 1, mean over the shots
  double fresh_deviation = 0;  // mean of |fresh/measured - 1| over the fitted shots
  std::vector<std::string> findings;
};

// The closed form fitted to the same shots, with the same cross-validations: one c, and s of each material.
struct DehnResult {
  std::vector<FreeParameter> parameters;  // "c", and "s of MATERIAL" in Pa
  Minimum minimum;
  std::vector<ProfileInterval> intervals;
  std::vector<ShotDepth> shots;
  std::vector<Deviation> sets;
  std::vector<CrossValidationResult> cross_validations, leave_one_out;
};

// An emulator beside that of spheres' depths.
struct BesideReport {
  EmulatorOf of = {};
  std::string body = {};      // name; empty of spheres
  int runs = 0, without = 0;  // that tell it; of those that were asked, the others
  double mean = 0;            // of what it learns, over those runs
  double noise = 0,
         leave_one_out = 0;  // standard deviations of its logarithm: of one run, and of the emulator's error at one
};

// The emulator of all hypotheses: what it was trained on, its own error.
struct EmulatorReport {
  int runs = 0, reused = 0, foreign = 0;  // done here, taken from the store, of these not of this job's design
  int from_atlas = 0;                     // besides
  std::map<std::string, int> outcomes;    // of its design, by name
  EmulatorSettings settings;
  double leave_one_out = 0, standardised_deviation = 0, coverage95 = 0;
  double error_at_optimum = 0, data_error = 0;  // relative, mean over the fitted shots: why it stopped
  std::string stopped;                          // why no more runs were made
  // After each round: runs so far, CPU seconds so far, error at the optimum.
  struct Round {
    int runs = 0;
    double cpu_seconds = 0, error = 0;
  };
  std::vector<Round> rounds;
  std::vector<BesideReport> beside;  // in the order of EmulatorOf
};

struct CalibrationCost {
  long runs = 0, reused = 0;
  double wall_seconds = 0, cpu_seconds = 0;
  std::optional<double> budget_seconds;
  std::string advice;  // what more time would buy
  std::string instruction_level;
};

struct CalibrationResult {
  EmulatorReport emulator;
  std::vector<HypothesisResult> hypotheses;
  std::optional<DehnResult> dehn;
  std::vector<std::string> findings;  // about the whole
  CalibrationCost cost;
  std::optional<ShotModel> shot_model = {};  // for shots that were not fired; nothing of a job without shots
};

}  // namespace percal
