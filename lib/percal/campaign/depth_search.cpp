#include "percal/campaign/depth_search.hpp"

#include "percal/math/statistics.hpp"

namespace percal {

DepthAnswer answer_of(const Penetration& found) {
  return {.depth = mean(found.depths),
          .censored = found.outcome == Outcome::passed_through,
          .valid = found.outcome == Outcome::stopped || found.outcome == Outcome::passed_through,
          .why = word(found.outcome)};
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
