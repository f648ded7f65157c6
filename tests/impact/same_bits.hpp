// The same bits in everything that a run decides.
#pragma once
#include <gtest/gtest.h>

#include "percal/impact/result.hpp"

namespace percal {

inline void same_motion(const ImpactResult& a, const ImpactResult& b) {
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.end_time, b.end_time);
  EXPECT_EQ(a.end_speed, b.end_speed);
  EXPECT_EQ(a.sideways, b.sideways);
  EXPECT_EQ(a.turn, b.turn);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.eroded, b.eroded);
  EXPECT_EQ(a.smallest_jacobian, b.smallest_jacobian);
  EXPECT_EQ(a.energy.collisions, b.energy.collisions);
  EXPECT_EQ(a.energy.viscosity, b.energy.viscosity);
  EXPECT_EQ(a.energy.particle, b.energy.particle);
}

// And in the energies of the whole block as well.
inline void same_bits(const ImpactResult& a, const ImpactResult& b) {
  same_motion(a, b);
  for (const auto& [key, share, words] : energy_terms) EXPECT_EQ(a.energy.*share, b.energy.*share) << key;
}

}  // namespace percal
