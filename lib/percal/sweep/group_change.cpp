#include "percal/sweep/group_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "percal/base/error.hpp"
#include "percal/scaling/similar_scene.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

// A number of the system that may be changed, its key in scenes, and its unit there.
struct SceneNumber {
  std::optional<double> System::*member;
  const char* key;
  const char* unit;
};
constexpr std::array<SceneNumber, 9> scene_numbers{{{&System::depth, "target.depth", " m"},
                                                    {&System::width, "target.width", " m"},
                                                    {&System::particle_modulus, "particle.youngs_modulus", " Pa"},
                                                    {&System::mu, "target.mu", " Pa"},
                                                    {&System::particle_density, "particle.density", " kg/m3"},
                                                    {&System::alpha, "target.alpha", ""},
                                                    {&System::erosion_strain, "target.erosion.strain", ""},
                                                    {&System::speed, "particle.speed", " m/s"},
                                                    {&System::target_density, "target.density", " kg/m3"}}};

// The usual one of a group is the first of these that it has; of pi5 the particle's density, of pi3 the particle's modulus.
const SceneNumber* usual_number(const Group& group) {
  const auto has = [&](const SceneNumber& number) {
    return std::ranges::any_of(group.factors, [&](const Factor& factor) { return factor.member == number.member; });
  };
  const auto found = std::ranges::find_if(scene_numbers, has);
  return found == scene_numbers.end() ? nullptr : &*found;
}

const SceneNumber& number_of(const GroupChange& change) {
  return *std::ranges::find(scene_numbers, change.changed, &SceneNumber::member);
}

bool may_be_swept(const Group& group) { return group.kind != GroupKind::response && usual_number(group); }

int rank(const GroupChange& change) {
  constexpr std::array order{6, 5, 1, 2, 7, 4, 3};
  return static_cast<int>(std::ranges::find(order, change.group) - order.begin());
}

// The number as a scene says it: a modulus by the scene's convention, a strain in its measure.
double as_the_scene_says(double number, const GroupChange& change, const SystemInput& system) {
  if (change.changed == &System::mu) return modulus_as_given(number, *system.system.alpha, system.convention);
  if (change.changed == &System::erosion_strain && system.measure != StrainMeasure::engineering)
    return strain_at(stretch_at(number, StrainMeasure::engineering), system.measure);
  return number;
}

}  // namespace

std::optional<GroupChange> group_named(const std::string& word) {
  std::string name = lower_case(word);
  std::ranges::replace(name, '_', ' ');
  for (const Group& group : groups())
    if ((name == group.symbol || name == group.name) && may_be_swept(group))
      return GroupChange{group.number, usual_number(group)->member};
  return std::nullopt;
}

std::optional<GroupChange> changing(const GroupChange& change, const std::string& quantity) {
  for (const Factor& factor : group(change.group).factors)
    for (const SceneNumber& number : scene_numbers)
      if (factor.member == number.member && system_quantity(factor.member).key == quantity)
        return GroupChange{change.group, factor.member};
  return std::nullopt;
}

std::vector<std::string> groups_in_words() {
  std::vector<std::string> words;
  for (const Group& one : groups())
    if (may_be_swept(one)) words.push_back(fmt::format("{} ({}, {})", one.symbol, one.name, one.formula));
  return words;
}

std::vector<std::string> changes_of(const GroupChange& change) {
  std::vector<std::string> keys;
  for (const Factor& factor : group(change.group).factors)
    if (const auto& key = system_quantity(factor.member).key; changing(change, key)) keys.push_back(key);
  return keys;
}

std::string changed_key(const GroupChange& change) { return number_of(change).key; }

TomlEdit edit_for(const GroupChange& change, double value, const Scene& scene) {
  const SystemInput system = system_of(scene);
  const auto number = solve(group(change.group), value, change.changed, system.system);
  if (!number) {
    auto missing = missing_for(group(change.group), system.system);
    std::erase(missing, system_quantity(change.changed).key);
    throw BadInput(Place{scene.source, 0, group(change.group).symbol}, "a scene without " + listed(missing),
                   "a scene that has what the group takes: " + group(change.group).formula);
  }
  const double said = as_the_scene_says(*number, change, system);
  const SceneNumber& of_scene = number_of(change);
  if (of_scene.unit[0] == '\0') return {of_scene.key, said};
  return {of_scene.key, fmt::format("{}{}", said, of_scene.unit)};
}

std::optional<double> value_in(const GroupChange& change, const Scene& scene) {
  return value(group(change.group), system_of(scene).system);
}

bool goes_before(const GroupChange& a, const GroupChange& b) { return rank(a) < rank(b); }

}  // namespace percal
