// Any number of threads gives the same bits.
#include <gtest/gtest.h>

#include "impact/same_bits.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"

namespace percal {
namespace {

void same_bits_on_any_number(Problem p) {
  for (const Arithmetic arithmetic : {Arithmetic::single_precision, Arithmetic::double_precision})
    for (const int rates : {1, 2}) {
      p.arithmetic = arithmetic;
      p.rates = rates;
      const ImpactResult alone = run_impact(p, 1);
      EXPECT_GT(alone.eroded, 10);
      for (const int threads : {2, 3, 5}) {
        SCOPED_TRACE(testing::Message() << threads << " threads, " << rates << " rates");
        const ImpactResult together = run_impact(p, threads);
        same_bits(together, alone);
        EXPECT_EQ(together.target_momentum, alone.target_momentum);
        EXPECT_EQ(together.element_steps, alone.element_steps);
      }
    }
}

TEST(Threads, OfAnAxisymmetricRunGiveTheSameBits) {
  Problem p = setting_s(5);
  p.depth = 20;
  p.end_time = 6;
  same_bits_on_any_number(p);
}

TEST(Threads, OfAWholePlaneStrainRunGiveTheSameBits) {
  Problem p = setting_s(5);
  p.geometry = Geometry::plane_strain;
  p.whole = true;
  p.depth = 20;
  p.end_time = 4;
  same_bits_on_any_number(p);
}

// The block has 8 columns.
TEST(Threads, MoreThanThereAreColumnsGiveTheSameBits) {
  Problem p = setting_s(5);
  p.depth = 20;
  p.end_time = 2;
  same_bits(run_impact(p, 40), run_impact(p));
}

}  // namespace
}  // namespace percal
