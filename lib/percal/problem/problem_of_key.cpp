// The problem of a text that evaluation_key() wrote.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <string>
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

// Of "[(a)(b)]" the texts between the parentheses.
std::vector<std::string> in_parentheses(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream rest(text);
  for (std::string part; std::getline(rest, part, '(') && !rest.eof();) {
    std::getline(rest, part, ')');
    parts.push_back(part);
  }
  return parts;
}

// `count` of them; those that are missing are 0.
std::vector<double> numbers_of(const std::string& text, std::size_t count) {
  std::vector<double> list;
  std::istringstream items(text);
  for (std::string item; std::getline(items, item, ',');) list.push_back(std::strtod(item.c_str(), nullptr));
  list.resize(count);
  return list;
}

Particle particle_of(const KeyWords& words) {
  if (words.values.contains("elastic-sphere")) {
    const auto numbers = numbers_of(words.text("elastic-sphere"), 2);
    return ElasticSphere{.youngs_modulus = numbers[0], .poisson_ratio = numbers[1]};
  }
  if (words.values.contains("polyhedron")) {
    RigidPolyhedron body{
        .vertices = {}, .mass = words.number("mass"), .free_rotation = words.text("rotation") == "free"};
    for (const std::string& corner : in_parentheses(words.text("polyhedron"))) {
      const auto numbers = numbers_of(corner, 3);
      body.vertices.push_back({numbers[0], numbers[1], numbers[2]});
    }
    return body;
  }
  if (!words.values.contains("profile")) return RigidSphere{};
  RigidPolygon polygon{.mass = words.number("mass"),
                       .inertia = words.number("inertia"),
                       .free_rotation = words.text("rotation") == "free",
                       .half_thickness = words.number("half-thickness")};
  for (const std::string& corner : in_parentheses(words.text("profile"))) {
    const auto numbers = numbers_of(corner, 2);
    polygon.vertices.push_back({numbers[0], numbers[1]});
  }
  return polygon;
}

// "(depth,density,mu,alpha,bulk ratio,limit)..."
std::vector<LowerLayer> below_of(const std::string& text) {
  std::vector<LowerLayer> below;
  for (const std::string& layer : in_parentheses(text)) {
    const auto numbers = numbers_of(layer, 6);
    below.push_back({.depth = numbers[0],
                     .density = numbers[1],
                     .mu = numbers[2],
                     .alpha = numbers[3],
                     .bulk_ratio = numbers[4],
                     .erosion_limit = numbers[5]});
  }
  return below;
}

// "stress:limit;energy:limit;", either or both
FurtherErosion further_of(const std::string& text) {
  FurtherErosion further;
  std::istringstream items(text);
  for (std::string item; std::getline(items, item, ';');) {
    const auto limit = std::strtod(item.substr(std::min(item.size(), item.find(':') + 1)).c_str(), nullptr);
    (item.starts_with("stress") ? further.stress : further.energy) = limit;
  }
  return further;
}

// The first layer's as it stands, then the others' in parentheses.
void read_further_erosion(Problem& p, const std::string& text) {
  p.further_erosion = further_of(text.substr(1, text.find_first_of("(]") - 1));
  const auto lower = in_parentheses(text);
  for (std::size_t k = 0; k < std::min(lower.size(), p.below.size()); ++k)
    p.below[k].further_erosion = further_of(lower[k]);
}

void read_stretches(Problem& p, const std::string& text) {
  const auto numbers = numbers_of(text.substr(1), 1 + p.below.size());
  p.stretch = numbers[0];
  for (std::size_t k = 0; k < p.below.size(); ++k) p.below[k].stretch = numbers[k + 1];
}

// "[1.1,-,1.05]"; "-" where there is none
void read_across(Problem& p, const std::string& text) {
  std::istringstream items(text.substr(1, text.size() - 2));
  std::vector<std::optional<double>> across;
  for (std::string item; std::getline(items, item, ',');)
    across.push_back(item == "-" ? std::nullopt : std::optional(std::strtod(item.c_str(), nullptr)));
  across.resize(1 + p.below.size());
  p.stretch_across = across[0];
  for (std::size_t k = 0; k < p.below.size(); ++k) p.below[k].stretch_across = across[k + 1];
}

Fibres fibres_of(const std::string& text) {
  if (text.empty()) return NoFibres{};
  const auto numbers = numbers_of(text, 4);
  if (std::ranges::count(text, ',') == 3) return FibreFamilies{numbers[0], numbers[1], numbers[2], numbers[3]};
  return PlanarFibres{numbers[0], numbers[1], numbers[2]};
}

void read_fibres(Problem& p, const std::string& text) {
  auto layers = in_parentheses(text);
  layers.resize(1 + p.below.size());
  p.fibres = fibres_of(layers[0]);
  for (std::size_t k = 0; k < p.below.size(); ++k) p.below[k].fibres = fibres_of(layers[k + 1]);
}

PronySeries series_of(const std::string& text) {
  PronySeries series;
  for (const std::string& term : in_parentheses(text)) {
    const auto numbers = numbers_of(term, 2);
    series.terms.push_back({numbers[0], numbers[1]});
  }
  return series;
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
  p.particle = particle_of(words);
  p.pi4 = words.number("pi4");
  p.density_ratio = words.number("density_ratio");
  p.alpha = words.number("alpha");
  p.bulk_ratio = words.number("bulk_ratio");
  p.depth = words.number("depth");
  p.width = words.number("width");
  p.bottom = words.text("bottom") == "fixed" ? Bottom::fixed : Bottom::free;
  p.erosion = erosion_of(words.text("erosion"));
  p.below = below_of(words.text("below"));
  if (words.values.contains("further-erosion")) read_further_erosion(p, words.text("further-erosion"));
  if (words.values.contains("stretch")) read_stretches(p, words.text("stretch"));
  if (words.values.contains("across")) read_across(p, words.text("across"));
  if (words.values.contains("fibres")) read_fibres(p, words.text("fibres"));
  if (words.values.contains("relaxation")) p.relaxation = series_of(words.text("relaxation"));
  if (words.values.contains("friction")) p.friction = CoulombFriction{words.number("friction")};
  const auto mesh = numbers_of(words.text("mesh"), 3);
  p.elements_per_radius = mesh[0];
  p.fine_width = mesh[1];
  p.graded_columns = static_cast<int>(mesh[2]);
  p.hourglass = words.number("hourglass");
  const auto viscosity = numbers_of(words.text("viscosity"), 2);
  p.linear_viscosity = viscosity[0];
  p.quadratic_viscosity = viscosity[1];
  p.time_step_factor = words.number("step");
  p.end_time = words.number("end");
  p.speed_factor = words.number("speed");
  p.arithmetic = words.text("arithmetic") == "double" ? Arithmetic::double_precision : Arithmetic::single_precision;
  p.geometry = words.alone.contains("plane-strain") ? Geometry::plane_strain : Geometry::axisymmetric;
  if (words.values.contains("block")) {
    const auto numbers = numbers_of(words.text("block"), 4);
    p.geometry = Geometry::block;
    p.block = {numbers[0], numbers[1], numbers[2], numbers[3], words.alone.contains("whole-across")};
  }
  p.whole = words.alone.contains("whole");
  p.volumetric_law = volumetric_law_of(words.text("volumetric"));
  if (words.alone.contains("hourglass-viscosity")) p.hourglass_form = HourglassForm::viscosity;
  if (words.alone.contains("eroded-nodes-in-contact")) p.eroded_nodes = ErodedNodes::in_contact;
  if (words.alone.contains("until-passage")) p.until = RunUntil::passage;
  if (words.alone.contains("until-rest")) p.until = RunUntil::rest;
  if (words.values.contains("length")) p.erosion_average = AverageWithin{words.number("length")};
  if (words.values.contains("rates")) p.rates = static_cast<int>(words.number("rates"));
  if (evaluation_key(p, instruction_level) != key) return std::nullopt;
  return p;
}

}  // namespace percal
