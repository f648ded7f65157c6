#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "percal/problem/problem.hpp"

namespace percal {
namespace {

// The words of a key: "name=value", and words that stand alone.
struct KeyWords {
  std::map<std::string, std::string> values;
  std::set<std::string> alone;

  explicit KeyWords(const std::string& key) {
    std::istringstream words(key);
    for (std::string text; words >> text;) {
      const auto equals = text.find('=');
      if (equals == std::string::npos)
        alone.insert(text);
      else
        values.emplace(text.substr(0, equals), text.substr(equals + 1));
    }
  }

  std::string text(const std::string& name) const {
    const auto found = values.find(name);
    return found == values.end() ? "" : found->second;
  }
  double number(const std::string& name) const { return std::strtod(text(name).c_str(), nullptr); }
  std::vector<double> numbers(const std::string& name) const {
    std::vector<double> list;
    std::istringstream items(text(name));
    for (std::string item; std::getline(items, item, ',');) list.push_back(std::strtod(item.c_str(), nullptr));
    list.resize(3);
    return list;
  }
};

Erosion erosion_of(const std::string& text) {
  const auto colon = text.find(':');
  if (colon == std::string::npos) return NoErosion{};
  const std::string kind = text.substr(0, colon);
  const double limit = std::strtod(text.c_str() + colon + 1, nullptr);
  if (kind == "stress") return StressErosion{limit};
  if (kind == "energy") return EnergyErosion{limit};
  for (const auto measure : {StrainMeasure::true_strain, StrainMeasure::green_lagrange})
    if (kind == word(measure)) return StrainErosion{limit, measure};
  return StrainErosion{limit, StrainMeasure::engineering};
}

VolumetricLaw volumetric_law_of(const std::string& text) {
  if (text == "quadratic") return VolumetricLaw::quadratic;
  return text == "logarithmic" ? VolumetricLaw::logarithmic : VolumetricLaw::log_quadratic;
}

}  // namespace

// Read without complaint, written again: what was not understood is missing from the second text.
std::optional<Problem> problem_of_key(const std::string& key, const std::string& instruction_level) {
  const KeyWords words(key);
  Problem p;
  p.pi4 = words.number("pi4");
  p.density_ratio = words.number("density_ratio");
  p.alpha = words.number("alpha");
  p.bulk_ratio = words.number("bulk_ratio");
  p.depth = words.number("depth");
  p.width = words.number("width");
  p.bottom = words.text("bottom") == "fixed" ? Bottom::fixed : Bottom::free;
  p.erosion = erosion_of(words.text("erosion"));
  const auto mesh = words.numbers("mesh");
  p.elements_per_radius = static_cast<int>(mesh[0]);
  p.fine_width = mesh[1];
  p.graded_columns = static_cast<int>(mesh[2]);
  p.contact_stiffness = words.number("contact");
  p.hourglass = words.number("hourglass");
  const auto viscosity = words.numbers("viscosity");
  p.linear_viscosity = viscosity[0];
  p.quadratic_viscosity = viscosity[1];
  p.time_step_factor = words.number("step");
  p.end_time = words.number("end");
  p.speed_factor = words.number("speed");
  p.arithmetic = words.text("arithmetic") == "double" ? Arithmetic::double_precision : Arithmetic::single_precision;
  p.geometry = words.alone.contains("plane-strain") ? Geometry::plane_strain : Geometry::axisymmetric;
  p.whole = words.alone.contains("whole");
  p.volumetric_law = volumetric_law_of(words.text("volumetric"));
  if (words.alone.contains("hourglass-viscosity")) p.hourglass_form = HourglassForm::viscosity;
  if (words.alone.contains("eroded-nodes-in-contact")) p.eroded_nodes = ErodedNodes::in_contact;
  if (words.values.contains("rates")) p.rates = static_cast<int>(words.number("rates"));
  if (evaluation_key(p, instruction_level) != key) return std::nullopt;
  return p;
}

}  // namespace percal
