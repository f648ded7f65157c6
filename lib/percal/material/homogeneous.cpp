#include "percal/material/homogeneous.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace percal {
namespace {

constexpr std::array<std::pair<const char*, Deformation>, 18> words = {{
    {"ut", Deformation::uniaxial},
    {"uniaxial", Deformation::uniaxial},
    {"uniaxialtension", Deformation::uniaxial},
    {"uniaxialcompression", Deformation::uniaxial},
    {"tension", Deformation::uniaxial},
    {"compression", Deformation::uniaxial},
    {"tensioncompression", Deformation::uniaxial},
    {"et", Deformation::equibiaxial},
    {"equibiaxial", Deformation::equibiaxial},
    {"biaxial", Deformation::equibiaxial},
    {"ps", Deformation::planar},
    {"planar", Deformation::planar},
    {"pureshear", Deformation::planar},
    {"planarheld", Deformation::planar_held},
    {"ss", Deformation::simple_shear},
    {"shear", Deformation::simple_shear},
    {"simpleshear", Deformation::simple_shear},
    {"generalbiaxial", Deformation::biaxial},
}};

std::string plain_word(const std::string& text) {
  std::string plain;
  for (unsigned char c : text)
    if (c != '-' && c != '_' && c != ' ') plain += static_cast<char>(std::tolower(c));
  return plain;
}

}  // namespace

PrincipalPair principal_pair(const Strained& strained) {
  if (strained.deformation == Deformation::simple_shear) {
    // gamma = lambda - 1/lambda; tau = (sigma_1 - sigma_2)/(lambda + 1/lambda).
    return {std::asinh(strained.amount / 2), -std::asinh(strained.amount / 2), 1 / std::hypot(strained.amount, 2)};
  }
  const double log_stretch = std::log(strained.amount), per_area = 1 / strained.amount;
  switch (strained.deformation) {
    case Deformation::equibiaxial: return {log_stretch, -2 * log_stretch, per_area};
    case Deformation::planar: return {log_stretch, -log_stretch, per_area};
    case Deformation::planar_held: return {0, -log_stretch, 1};
    case Deformation::biaxial: return {log_stretch, -log_stretch - std::log(strained.across), per_area};
    default: return {log_stretch, -log_stretch / 2, per_area};
  }
}

double nominal_stiffness(const Ogden& solid, const Strained& strained) {
  const auto [log_i, log_j, factor] = principal_pair(strained);
  // d(sigma_i - sigma_j)/d(ln amount), where ln lambda_j changes by -share of ln amount.
  const double share = strained.deformation == Deformation::uniaxial      ? 0.5
                       : strained.deformation == Deformation::equibiaxial ? 2.0
                                                                          : 1.0;
  const double along = strained.deformation == Deformation::planar_held ? 0.0 : 1.0;
  const double slope = 2 * solid.mu * (along * std::exp(solid.alpha * log_i) + share * std::exp(solid.alpha * log_j));
  const double difference = cauchy_difference(solid, log_i, log_j);
  if (strained.deformation == Deformation::simple_shear)
    return factor * factor * (slope - difference * std::tanh(log_i));
  if (strained.deformation == Deformation::planar_held) return slope / strained.amount;
  return (slope - difference) / (strained.amount * strained.amount);
}

double nominal_of_cauchy(double cauchy, const Strained& strained) {
  if (strained.deformation == Deformation::simple_shear || strained.deformation == Deformation::planar_held)
    return cauchy;
  return cauchy / strained.amount;
}

std::optional<Deformation> deformation_of(const std::string& text) {
  const std::string plain = plain_word(text);
  const auto* found = std::find_if(words.begin(), words.end(), [&](const auto& known) { return plain == known.first; });
  if (found == words.end()) return std::nullopt;
  return found->second;
}

bool says_compression(const std::string& word) {
  const std::string plain = plain_word(word);
  return plain == "compression" || plain == "uniaxialcompression";
}

bool says_tension(const std::string& word) {
  const std::string plain = plain_word(word);
  return plain == "tension" || plain == "uniaxialtension";
}

std::string word(Deformation deformation) {
  switch (deformation) {
    case Deformation::equibiaxial: return "equibiaxial";
    case Deformation::planar: return "planar";
    case Deformation::planar_held: return "planar_held";
    case Deformation::simple_shear: return "simple_shear";
    case Deformation::biaxial: return "general_biaxial";
    case Deformation::uniaxial: break;
  }
  return "uniaxial";
}

std::string deformation_words() {
  return "UT, uniaxial, tension, compression, tension_compression, ET, equibiaxial, biaxial, PS, planar, pure_shear, "
         "planar_held, SS, shear, simple_shear, general_biaxial";
}

}  // namespace percal
