// Values carried from one system to a similar one, and a partly known model completed so that all groups agree.
//                                                            Guha 2009, Eq. 3-1, 4-1 and the relations after Table 3-2
#pragma once
#include <string>
#include <vector>

#include "percal/scaling/groups.hpp"
#include "percal/scaling/system.hpp"

namespace percal {

// Each takes `from`'s numbers to `to`; both systems need the numbers that the formula names, and BadInput says which
// one is missing. The first argument is the value in `from`, the result its counterpart in `to`.
double length_ratio(const System& from, const System& to);   // S_L = a_to / a_from        Eq. 3-1
double modulus_ratio(const System& from, const System& to);  // (rho_t v^2)_to / (rho_t v^2)_from  Eq. 4-1
double map_penetration(double penetration, const System& from, const System& to);  // times S_L (pi8)
double map_modulus(double mu, const System& from, const System& to);               // times modulus_ratio (pi4)
double map_time(double time, const System& from, const System& to);                // times (a/v)_to / (a/v)_from (pi10)

// A number of the model that followed from the prototype, and the group that it followed from.
struct Derived {
  const SystemQuantity* quantity;
  double value;
  const Group* because;
};

// A group that the model's given numbers contradict: it is over-determined. `instead` has, for each number of the
// group that was given, what it would have to be.
struct Conflict {
  const Group* group;
  double prototype, model;  // the group's two values
  std::vector<Derived> instead;
};

// A demanded group that the prototype has and the model has too few numbers for: one more of `missing` may settle it.
struct Gap {
  const Group* group;
  std::vector<const SystemQuantity*> missing;
};

struct Completion {
  System model;
  std::vector<Derived> derived;
  std::vector<Conflict> conflicts;
  std::vector<Gap> gaps;
};

// Two groups are one number where they agree to this.
inline constexpr double exact_agreement = 1e-12;

// Fills in the model's missing numbers group by group, each where one number is missing. The density ratio goes before
// pi4. Similarity demands pi1, pi2 and pi4 to pi7. pi3 and the response groups (pi8 to pi10) only give what belongs
// to them alone - the particle's modulus, the penetration, the strain rate, the time - and make neither conflicts nor
// gaps.
Completion complete(const System& prototype, const System& model);

// One line each, for messages.
std::string describe(const Conflict& conflict);
std::string describe(const Gap& gap);

// Throws BadInput that lists all gaps and conflicts: an exactly similar system has none. `file` is the job's, for the
// message.
void require_similar(const Completion& completion, const std::string& file);

}  // namespace percal
