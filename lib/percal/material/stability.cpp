#include "percal/material/stability.hpp"

#include <fmt/core.h>

#include <cmath>

namespace percal {
namespace {

constexpr int steps = 2000;       // of the logarithm of the stretch, from 1 to an end of the range
constexpr double to_end = 1e-10;  // of a range's end, relative

// d(true stress + pressure)/d(ln lambda) of one direction: sum_k 2 mu_k lambda^alpha_k.
double slope(const Hyperelastic& solid, double log_stretch) {
  double sum = 0;
  for (const auto& term : solid.terms) sum += 2 * term.mu * std::exp(term.alpha * log_stretch);
  return sum;
}

bool stable_at(const Hyperelastic& solid, Deformation deformation, double log_stretch) {
  switch (deformation) {
    case Deformation::equibiaxial: return is_stable(solid, log_stretch, log_stretch);
    case Deformation::planar: return is_stable(solid, log_stretch, 0);
    default: return is_stable(solid, log_stretch, -log_stretch / 2);
  }
}

struct End {
  double stretch;
  bool open;
};

// How far from 1 towards `furthest` the solid stays stable.
End end_towards(const Hyperelastic& solid, Deformation deformation, double furthest) {
  const double whole = std::log(furthest);
  for (int i = 1; i <= steps; ++i) {
    double bad = whole * i / steps, good = whole * (i - 1) / steps;
    if (stable_at(solid, deformation, bad)) continue;
    while (std::abs(bad - good) > to_end) {
      const double middle = (bad + good) / 2;
      (stable_at(solid, deformation, middle) ? good : bad) = middle;
    }
    return {std::exp(good), false};
  }
  return {furthest, true};
}

std::string interval(const StableRange& range) {
  if (range.low == 1 && range.high == 1 && !range.low_open && !range.high_open) return "nowhere";
  return fmt::format("{:.4g} to {:.4g}", range.low, range.high);
}

}  // namespace

bool is_stable(const Hyperelastic& solid, double log_1, double log_2) {
  const double t1 = slope(solid, log_1), t2 = slope(solid, log_2), t3 = slope(solid, -log_1 - log_2);
  return t1 + t2 + 2 * t3 > 0 && t1 * t2 + t2 * t3 + t3 * t1 > 0;
}

std::vector<StableRange> stable_ranges(const Hyperelastic& solid, const StretchRange& searched) {
  std::vector<StableRange> ranges;
  for (const auto deformation : {Deformation::uniaxial, Deformation::equibiaxial, Deformation::planar}) {
    StableRange range{.deformation = deformation};
    if (is_stable(solid, 0, 0)) {
      const End low = end_towards(solid, deformation, searched.low);
      const End high = end_towards(solid, deformation, searched.high);
      range = {deformation, low.stretch, high.stretch, low.open, high.open};
    }
    ranges.push_back(range);
  }
  return ranges;
}

bool stable_throughout(const std::vector<StableRange>& ranges) {
  for (const auto& range : ranges)
    if (!range.low_open || !range.high_open) return false;
  return true;
}

std::string stability_sentence(const std::vector<StableRange>& ranges, const StretchRange& searched) {
  std::string text;
  if (stable_throughout(ranges)) {
    text = fmt::format("Drucker-stable in uniaxial, equibiaxial and planar deformation at stretches from {:g} to {:g}",
                       searched.low, searched.high);
  } else {
    text = fmt::format("Drucker-stable within stretches {:g} to {:g} only at:", searched.low, searched.high);
    for (const auto& range : ranges)
      text += fmt::format("{} {} {}", &range == &ranges[0] ? "" : ",", word(range.deformation), interval(range));
  }
  return text + "; in a change of volume with U = K (J - 1)^2/2 and any K > 0";
}

}  // namespace percal
