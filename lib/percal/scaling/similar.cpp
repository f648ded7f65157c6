#include "percal/scaling/similar.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "percal/base/error.hpp"

namespace percal {
namespace {

using Member = std::optional<double> System::*;

double ratio(Member member, const System& from, const System& to) {
  return required(to, member) / required(from, member);
}

// The numbers that a group may be solved for. E, the penetration, the strain rate and the time stand in one group each:
// they never decide anything else.
bool may_give(const Group& group, Member member) {
  switch (group.number) {
    case 3: return member == &System::particle_modulus;
    case 8: return member == &System::penetration;
    case 9: return member == &System::strain_rate;
    case 10: return member == &System::time;
    default: return true;
  }
}

// What similarity asks for before the response: every group but pi3 (a rigid particle) and pi8 to pi10.
bool is_demanded(const Group& group) { return group.kind != GroupKind::response && group.number != 3; }

std::vector<const SystemQuantity*> missing_numbers(const Group& group, const System& system) {
  std::vector<const SystemQuantity*> missing;
  for (const auto& factor : group.factors)
    if (!(system.*factor.member)) missing.push_back(&system_quantity(factor.member));
  return missing;
}

}  // namespace

double length_ratio(const System& from, const System& to) { return ratio(&System::radius, from, to); }

double modulus_ratio(const System& from, const System& to) {
  double speeds = ratio(&System::speed, from, to);
  return ratio(&System::target_density, from, to) * speeds * speeds;
}

double map_penetration(double penetration, const System& from, const System& to) {
  return penetration * length_ratio(from, to);
}

double map_modulus(double mu, const System& from, const System& to) { return mu * modulus_ratio(from, to); }

double map_time(double time, const System& from, const System& to) {
  return time * length_ratio(from, to) / ratio(&System::speed, from, to);
}

Completion complete(const System& prototype, const System& given) {
  Completion completion{.model = given, .derived = {}, .conflicts = {}, .gaps = {}};
  auto& model = completion.model;

  constexpr std::array order = {1, 2, 5, 6, 7, 4, 3, 8, 9, 10};
  for (bool found = true; found;) {
    found = false;
    for (int number : order) {
      const auto& one = group(number);
      auto wanted = value(one, prototype);
      auto missing = missing_numbers(one, model);
      if (!wanted || missing.size() != 1 || !may_give(one, missing[0]->member)) continue;
      model.*missing[0]->member = solve(one, *wanted, missing[0]->member, model);
      completion.derived.push_back({missing[0], *(model.*missing[0]->member), &one});
      found = true;
    }
  }

  for (const auto& compared : compare(prototype, model, exact_agreement)) {
    const auto& one = *compared.group;
    if (!compared.prototype || !is_demanded(one)) continue;
    if (!compared.model) {
      completion.gaps.push_back({&one, missing_numbers(one, model)});
    } else if (compared.agreement == Agreement::differ) {
      Conflict conflict{&one, *compared.prototype, *compared.model, {}};
      for (const auto& factor : one.factors)
        if (given.*factor.member)
          conflict.instead.push_back(
              {&system_quantity(factor.member), *solve(one, *compared.prototype, factor.member, model), &one});
      completion.conflicts.push_back(conflict);
    }
  }
  return completion;
}

std::string describe(const Conflict& conflict) {
  std::string text = conflict.group->symbol + " = " + conflict.group->formula +
                     " is over-determined: " + format_quantity(conflict.model, dimension::none) +
                     " from the model's own numbers, " + format_quantity(conflict.prototype, dimension::none) +
                     " in the prototype; leave out";
  for (std::size_t i = 0; i < conflict.instead.size(); ++i) {
    const auto& one = conflict.instead[i];
    text += (i ? ", or " : " ") + one.quantity->key + " (it would be " +
            format_quantity(one.value, one.quantity->dimension, 6) + ")";
  }
  return text;
}

std::string describe(const Gap& gap) {
  std::string text = gap.group->symbol + " = " + gap.group->formula + " does not settle the model: ";
  for (std::size_t i = 0; i < gap.missing.size(); ++i) text += (i ? " and " : "") + gap.missing[i]->key;
  return text + (gap.missing.size() == 1 ? " is missing" : " are missing; give one of them");
}

void require_similar(const Completion& completion, const std::string& file) {
  std::string faults;
  for (const auto& gap : completion.gaps) faults += "\n  " + describe(gap);
  for (const auto& conflict : completion.conflicts) faults += "\n  " + describe(conflict);
  if (!faults.empty()) throw BadInput(file + ": " + title(completion.model) + " cannot be made similar:" + faults);
}

}  // namespace percal
