// What a calibration says to the particles of a job, and how much of a powder lies beyond what it knows.
#pragma once
#include <string>
#include <vector>

#include "percal/powder/dose.hpp"
#include "percal/powder/job.hpp"
#include "percal/predict/predictor.hpp"

namespace percal {

struct PowderModel {
  const ShotModel* calibration = nullptr;
  int hypothesis = 0, material = 0;
  Predictor predictor;
  ForwardModel forward;
  DoseQuestion question;
  double width_in_radii = 0;  // of the layer

  const ShotHypothesis& of_hypothesis() const { return calibration->hypotheses[hypothesis]; }
  SphereShot shot_of(const PowderParticle& particle) const;
};

// Keeps a pointer to the calibration. Throws BadInput for names that it does not know, for layers and a band that go beyond its depth.
PowderModel powder_model(const PowderJob& job, const ShotModel& calibration);

// How much of a powder lies beyond what the calibration has seen, by one number.
struct BeyondFitted {
  std::string number;  // "radius", "density", "speed", "depth", "emulator's runs"
  Dimension dimension;
  Between fitted;  // range of the fitted shots; of the emulator's runs: none
  double by_number = 0, by_mass = 0;
};
// Those of which some of the powder does.
std::vector<BeyondFitted> beyond_fitted(const std::vector<ParticleClass>& classes, const PowderModel& model);

// Sentences that hold for any powder by this calibration, then those on what lies beyond.
std::vector<std::string> model_findings(const PowderJob& job, const PowderModel& model,
                                        const std::vector<BeyondFitted>& beyond);

}  // namespace percal
