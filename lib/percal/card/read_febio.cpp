#include <optional>
#include <set>

#include "percal/card/deck.hpp"
#include "percal/card/febio.hpp"
#include "percal/card/modulus.hpp"
#include "percal/card/xml.hpp"

namespace percal {
namespace {

constexpr int most_terms = 6;  // FEBio's

double number_of(const XmlElement& element, const std::string& file) {
  const Place place{file, element.line, element.name};
  if (element.text.empty()) throw BadInput(place, "nothing", "a number");
  return deck_number(element.text, place);
}

const XmlElement& need(const XmlElement& material, const std::string& name, const std::string& file) {
  if (const XmlElement* found = material.child(name)) return *found;
  throw BadInput(Place{file, material.line, name}, "nothing in material '" + material.attribute("name") + "'",
                 "a number");
}

FoundCard read_material(const XmlElement& element, const std::string& file, const UnitSystem& units) {
  const bool unconstrained = element.attribute("type") != "Ogden";
  const std::string name = element.attribute("name");
  FoundCard card{.material = {.name = name.empty() ? "material " + element.attribute("id") : name,
                              .density = number_of(need(element, "density", file), file) * units.density(),
                              .terms = {},
                              .bulk_modulus = 0},
                 .line = element.line,
                 .ignored = {}};
  std::set<std::string> known = {"density", unconstrained ? "cp" : "k"};
  for (int k = 1; k <= most_terms; ++k) {
    const std::string c = "c" + std::to_string(k), m = "m" + std::to_string(k);
    known.insert({c, m});
    const XmlElement* modulus = element.child(c);
    if (!modulus || number_of(*modulus, file) == 0) continue;
    const XmlElement& exponent = need(element, m, file);
    const double alpha = number_of(exponent, file);
    add_term(card.material, term_of_field(number_of(*modulus, file) * units.stress, alpha, CardModulus::two_mu),
             Place{file, exponent.line, m});
  }
  for (const XmlElement& child : element.children) {
    if (!known.count(child.name)) card.ignored.push_back("<" + child.name + "> of the material");
    if (!child.attribute("lc").empty())
      throw BadInput(Place{file, child.line, child.name}, "a load curve (lc)", "a number that does not change");
  }
  const double volumetric = number_of(need(element, unconstrained ? "cp" : "k", file), file) * units.stress;
  // Unconstrained: the terms are in the full stretches, so near J = 1 cp is Lame's lambda, K = cp + 2 mu/3.
  card.material.bulk_modulus = unconstrained ? volumetric + 2 * shear_modulus(card.material) / 3 : volumetric;
  if (unconstrained)
    card.ignored.push_back(
        "that the terms are in full stretches, not isochoric ones: the same to first order in J - 1");
  check(card.material, Place{.file = file, .line = element.line, .key = ""});
  return card;
}

// The least first principal Green-Lagrange strain at which an adaptor erodes; nothing where it does otherwise.
std::optional<double> erosion_of(const XmlElement& adaptor, const std::string& file) {
  const XmlElement* criterion = adaptor.child("criterion");
  if (!criterion || criterion->attribute("type") != "min-max filter") return std::nullopt;
  const XmlElement* data = criterion->child("data");
  const XmlElement* variable = data ? data->child("element_data") : nullptr;
  const XmlElement* least = criterion->child("min");
  if (!variable || variable->text != "E1" || !least) return std::nullopt;
  return number_of(*least, file);
}

}  // namespace

std::vector<FoundCard> read_febio_cards(const std::string& text, const std::string& file, const UnitSystem& units) {
  const XmlElement root = parse_xml(text, file);
  std::vector<const XmlElement*> materials, adaptors;
  root.collect("material", materials);
  root.collect("mesh_adaptor", adaptors);
  std::vector<FoundCard> cards;
  for (const XmlElement* material : materials) {
    const std::string type = material->attribute("type");
    if (type == "Ogden" || type == "Ogden unconstrained") cards.push_back(read_material(*material, file, units));
  }
  for (const XmlElement* adaptor : adaptors) {
    if (adaptor->attribute("type") != "erosion") continue;
    const auto limit = erosion_of(*adaptor, file);
    for (FoundCard& card : cards) {
      if (limit && cards.size() == 1 && adaptor->attribute("elem_set").empty()) {
        card.material.erosion = CardErosion{*limit, StrainMeasure::green_lagrange};
        check(card.material, Place{.file = file, .line = adaptor->line, .key = ""});
      } else {
        card.ignored.push_back("the erosion adaptor of line " + std::to_string(adaptor->line));
      }
    }
  }
  return cards;
}

}  // namespace percal
