// Numbers of a run that can be measured of a shot, and what emulators learn of them: the deepest depth itself, every other one by an
// emulator of its own beside it.                                                    docs/theory/emulator.md, Numbers beside the depth
#pragma once
#include <compare>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "percal/impact/result.hpp"
#include "percal/invert/emulator.hpp"
#include "percal/problem/problem.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

// In the order of run_number_kinds.
enum class RunNumber { depth, final_depth, half_speed_depth, channel_radius };

struct RunNumberKind {
  const char* key;      // in results
  const char* words;    // what was measured
  const char* learnt;   // what its emulator learns
  bool over_depth;      // that is a share of the deepest depth; else of the radius
  const char* caution;  // what a reader of it must know, a sentence with a blank before it
  // Adds to what a scene's run is to tell; whether the run of a problem was asked for it.
  void (*ask)(OutputScene& output);
  bool (*asked)(const Problem& problem);
  // ln of what is learnt; nothing of a run that does not tell it.
  std::optional<double> (*log_of)(const ImpactResult& result);
};

const RunNumberKind& kind_of(RunNumber number);
// The number of that key; nothing where there is none.
std::optional<RunNumber> run_number_of(const std::string& key);
// All but the depth.
inline constexpr RunNumber numbers_beside[] = {RunNumber::final_depth, RunNumber::half_speed_depth,
                                               RunNumber::channel_radius};

// What an emulator is of: a number of the runs of one body, 0: of spheres.
struct EmulatorOf {
  int body = 0;
  RunNumber number = RunNumber::depth;
  auto operator<=>(const EmulatorOf&) const = default;
};

// Of each body that was shot an emulator of the depth (invert/reach.hpp) and those beside it.
struct Emulators {
  Emulators() = default;
  Emulators(Emulator of_depth) { of.emplace(EmulatorOf{}, std::move(of_depth)); }  // implicit: one of spheres' depths

  std::map<EmulatorOf, Emulator> of;

  const Emulator& depth(int body = 0) const { return of.at({body, RunNumber::depth}); }
  bool knows(const EmulatorOf& one) const { return of.contains(one); }
  // ln(number/radius) of the i-th at the i-th point, which it must know. As Emulator::depth. Emulators of two bodies err independently.
  //                                                                                                                       (13)
  DepthAnswers answers(const std::vector<SphereInputs>& at, const std::vector<EmulatorOf>& wanted, double h,
                       bool with_covariance) const;
  // Of one run on a mesh of element size h: standard deviation of ln number.
  double noise(const EmulatorOf& one, double h) const;
};

}  // namespace percal
