#include "percal/card/card_material.hpp"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "percal/material/plausible.hpp"
#include "percal/text/sha256.hpp"

namespace percal {
namespace {

void need(bool good, const Place& place, const std::string& key, double found, const std::string& accepted) {
  if (good) return;
  const std::string whole_key = place.key.empty() ? key : place.key + "." + key;
  throw BadInput(Place{place.file, place.line, whole_key}, std::isnan(found) ? "nothing" : fmt::format("{}", found),
                 accepted);
}

void need_positive(double value, const Place& place, const std::string& key, const std::string& what) {
  need(std::isfinite(value) && value > 0, place, key, value, "a positive " + what);
}

void check_terms(const std::vector<Ogden>& terms, const Place& place) {
  const bool single = terms.size() == 1;
  need(!terms.empty() && terms.size() <= most_card_terms, place, "terms", static_cast<double>(terms.size()),
       fmt::format("1 to {} Ogden terms", most_card_terms));
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const std::string start = single ? "" : fmt::format("terms[{}].", k);
    need(std::isfinite(terms[k].mu) && terms[k].mu != 0, place, start + "mu_true_Pa", terms[k].mu,
         single ? "a positive shear modulus in Pa" : "a modulus in Pa other than 0");
    need(std::isfinite(terms[k].alpha) && terms[k].alpha != 0, place, start + "alpha", terms[k].alpha,
         "a number other than 0");
  }
  need_positive(small_strain_modulus({terms}), place, single ? "mu_true_Pa" : "terms",
                single ? "shear modulus in Pa" : "sum of all mu_true_Pa");
}

}  // namespace

std::vector<CardData> card_data(const std::vector<std::string>& files) {
  std::vector<CardData> data;
  std::set<std::string> seen;
  for (const std::string& file : files)
    if (!file.empty() && seen.insert(file).second)
      if (const auto digest = sha256_of_file(file))
        data.push_back({std::filesystem::path(file).filename().string(), *digest});
  return data;
}

double shear_modulus(const CardMaterial& material) { return small_strain_modulus({material.terms}); }

void check_solid(const CardMaterial& material, const Place& place) {
  if (!std::isnan(material.density)) need_positive(material.density, place, "density_kg_m3", "density in kg/m3");
  check_terms(material.terms, place);
  const double mu = shear_modulus(material), bulk = material.bulk_modulus;
  need(std::isnan(bulk) || bulk > 2 * mu / 3, place, "bulk_modulus_Pa", bulk,
       fmt::format("more than 2/3 mu, {:.6g} Pa: a Poisson's ratio above 0", 2 * mu / 3));
  if (material.erosion) need_positive(material.erosion->limit, place, "erosion.strain", "strain");
}

void check(const CardMaterial& material, const Place& place) {
  check_solid(material, place);
  need_positive(material.density, place, "density_kg_m3", "density in kg/m3");
  need_positive(material.bulk_modulus, place, "bulk_modulus_Pa", "bulk modulus in Pa");
}

std::vector<std::string> implausible(const CardMaterial& material) {
  auto sentences = implausible_modulus(shear_modulus(material));
  for (const std::string& one : implausible_density(material.density)) sentences.push_back(one);
  return sentences;
}

CardMaterial for_elements(const CardMaterial& material, double strain, double element, double radius,
                          const std::string& how) {
  CardMaterial other = material;
  const double ratio = strain / material.erosion->limit;
  other.erosion = CardErosion{strain, material.erosion->measure, element / radius, element};
  if (other.intervals)
    for (CardInterval& interval : other.intervals->of)
      if (interval.parameter == "erosion_strain")
        for (auto* end : {&interval.low, &interval.high})
          if (*end) **end *= ratio;
  other.comments.push_back(how);
  return other;
}

double modulus_field(const Ogden& term, CardModulus meaning) {
  switch (meaning) {
    case CardModulus::two_mu_over_alpha: return 2 * term.mu / term.alpha;
    case CardModulus::two_mu: return 2 * term.mu;
    case CardModulus::mu: break;
  }
  return term.mu;
}

Ogden term_of_field(double field, double alpha, CardModulus meaning) {
  switch (meaning) {
    case CardModulus::two_mu_over_alpha: return {field * alpha / 2, alpha};
    case CardModulus::two_mu: return {field / 2, alpha};
    case CardModulus::mu: break;
  }
  return {field, alpha};
}

std::string formula(CardModulus meaning) {
  switch (meaning) {
    case CardModulus::two_mu_over_alpha: return "2 mu/alpha";
    case CardModulus::two_mu: return "2 mu";
    case CardModulus::mu: break;
  }
  return "mu";
}

}  // namespace percal
