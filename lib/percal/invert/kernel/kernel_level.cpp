// The kernel for one instruction level: compiled once for each, with PERCAL_LEVEL naming it (cmake/PercalKernel.cmake).
#include "percal/invert/kernel/kernel.hpp"
#include "percal/math/lanes.hpp"

namespace percal::PERCAL_LEVEL {

using V = DoubleLanes::Vector;

// Of r = sqrt(5 s).
static PERCAL_INLINE V decay_of(V r) { return exp2_of(-1.4426950408889634 * r); }
static PERCAL_INLINE V value_over_decay(V r) { return 1 + r + r * r * (1.0 / 3); }
static PERCAL_INLINE V slope_over_decay(V r) { return (-5.0 / 6) * (1 + r); }

static void matern52(const double* s, long count, double* values, double* slopes) {
  constexpr int lanes = Lane<V>::count;
  for (long i = 0; i < count; i += lanes) {
    const long left = count - i < lanes ? count - i : lanes;
    V distance{};
    __builtin_memcpy(&distance, s + i, left * sizeof(double));
    const V r = square_root(5 * distance), decay = decay_of(r), value = value_over_decay(r) * decay,
            slope = slope_over_decay(r) * decay;
    __builtin_memcpy(values + i, &value, left * sizeof(double));
    if (slopes) __builtin_memcpy(slopes + i, &slope, left * sizeof(double));
  }
}

static void matern52_sums(const double* runs, const double* weights, int rows, int inputs, const double* here,
                          double* sums) {
  V value{}, gradient[emulator_inputs]{};
  for (int i = 0; i < rows; i += Lane<V>::count) {
    V away[emulator_inputs], s{};
    for (int j = 0; j < inputs; ++j) {
      away[j] = here[j] - load<V>(runs + j * rows + i);
      s += away[j] * away[j];
    }
    const V r = square_root(5 * s), decay = load<V>(weights + i) * decay_of(r);
    value += value_over_decay(r) * decay;
    const V slope = 2 * slope_over_decay(r) * decay;
    for (int j = 0; j < inputs; ++j) gradient[j] += slope * away[j];
  }
  sums[0] = lane_sum(value);
  for (int j = 0; j < inputs; ++j) sums[1 + j] = lane_sum(gradient[j]);
}

extern const EmulatorKernel the_emulator_kernel;
const EmulatorKernel the_emulator_kernel{matern52, matern52_sums};

}  // namespace percal::PERCAL_LEVEL
