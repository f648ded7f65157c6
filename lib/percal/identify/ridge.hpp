// The ridge: for each erosion strain the modulus that gives the calibration's penetration.
#pragma once
#include <optional>
#include <vector>

#include "percal/identify/impacts.hpp"
#include "percal/invert/modulus.hpp"

namespace percal {

struct RidgePoint {
  double erosion_strain = 0;
  Inversion inversion;               // in ln of the modulus as given
  double mu = 0;                     // Pa, as given; 0 where nothing was found
  double solver_error = 0;           // relative standard error of mu from the solver's noise
  double data_error = 0;             // relative, from the measured penetration's standard error
  std::optional<RidgePair> known;    // the target's pair with this strain
  std::optional<Shooting> at_known;  // the depth at that pair
};

// One search a strain, side by side on the campaign's threads; every evaluation goes to the store.
std::vector<RidgePoint> find_ridge(Campaign& campaign, const IdentifyJob& job, double alpha);

// The erosion strain at which the ridge has this modulus, linear in ln mu between its points; nullopt outside of the ridge.
struct StrainOnRidge {
  double strain = 0;
  double error = 0;  // from the ridge's errors
};
std::optional<StrainOnRidge> strain_at(const std::vector<RidgePoint>& ridge, double mu);

}  // namespace percal
