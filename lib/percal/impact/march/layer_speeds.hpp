// The particle's speed when its tip crosses the undeformed lower faces of the layers.     docs/theory/field_measures.md (1)
#pragma once
#include <vector>

#include "percal/problem/problem.hpp"

namespace percal {

// Velocities belong to the middles of steps, and to the end of the run once they have been brought there; between two of them the
// speed is taken as linear in time, as the tip is within a step.
class LayerSpeeds {
 public:
  explicit LayerSpeeds(const Problem& problem) : faces_(problem.lower_faces()), before_{0, problem.speed_factor} {}

  // A step of length `drift` has ended at `time`; the particle moved at this speed.
  void moved(double time, double drift, double tip_before, double tip, double speed) {
    for (; next_ < faces_.size() && tip >= faces_[next_]; ++next_)
      crossed_.push_back(time - drift * (tip - faces_[next_]) / (tip - tip_before));
    resolve({time - 0.5 * drift, speed});
  }

  // Of every face crossed so far; `speed` is that of this time.
  std::vector<double> at_the_end(double time, double speed) {
    resolve({time, speed});
    return speeds_;
  }

 private:
  struct Sample {
    double time, speed;
  };

  // All crossings up to this sample lie between it and the one before.
  void resolve(const Sample& now) {
    const double span = now.time - before_.time;
    while (speeds_.size() < crossed_.size() && crossed_[speeds_.size()] <= now.time) {
      const double share = span > 0 ? (crossed_[speeds_.size()] - before_.time) / span : 1;
      speeds_.push_back(before_.speed + share * (now.speed - before_.speed));
    }
    before_ = now;
  }

  const std::vector<double> faces_;        // depths
  std::vector<double> crossed_, speeds_;  // times, speeds
  std::size_t next_ = 0;                  // face
  Sample before_;
};

}  // namespace percal
