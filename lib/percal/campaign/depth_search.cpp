#include "percal/campaign/depth_search.hpp"

#include <algorithm>

#include "percal/math/statistics.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {

DepthAnswer answer_of(const Penetration& found) {
  return {.depth = mean(found.depths),
          .censored = found.outcome == Outcome::passed_through,
          .valid = found.outcome == Outcome::stopped || found.outcome == Outcome::passed_through,
          .why = word(found.outcome)};
}

DepthOfModulus one_run_an_answer(Campaign& campaign, std::function<Reduction(double log_value)> reduction,
                                 double& worst_closure) {
  return [&campaign, &worst_closure, reduction = std::move(reduction), answer = 0](double log_value) mutable {
    const Reduction here = reduction(log_value);
    const auto phases = replicates_of(here.problem, usual_replicates);
    const Penetration found =
        summarise({campaign.evaluate(phases[answer++ % usual_replicates])}, here.problem, here.scales);
    worst_closure = std::max(worst_closure, found.worst_closure);
    return answer_of(found);
  };
}

std::vector<Inversion> search_side_by_side(const Campaign& campaign, int count, const char* label,
                                           const std::function<Inversion(int)>& search) {
  std::vector<Inversion> found(count);
  Progress progress(label, count);
  campaign.side_by_side(count, [&](int k) {
    found[k] = search(k);
    progress.add();
  });
  return found;
}

}  // namespace percal
