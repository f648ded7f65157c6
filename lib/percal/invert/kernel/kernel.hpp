// Where an emulator spends its time: sums over its runs, in lanes, compiled once for each instruction level (kernel_level.cpp).
#pragma once

namespace percal {

struct EmulatorKernel {
  // Matern's correlation of order 5/2, c(s) = (1 + r + r^2/3) exp(-r), r^2 = 5 s, and its derivative: values[i] = c(s[i]), slopes[i] = c'(s[i]);
  // slopes may be null.                                                                          docs/theory/emulator.md (3)
  void (*matern52)(const double* s, long count, double* values, double* slopes);

  // With s_i = sum_j (here_j - runs_ij)^2:
  //     sums[0] = sum_i weights_i c(s_i),    sums[1 + j] = d sums[0]/d here_j
  // runs: column after column of `rows` numbers each, rows a multiple of emulator_lanes; inputs: at most emulator_inputs. Runs of weight 0 pad.
  void (*matern52_sums)(const double* runs, const double* weights, int rows, int inputs, const double* here,
                        double* sums);
};
inline constexpr int emulator_lanes = 8, emulator_inputs = 32;

// Of instruction_level().
const EmulatorKernel& emulator_kernel();

}  // namespace percal
