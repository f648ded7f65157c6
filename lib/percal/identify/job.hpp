// An identification as its TOML file and CSV tables say it: docs/formats/identify.md. Nothing of any material is compiled in.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "percal/material/conventions.hpp"
#include "percal/scaling/trend.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

// A model material of one concentration, with its measured penetration by the model's ball.
struct Formulation {
  double concentration = 0;              // wt%
  double mu_quasi_static = 0;            // Pa, as given
  std::optional<double> mu_high_rate;    // Pa, as given, as the table has it
  double penetration = 0;                // m, mean of the shots
  std::optional<double> penetration_sd;  // m, of single shots
  bool measured = true;                  // its modulus comes from a curve: it counts for the law
};

struct ModelMaterial {
  std::string name;
  double density = 0;              // kg/m3
  double rate_factor = 1;          // high-rate over quasi-static modulus
  std::optional<double> exponent;  // of mu = k c^n; left out: fitted
  std::string table;               // what the published table of formulations is called
  std::string file;                // where they are
  std::vector<Formulation> formulations;
};

struct Tissue {
  std::string name;
  double density = 0;
  double rate_factor = 1;
};

struct Layer {
  double depth = 75;  // in particle radii, for every particle
  double width = 5;   // left out of the job: layer_width.hpp
  bool width_was_chosen = false;
  Bottom bottom = Bottom::free;
};

// A (modulus, erosion strain) pair that gives the calibration's penetration, known from elsewhere.
struct RidgePair {
  double mu = 0;  // Pa, as given
  double erosion_strain = 0;
  std::optional<double> mu_model;  // Pa, the same pair in the model system, as the table has it
};

struct AlphaGiven {
  double alpha;
};
// The least alpha whose depths at the target's pairs are, within one standard error, as close to the measured one as those of
// the best alpha (docs/decisions/0003-alpha-scan.md).
struct AlphaScan {
  std::vector<double> candidates;
  std::string target_name, file;  // of the table of known pairs
  std::vector<RidgePair> target;
  double elements_per_radius = 10;
  int replicates = usual_replicates;
};
using AlphaChoice = std::variant<AlphaGiven, AlphaScan>;

struct RidgeSettings {
  std::vector<double> erosion_strains;
  double start = 0;  // Pa, as given: where the search for the modulus begins
  double elements_per_radius = 10;
  int replicates = usual_replicates;  // of each depth on the way
};

// What a set of predictions is made with: a pair given in the job, or what the chain identified.
struct PairGiven {
  double mu;
  double erosion_strain;
};  // mu in Pa, as given
struct IdentifiedTissue {};
struct IdentifiedModel {};
using PredictionMaterial = std::variant<PairGiven, IdentifiedTissue, IdentifiedModel>;

struct PredictedShot {
  std::string particle;
  double density = 0;               // kg/m3, of the particle
  double radius = 0;                // m
  double speed = 0;                 // m/s
  std::optional<double> measured;   // m
  std::optional<double> reference;  // m, another program's
};

struct PredictionSet {
  std::string system;
  std::string table;  // what the published table of these shots is called; may be empty
  std::vector<PredictedShot> shots;
  PredictionMaterial material;
  double target_density = 0;
  VolumetricChoice volumetric = ChooseBulk{};
  double elements_per_radius = 14;
  int replicates = usual_replicates;
};

// A straight line through two columns of a table, in the table's own units.
struct TrendTable {
  std::string name, x_name, y_name, unit;
  std::vector<double> x, y;       // in the columns' units
  double x_unit = 1, y_unit = 1;  // of one, in SI
  std::vector<double> reference;  // another program's y, in y's unit; empty where there is none
  std::optional<double> reference_slope, reference_intercept;
};

// Depths that the model's shots give for other impacts through their straight line against rho v a.
struct ScaledLine {
  std::string name;
  std::vector<Shot> shots;           // of the model's ball
  std::vector<PredictedShot> cases;  // measured, and reference: what the thesis's own line gave
  std::string shots_table;           // what the published table of the model's shots is called
  std::optional<double> reference_slope, reference_intercept;  // m per kg/(m s), m
  std::optional<double> reference_mean_error;
};

// Depths of shapes of one mass at one speed, each scaled from its own trend by the mass.
struct EqualMass {
  std::string table;  // what the published table is called
  struct Shape {
    std::string name;
    std::string trend;           // name of a [[trends]] entry, or empty for a sphere on the scaled line
    std::optional<double> mass;  // kg, that the trend was measured with; a prism of the same thickness is scaled by it
    double reference = 0;        // m
  };
  double mass = 0;   // kg
  double speed = 0;  // m/s
  std::vector<Shape> shapes;
};

struct IdentifyJob {
  std::string file, text, title;  // text: the whole file
  ModulusConvention convention = ModulusConvention::true_shear;
  StrainMeasure measure = StrainMeasure::engineering;
  ModelMaterial gelatin;
  Tissue tissue;
  ParticleScene calibration;                // shot into the tissue
  double penetration = 0;                   // m, its measured depth
  std::optional<double> penetration_error;  // m, standard error of that
  ParticleScene model;                      // shot into the model material
  Layer layer;
  VolumetricChoice volumetric = ChooseBulk{};
  SolverScene solver;
  AlphaChoice alpha = AlphaGiven{0};
  RidgeSettings ridge;
  double check_elements_per_radius = 14;  // of the finite-element check of the model system
  int check_replicates = usual_replicates;
  std::vector<double> mesh_study;  // elements per radius at which the calibration impact is run again
  std::vector<PredictionSet> predictions;
  std::vector<TrendTable> trends;
  std::optional<ScaledLine> scaled_line;
  std::optional<EqualMass> equal_mass;
  std::string card_name;
  std::vector<std::string> card_comments;

  // What somebody else found, for the comparison only; every entry may be missing.
  std::string reference_name = "reference";
  std::map<std::string, double> reference;  // SI; keys are in docs/formats/identify.md
};

// Reads the job and the tables it names. Throws BadInput for everything that is wrong with them.
IdentifyJob read_identify_job(const std::string& path);

// The keys that [reference] knows, with their dimensions.
struct ReferenceKey {
  std::string key;
  Dimension dimension;
};
const std::vector<ReferenceKey>& reference_keys();

}  // namespace percal
