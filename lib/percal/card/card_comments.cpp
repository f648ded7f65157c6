#include "percal/card/card_comments.hpp"

#include <fmt/core.h>

#include <cctype>
#include <cmath>

#include "percal/base/version.hpp"
#include "percal/card/card_text.hpp"
#include "percal/material/stability.hpp"
#include "percal/units/quantity.hpp"

namespace percal {
namespace {

struct NamedMeasure {
  StrainMeasure measure;
  const char* name;
};
constexpr NamedMeasure measures[] = {{StrainMeasure::engineering, "engineering"},
                                     {StrainMeasure::true_strain, "true"},
                                     {StrainMeasure::green_lagrange, "Green-Lagrange"}};

// What an erosion strain found in an impact asks of the model that it is used in.
constexpr const char* impact_advice =
    "for impacts: contact with all nodes of the zone that erodes as secondaries, not its surface alone, since elements "
    "that go "
    "lay others bare; no deletion of elements by their time step";

const char* const counts[] = {"no", "one", "two", "three"};

std::string end_of(const std::optional<double>& end) { return end ? fmt::format("{:.6g}", *end) : "open"; }

std::string interval_text(const CardInterval& interval, const std::string& name, double factor) {
  const auto scaled = [&](std::optional<double> end) {
    if (end) *end *= factor;
    return end_of(end);
  };
  const std::string ends = factor < 0 ? scaled(interval.high) + " to " + scaled(interval.low)
                                      : scaled(interval.low) + " to " + scaled(interval.high);
  return name + ": " + ends + (interval.parameter.find("_Pa") == std::string::npos ? "" : " Pa");
}

// "mu_true_Pa_2" -> "mu of term 2".
std::string readable(const std::string& parameter) {
  std::string name = parameter;
  std::string term;
  if (name.size() > 2 && name[name.size() - 2] == '_' && std::isdigit(static_cast<unsigned char>(name.back()))) {
    term = std::string(" of term ") + name.back();
    name.resize(name.size() - 2);
  }
  if (name == "mu_true_Pa") name = "mu";
  if (name == "mu_over_alpha_Pa") name = "2 mu/alpha";
  if (name == "erosion_strain") name = "erosion strain";
  return name + term;
}

// The intervals of the parameters, the error of the fit and the data files, one text each.
std::vector<std::string> provenance(const CardMaterial& material) {
  std::vector<std::string> texts;
  if (material.intervals) {
    bool both = false, alpha_known = false;
    for (const CardInterval& interval : material.intervals->of) {
      both = both || interval.parameter == "mu_over_alpha_Pa";
      alpha_known = alpha_known || interval.parameter == "alpha";
    }
    const std::string start = fmt::format("{:.4g} % interval of ", 100 * material.intervals->level);
    for (const CardInterval& interval : material.intervals->of) {
      texts.push_back(start + interval_text(interval, readable(interval.parameter), 1));
      if (interval.parameter == "mu_true_Pa" && material.terms.size() == 1 && !both)
        texts.push_back(start + interval_text(interval, "2 mu/alpha", 2 / material.terms[0].alpha) +
                        (alpha_known ? " (at this alpha)" : ""));
    }
  }
  if (!material.contradiction.empty())
    texts.push_back("WARNING: the data behind this card contradict each other: " + material.contradiction);
  if (!material.fit_error.empty()) texts.push_back("error of the fit: " + material.fit_error);
  for (const CardData& data : material.data) texts.push_back("data: " + data.file + ", SHA-256 " + data.sha256);
  return texts;
}

}  // namespace

std::string card_comments(const CardDialect& dialect, const CardMaterial& material, const UnitSystem& units) {
  const std::size_t terms = material.terms.size();
  std::string text;
  const auto add = [&](const std::string& line) { text += comment_lines(dialect.prefix, line); };
  add(fmt::format("percal {}: {}-term Ogden material '{}'", version(), counts[terms], material.name));
  add(fmt::format("unit system: {} (length {}, mass {}, time {}, stress {})", units.name, units.length_unit,
                  units.mass_unit, units.time_unit, units.stress_unit));
  add(terms == 1
          ? "W = (2 mu/alpha^2) (l1^alpha + l2^alpha + l3^alpha - 3) + U(J), mu the small-strain shear modulus"
          : "W = sum_k (2 mu_k/alpha_k^2) (l1^alpha_k + l2^alpha_k + l3^alpha_k - 3) + U(J), the sum of all mu_k "
            "the small-strain shear modulus");
  for (std::size_t k = 0; k < terms; ++k) {
    const Ogden& term = material.terms[k];
    const double field = modulus_field(term, dialect.modulus);
    add(fmt::format("{}mu: {:.9g} Pa; alpha: {:.9g}; 2 mu/alpha: {:.9g} Pa",
                    terms == 1 ? "" : fmt::format("term {}: ", k + 1), term.mu, term.alpha, 2 * term.mu / term.alpha));
    add(fmt::format("this card's modulus is {}{} = {}: {:.9g} Pa = {:.9g} {}", dialect.modulus_name, k + 1,
                    formula(dialect.modulus), field, field / units.stress, units.stress_unit));
  }
  if (terms > 1) add(fmt::format("small-strain shear modulus: {:.9g} Pa", shear_modulus(material)));
  if (const double ratio = material.bulk_modulus / shear_modulus(material); std::isfinite(ratio))
    add(fmt::format("bulk modulus K: {:.9g} Pa = {:.6g} mu; Poisson's ratio: {:.12g}", material.bulk_modulus, ratio,
                    poisson_ratio(ratio)));
  add(dialect.volumetric + "; cards of different programs agree to first order in J - 1 only");
  if (std::isfinite(material.density)) add(fmt::format("density: {:.9g} kg/m3", material.density));
  if (material.erosion) {
    add(element_size_of(*material.erosion));
    add(impact_advice);
  }
  add(stability_of(material));
  return text + comment_lines(dialect.prefix, provenance(material)) + comment_lines(dialect.prefix, material.comments);
}

std::string no_erosion_comment(const CardMaterial& material) {
  const std::string none = "no erosion in this card";
  if (!material.erosion) return none;
  return none + ": elements should go at a largest principal strain of " + in_all_measures(*material.erosion);
}

std::string in_all_measures(const CardErosion& erosion) {
  const double stretch = stretch_at(erosion.limit, erosion.measure);
  std::string text;
  for (const auto& [measure, name] : measures) {
    const double strain = measure == erosion.measure ? erosion.limit : strain_at(stretch, measure);
    text += fmt::format("{}{:.6g} {}", text.empty() ? "" : " = ", strain, name);
  }
  return text + fmt::format(" (stretch {:.6g})", stretch);
}

std::string element_size_of(const CardErosion& erosion) {
  const std::string strain = fmt::format("erosion strain {:.6g}", erosion.limit);
  const std::string length = erosion.element ? format_quantity(*erosion.element, dimension::length, 4) : "";
  const std::string others = ": other elements want another one";
  if (erosion.element_over_radius)
    return fmt::format("{} for elements of {:.4g} radii{}{}", strain, *erosion.element_over_radius,
                       length.empty() ? "" : " (" + length + ")", others);
  if (!length.empty()) return fmt::format("{} for elements of {}{}", strain, length, others);
  return strain + ": the element size that it belongs to is not known";
}

std::string stability_of(const CardMaterial& material) {
  const StretchRange searched;
  return stability_sentence(stable_ranges({material.terms}, searched), searched);
}

}  // namespace percal
