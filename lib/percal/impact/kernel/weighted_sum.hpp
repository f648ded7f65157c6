// Sums of an average over elements of one column (impact/target/averaged_erosion.hpp).
#pragma once
#include "percal/impact/kernel/uniform_solid.hpp"
#include "percal/math/lanes.hpp"

namespace percal::PERCAL_LEVEL {

template <class Real>
WeightedSum weighted_sum(const Real* alive, const Real* measure, const Real* per_limit, const Real* weights,
                         int count) {
  using V = typename VectorOf<Real>::type;
  const V zero{};
  V share = zero, whole = zero;
  for (int j = 0; j < count; j += Lane<V>::count) {
    const V limit = load<V>(per_limit + j);
    const auto counts = (load<V>(alive + j) > Real(0)) & (limit > Real(0));
    const V weight = select(counts, load<V>(weights + j), zero);
    share += weight * limit * load<V>(measure + j);
    whole += weight;
  }
  return {lane_sum(share), lane_sum(whole)};
}

}  // namespace percal::PERCAL_LEVEL
