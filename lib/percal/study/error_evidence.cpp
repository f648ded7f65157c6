#include "percal/study/error_evidence.hpp"

#include <algorithm>

#include "percal/base/error.hpp"
#include "percal/base/progress.hpp"
#include "percal/study/extrapolation.hpp"
#include "percal/study/measured_effects.hpp"

namespace percal {

void check_errors_asked_for(const ErrorsAskedFor& asked, const Scene& scene) {
  if (asked.measured && scene.replicates < 2)
    throw BadInput(Place{.file = scene.source, .line = 0, .key = "--measure-errors"}, "one replicate",
                   "two or more: the differences need a scatter");
  if (asked.extrapolated) need_a_limit(scene);
}

ErrorEvidence error_evidence(const ErrorsAskedFor& asked, const Scene& scene, const Reduction& reduction,
                             const std::vector<Evaluation>& replicates, const Penetration& penetration,
                             Campaign& campaign) {
  ErrorEvidence evidence;
  if (!penetration.depth || scene.replicates < 2) return evidence;
  if (asked.measured) {
    Progress progress("errors", effect_runs(scene.replicates));
    evidence.effects = measured_effects(reduction, replicates, campaign, &progress);
    for (const DepthErrorSource source : measured_sources)
      if (std::ranges::find(evidence.effects, source, &MeasuredEffect::source) == evidence.effects.end())
        evidence.notes.push_back("the error of the " + word(source) +
                                 " goes by rule: a better setting did not stop in every run");
  }
  if (asked.extrapolated) {
    Progress progress("finer mesh", scene.replicates);
    evidence.extrapolation = extrapolated(scene, penetration, campaign, &progress);
    if (!evidence.extrapolation)
      evidence.notes.push_back("not extrapolated: on the finer mesh the particle did not stop in every run");
  }
  return evidence;
}

}  // namespace percal
