// The plan of percal campaign: a scene, and what is changed in it from point to point. docs/formats/campaign.md
#pragma once
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/sweep/group_change.hpp"
#include "percal/text/toml.hpp"

namespace percal {

inline constexpr int most_plan_points = 100'000;  // of a plan

// One thing that is changed.
struct SweepAxis {
  std::string key;                        // as the plan names it: "particle.speed", "below[1].mu", "pi4"
  std::optional<GroupChange> group = {};  // of a dimensionless group; else the key is one of the scene
  std::string unit = "";                  // of `number` below; empty: none
  bool is_number = true;                  // else its values are words, or true and false
  Place place = {};                       // where the plan says so

  std::string column() const { return unit.empty() ? key : key + " [" + unit + "]"; }
};

struct SweptValue {
  TomlScalar given;     // as the scene's reader is to see it: "83 m/s"
  double number = NAN;  // in the axis' unit; NaN of a word
};

struct PlanPoint {
  std::vector<SweptValue> values;  // one an axis
  Place place = {};                // a row of the list; else no line
};

enum class Design { grid, sobol };
std::string word(Design design);

struct Plan {
  std::string file, text;              // the plan as it stands
  std::string scene_file = "";         // that its scene is in; the plan itself where it has one
  std::string scene_text = "";         // of that file
  bool scene_is_inside = false;        // its scene is the plan's own table
  std::string list_file = "";          // empty: none
  std::optional<int> replicates = {};  // in place of the scene's
  Design design = Design::grid;
  std::vector<SweepAxis> axes = {};
  std::vector<PlanPoint> points = {};
};

// Throws BadInput. Values are only looked at as far as the plan goes: scenes are made by scene_at().
Plan read_plan(const std::string& path);

}  // namespace percal
