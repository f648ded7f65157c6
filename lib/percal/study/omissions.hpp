// What the omissions of a scene are worth: the scene as it is, then once with each of them switched back on, and what that
// changes in depth and in time.
#pragma once
#include <functional>

#include "percal/study/error_vs_time.hpp"
#include "percal/study/omission_variants.hpp"

namespace percal {

// The replicates of each problem, as Campaign::replicate gives them.
using Replicator = std::function<std::vector<std::vector<Evaluation>>(const std::vector<Problem>&, int replicates)>;

// none: below two standard errors; possible: below three, which among some two dozen comparisons chance reaches now and
// then; clear: three or more; ends_otherwise: one of the two did not stop, and there is no change to give.
enum class Effect { none, possible, clear, ends_otherwise };
std::string word(Effect effect);

struct AuditedOmission {
  OmissionVariant variant;
  Rung rung;
  Change change;  // from the baseline
  Effect effect;
  std::string verdict;  // in words
};

// An omission that the program decided on, with the variants that audit it.
struct AuditedLeftOut {
  LeftOut left_out;
  std::vector<std::string> audited_by;
  std::string why_not;  // where there are none
};

struct Omissions {
  Reduction reduction;  // of the baseline
  Rung baseline;
  double spread_of_a_run = 0;              // over the depth, of all that stopped
  std::vector<AuditedLeftOut> left_out;    // the program's own list
  std::vector<AuditedOmission> omissions;  // the largest effect first, those that end otherwise before all
  std::vector<SkippedVariant> skipped;
  std::vector<std::string> conclusions;
};

inline constexpr int audit_replicates = usual_replicates;

// The standard error of a change is that of the difference of two means, at least what the spread of a run pooled over all
// scenes makes it.
Omissions audit_omissions(const Scene& scene, int replicates, const Replicator& evaluate);

}  // namespace percal
