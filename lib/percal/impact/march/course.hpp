// How a run goes on and how it ends: at the deepest point or the lower face, or past them, where what the run says up to there is put
// aside. The same for every march.     docs/theory/impact.md, "Time"; docs/theory/field_measures.md
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "percal/impact/march/rest_watch.hpp"
#include "percal/impact/result.hpp"
#include "percal/impact/settings.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

class Course {
 public:
  explicit Course(const Problem& problem) : problem_(problem) { result_.smallest_step = 1; }

  ImpactResult& result() { return result_; }

  // What a march knows at the beginning of a step.
  struct Sight {
    ParticlePlace place;
    bool is_finite;         // forces and works
    double steps_in_first;  // of the stable step now, in the first
    std::string failure;    // why the run cannot go on, in words; else empty
  };

  bool has_ended(const Sight& now) {
    if (!at_deepest_) result_.depth = std::max(result_.depth, now.place.tip);
    if (!now.is_finite) return end(Outcome::unstable, "a force is not finite");
    if (!now.failure.empty()) return end(Outcome::unstable, now.failure);
    if (now.steps_in_first * collapsed_step > 1) return end(Outcome::time_up, "the time step collapsed");
    if (std::abs(now.place.speed) > 10 * problem_.speed_factor)
      return end(Outcome::unstable, "the particle is ten times faster than at impact");
    if (result_.steps >= most_steps) return end(Outcome::time_up, "");
    const bool is_late = now.place.time >= problem_.end_time;
    if (at_deepest_) return rests_or_has_left(now.place) || (is_late && end(Outcome::time_up, ""));
    if (now.place.speed <= 0) return end(Outcome::stopped, "");
    if (now.place.tip >= problem_.whole_depth()) return end(Outcome::passed_through, "");
    return is_late && end(Outcome::time_up, "");
  }

  // Past the deepest point, or out of the target where it is free below. said_here() is the result with its stock taken.
  template <class SaidHere>
  bool goes_on(const SaidHere& said_here) {
    const bool passes = result_.outcome == Outcome::passed_through, rests = result_.outcome == Outcome::stopped;
    if (at_deepest_ ||
        !((problem_.until != RunUntil::deepest && passes) || (problem_.until == RunUntil::rest && rests)))
      return false;
    auto [here, time] = said_here();
    if (here.outcome == Outcome::unstable) return false;
    at_deepest_ = std::move(here);
    rest_watch_.begin(time, result_.depth, problem_.whole_depth());
    if (passes && problem_.bottom == Bottom::fixed) ending_ = Ending::passed_through;
    return !ending_;
  }

  bool end(Outcome outcome, const std::string& reason) {
    result_.outcome = outcome;
    result_.reason = reason;
    return true;
  }

  // Energies have been taken stock of: false for a ledger that does not close, and for NaN.
  void judge_energy() {
    const bool closes = std::abs(result_.energy.closure()) <= tolerated_energy_error;
    if (result_.outcome != Outcome::unstable && !closes) end(Outcome::unstable, "energy was not conserved");
  }

  // What was put aside, with what came after; or all there is.
  ImpactResult finished(const ParticlePlace& now) {
    if (!at_deepest_) return std::move(result_);
    Ending ending = ending_.value_or(Ending::time_up);
    if (ending == Ending::left_upwards && problem_.block.angle != 0) ending = Ending::ricochets;
    if (result_.outcome == Outcome::unstable) ending = Ending::unstable;
    ImpactResult deepest = std::move(*at_deepest_);
    deepest.aftermath = rest_watch_.aftermath(ending, now, result_);
    deepest.steps = result_.steps;
    deepest.element_steps = result_.element_steps;
    deepest.helper_cpu_seconds = result_.helper_cpu_seconds;
    deepest.history = result_.history;
    deepest.channel = result_.channel;
    return deepest;
  }

 private:
  bool rests_or_has_left(const ParticlePlace& now) {
    ending_ = rest_watch_.look(now);
    if (problem_.until == RunUntil::passage && now.speed <= 0) ending_ = Ending::rests;
    return ending_.has_value();
  }

  const Problem& problem_;
  ImpactResult result_;
  RestWatch rest_watch_;
  std::optional<ImpactResult> at_deepest_;  // where the run goes on past it
  std::optional<Ending> ending_;            // then
};

}  // namespace percal
