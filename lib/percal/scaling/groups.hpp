// The ten dimensionless groups of an impact (Guha 2009, Table 3-2), as one table. Each is a product of powers of the
// system's numbers, so one table gives the formula, the value, what is missing for it, and the number that would make
// two systems agree.                                                                        docs/theory/scaling.md
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "percal/scaling/system.hpp"

namespace percal {

enum class GroupKind { geometry, material, response };

struct Factor {
  std::optional<double> System::*member;
  int power;
};

struct Group {
  int number;           // 1 to 10
  std::string symbol;   // "pi4"
  std::string name;     // "inertia over target stiffness"
  std::string formula;  // "rho_t v^2 / mu"
  GroupKind kind;
  std::vector<Factor> factors;
};

std::span<const Group> groups();
const Group& group(int number);

// What the group lacks in this system, by their keys: empty where it can be computed.
std::vector<std::string> missing_for(const Group& group, const System& system);

// The group's value; nullopt where something is missing.
std::optional<double> value(const Group& group, const System& system);

// The number that `member` must be for the group to have this value, all its other numbers taken from `system`.
// nullopt where another one is missing or the member is not in the group.
std::optional<double> solve(const Group& group, double group_value, std::optional<double> System::*member,
                            const System& system);

enum class Agreement { agree, differ, missing };
std::string word(Agreement agreement);

// One group of two systems. `difference` is model/prototype - 1.
struct Comparison {
  const Group* group;
  std::optional<double> prototype, model;
  std::vector<std::string> missing_in_prototype, missing_in_model;
  Agreement agreement = Agreement::missing;
  std::optional<double> difference;
};

// All ten groups. They agree where |difference| <= tolerance.
std::vector<Comparison> compare(const System& prototype, const System& model, double tolerance);

// (rho_t v^2 + 10 mu)/E: the stress that the target can exert over the particle's modulus. What decides whether the
// particle deforms, and with it whether pi3 matters. nullopt where a number is missing.
std::optional<double> particle_compliance(const System& system);

}  // namespace percal
