// What the stiffness of contact changes: docs/verification/contact.md has a table of what this prints.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/math/statistics.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

struct Contact {
  std::vector<double> depths;
  double dropped = 0, viscosity = 0;  // means
  double largest_gap = 0, worst_closure = 0;
  double depth() const { return mean(depths); }
};

Contact contact_at(int elements_per_radius, double kappa, int replicates) {
  Problem p = setting_s(elements_per_radius);
  p.contact_stiffness = kappa;
  Contact contact;
  for (int k = 0; k < replicates; ++k) {
    p.speed_factor = replicate_speed_factor(k);
    const ImpactResult run = run_impact(p);
    EXPECT_EQ(run.outcome, Outcome::stopped);
    contact.depths.push_back(run.depth);
    contact.dropped += run.energy.contact_dropped / replicates;
    contact.viscosity += run.energy.viscosity / replicates;
    contact.largest_gap = std::max(contact.largest_gap, run.largest_gap);
    contact.worst_closure = std::max(contact.worst_closure, std::abs(run.energy.closure()));
  }
  EXPECT_LT(contact.worst_closure, 0.01) << kappa;
  std::printf("| %d | %.2f | %.2f ± %.2f | %.3f | %.3f | %.2f | %.1e |\n", elements_per_radius, kappa, contact.depth(),
              sample_deviation(contact.depths) / std::sqrt(replicates), contact.dropped, contact.viscosity,
              contact.largest_gap, contact.worst_closure);
  return contact;
}

// Over a sixteenfold range of stiffness: springs hold less, nodes overlap less, and the depth moves by less than a tenth.
TEST(SlowContact, AQuarterAndFourTimesTheStiffnessMoveTheDepthByLessThanATenth) {
  Contact default_at[2];
  int mesh = 0;
  for (const int elements : {7, 14}) {
    const Contact soft = contact_at(elements, 0.15, 5), middle = contact_at(elements, 0.6, 5),
                  stiff = contact_at(elements, 2.4, 5);
    EXPECT_LT(middle.dropped, 0.6 * soft.dropped);
    EXPECT_LT(stiff.dropped, 0.6 * middle.dropped);
    EXPECT_LT(middle.largest_gap, 0.8 * soft.largest_gap);
    EXPECT_LT(stiff.largest_gap, 0.8 * middle.largest_gap);
    EXPECT_LT(soft.largest_gap, 2.5) << "elements";
    for (const Contact& other : {soft, stiff}) EXPECT_NEAR(other.depth(), middle.depth(), 0.1 * middle.depth());
    default_at[mesh++] = middle;
  }
  EXPECT_LT(default_at[1].dropped, 0.8 * default_at[0].dropped) << "the finer the mesh, the less is dropped";
}

}  // namespace
}  // namespace percal
