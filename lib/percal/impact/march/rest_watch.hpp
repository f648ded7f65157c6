// When a particle past its deepest point, or past the target, has come to rest or has left.
// docs/theory/field_measures.md
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "percal/impact/result.hpp"
#include "percal/impact/settings.hpp"

namespace percal {

// What the watch sees of the particle at the end of a step.
struct ParticlePlace {
  double time, tip, top, speed;  // downwards, but for the time
};

class RestWatch {
 public:
  // The deepest tip position, at this time; the target's lower face is at `floor`.
  void begin(double time, double depth, double floor) {
    begin_ = time;
    depth_ = depth;
    floor_ = floor;
    swings_ = {{depth, depth}};
  }
  // Asked after every step from then on; nothing while the particle neither rests nor has left.
  std::optional<Ending> look(const ParticlePlace& now) {
    if (flies_free(now)) return now.speed < 0 ? Ending::left_upwards : Ending::passed_through;
    if (note(now) && now.time > 2 * begin_ && swing(now.time).width() <= rest_swing * depth_) return Ending::rests;
    return std::nullopt;
  }

  // Where the tip was in the last half of the run's time, as far as that is watched.
  struct Swing {
    double high = HUGE_VAL, low = -HUGE_VAL;  // smallest and largest depth
    double middle() const { return (high + low) / 2; }
    double width() const { return low - high; }
  };
  Swing swing(double time) const {
    Swing all;
    for (std::size_t k = place_of(std::max(begin_, time / 2)); k < swings_.size(); ++k) {
      all.high = std::min(all.high, swings_[k].high);
      all.low = std::max(all.low, swings_[k].low);
    }
    return all;
  }

  // How it ended, at this place; the rest is the run's.
  Aftermath aftermath(Ending ending, const ParticlePlace& now, const ImpactResult& run) const {
    const Swing last = swing(now.time);
    const bool has_left =
        ending == Ending::left_upwards || ending == Ending::ricochets || ending == Ending::passed_through;
    return {.ending = ending,
            .reason = run.reason,
            .depth = has_left ? now.tip : last.middle(),
            .half_width = has_left ? 0 : last.width() / 2,
            .time = now.time,
            .speed = now.speed,
            .eroded = run.eroded,
            .energy = run.energy};
  }

 private:
  std::size_t place_of(double time) const { return static_cast<std::size_t>((time - begin_) / rest_interval); }

  // Whether this is the first look of a new interval.
  bool note(const ParticlePlace& now) {
    const std::size_t known = swings_.size();
    swings_.resize(std::max(known, place_of(now.time) + 1));
    swings_.back().high = std::min(swings_.back().high, now.tip);
    swings_.back().low = std::max(swings_.back().low, now.tip);
    return swings_.size() > known;
  }

  // Above or below the target, and as fast as it was its own height ago.
  bool flies_free(const ParticlePlace& now) {
    const bool is_outside = (now.tip <= 0 && now.speed < 0) || (now.tip >= floor_ && now.speed > 0);
    if (!is_outside || !free_since_ || std::abs(now.speed - free_since_->speed) > free_speed_change) free_since_ = now;
    if (!is_outside) free_since_.reset();
    return free_since_ && std::abs(now.tip - free_since_->tip) >= now.tip - now.top;
  }

  double begin_ = 0, depth_ = 0, floor_ = 0;
  std::vector<Swing> swings_;  // one for each rest_interval since the beginning; of one without a step: empty
  std::optional<ParticlePlace> free_since_;
};

}  // namespace percal
