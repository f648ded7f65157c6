// The whole chain of an identification and what it found.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/card/card_material.hpp"
#include "percal/identify/alpha_scan.hpp"
#include "percal/identify/comparison.hpp"
#include "percal/identify/job.hpp"
#include "percal/identify/ridge.hpp"
#include "percal/material/gelatin.hpp"
#include "percal/scaling/similar.hpp"

namespace percal {

// The concentration law and the high-rate modulus of each formulation: the table's where a curve was measured, the law's
// elsewhere.
struct GelatinFinding {
  GelatinLaw law;
  std::vector<double> high_rate;  // Pa, as given, by formulation
};

// The model system that is similar to the calibration impact, and the formulation that comes closest to it.
struct SimilarityFinding {
  System prototype, model;   // completed
  double modulus_ratio = 0;  // model over prototype
  double penetration = 0;    // m, that the model system should have
  int formulation = 0;       // index of the one whose measured depth is nearest
  double mismatch = 0;       // its depth over that, less 1
};

struct TissueFinding {
  double mu = 0;                         // Pa, high rate, as given
  std::optional<StrainOnRidge> erosion;  // not there where the ridge does not reach this modulus
  double mu_quasi_static = 0;            // Pa, as given
  double youngs_quasi_static = 0;        // Pa, 3 mu
};

struct PredictionResult {
  const PredictionSet* set;
  std::vector<Shooting> shots;  // as set->shots
  std::optional<double> mean_deviation_from_measured, mean_deviation_from_reference;
};

struct Identification {
  GelatinFinding gelatin;
  double alpha = 0;
  std::optional<AlphaFinding> alpha_scan;
  std::vector<RidgePoint> ridge;
  SimilarityFinding similarity;
  TissueFinding tissue;
  std::optional<Shooting> model_check;  // not there without an erosion strain
  std::vector<Shooting> mesh_study;     // as job.mesh_study
  std::vector<PredictionResult> predictions;
  std::optional<CardMaterial> card;
  std::vector<ComparedNumbers> steps;   // one for each step of the chain, in order
  std::vector<ComparedNumbers> tables;  // published tables recomputed
  std::vector<std::string> findings;    // what a reader must know, in sentences

  // Every step of the chain could be taken.
  bool complete() const { return tissue.erosion.has_value(); }
};

// The calibration shot at the identified pair of a complete identification, on the mesh and with the replicates of the ridge: the
// erosion strain holds for that element size.
Scene identified_scene(const IdentifyJob& job, const Identification& found);

// The job outlives the result. Steps are announced to `announce` (may be empty) as they finish.
Identification identify(const IdentifyJob& job, Campaign& campaign,
                        const std::function<void(const ComparedNumbers&)>& announce);

}  // namespace percal
