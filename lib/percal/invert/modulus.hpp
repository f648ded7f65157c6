// The modulus, or another number that the depth falls with, at which the depth is the measured one: one dimension, noisy, monotonic on
// the whole.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace percal {

// A forward model's answer. `censored`: the depth is at least this (the particle passed through). Not `valid`: the model could
// not answer; `why` says the outcome.
struct DepthAnswer {
  double depth = 0;
  bool censored = false;
  bool valid = true;
  std::string why;
};
using DepthOfModulus = std::function<DepthAnswer(double log_modulus)>;

struct InversionOptions {
  double target = 0;     // depth, in the forward model's units
  double start = 0;      // ln of a first guess of the modulus
  double noise = 0.015;  // relative standard deviation of one answer, where the answers don't show a larger one
  // |d ln depth/d ln modulus|, before there are answers to tell: where it is larger, steps and the line's window are smaller.
  double expected_slope = 0.4;
  std::optional<double> slope_error =
      {};                  // its standard deviation, where it counts among what the answers say of the line's slope
  double most_step = 6;    // how far from the start to look
  int fewest_in_line = 5;  // answers near the root that the line shall have
  int most_evaluations = 24;
};

struct InversionPoint {
  double log_modulus;
  DepthAnswer answer;
  bool in_line = false;  // near enough to the root
};

// found: the target lies between two answers. out_of_reach: no answer on one side of it within most_step. failed: an answer
// was not valid. out_of_evaluations: not settled in time.
enum class InversionOutcome { found, out_of_reach, failed, out_of_evaluations };
std::string word(InversionOutcome outcome);

struct Inversion {
  InversionOutcome outcome = InversionOutcome::failed;
  std::string why;
  double log_modulus = 0;              // where the local line through the answers meets the target
  double log_modulus_error = 0;        // standard error: the scatter of the answers about that line, over its slope
  double slope = 0;                    // d ln depth / d ln modulus there
  double scatter = 0;                  // relative scatter of one answer about the line
  int points_in_line = 0;              // answers near the root that the line is fitted to: two parameters
  std::vector<InversionPoint> points;  // in the order of evaluation
};

// Brackets the target, closes in by Brent's method (GSL) until the answer differs from the target by less than the noise or the
// bracket is narrower than the noise allows, then fits ln depth = line in ln modulus to the answers near by; the root of that
// line uses all of them and carries their scatter. A deeper answer belongs to a softer material.
Inversion invert_modulus(const DepthOfModulus& forward, const InversionOptions& options);

}  // namespace percal
