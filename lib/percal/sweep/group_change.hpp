// Dimensionless groups as something to sweep: which number of the scene is changed for one. docs/formats/campaign.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/scaling/groups.hpp"
#include "percal/scene/scene.hpp"
#include "percal/text/toml_edits.hpp"

namespace percal {

struct GroupChange {
  int group = 0;                                     // its number
  std::optional<double> System::*changed = nullptr;  // what is solved for
};

// "pi4", or by its name, "density ratio" or "density_ratio". Nothing for words that are none, and for what a run responds with
// (pi8 to pi10).
std::optional<GroupChange> group_named(const std::string& word);

// With another number changed for it, by its key in systems: "speed". Nothing where the group has none of that name that may be.
std::optional<GroupChange> changing(const GroupChange& group, const std::string& quantity);

// "pi4 (inertia over target stiffness, rho_t v^2 / mu)" of every group.
std::vector<std::string> groups_in_words();
// The keys of the numbers that may be changed for it.
std::vector<std::string> changes_of(const GroupChange& group);

// The key of the scene that is changed: "target.mu".
std::string changed_key(const GroupChange& group);

// What the scene is to say for the group to have this value, all its other numbers as they are. Throws BadInput where the scene lacks one.
TomlEdit edit_for(const GroupChange& group, double value, const Scene& scene);

// The group's value in a scene, as percal scale has it.
std::optional<double> value_in(const GroupChange& group, const Scene& scene);

// What is changed first to last, so that each finds what it needs: alpha and densities before moduli and speeds.
bool goes_before(const GroupChange& a, const GroupChange& b);

}  // namespace percal
