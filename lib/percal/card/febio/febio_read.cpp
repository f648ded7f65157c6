#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <pugixml.hpp>
#include <set>

#include "percal/card/febio/febio.hpp"
#include "percal/card/read_deck.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr int most_terms = 6;  // FEBio's

constexpr std::array other_laws{LawSign{"Mooney-Rivlin", as_mooney_rivlin},
                                LawSign{"neo-Hookean", "neo-Hooke: the Ogden term alpha = 2"},
                                LawSign{"uncoupled viscoelastic", "a Prony series over another material"},
                                LawSign{"viscoelastic", "a Prony series over another material"}};

// A file's text and name: what it takes to say where a node stands.
struct Source {
  const std::string& text;
  const std::string& file;

  Place at(std::ptrdiff_t offset, const std::string& key) const {
    const auto end = text.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text));
    return {file, 1 + static_cast<int>(std::count(text.begin(), end, '\n')), key};
  }
  Place place(const pugi::xml_node& node) const { return at(node.offset_debug(), node.name()); }
  int line(const pugi::xml_node& node) const { return place(node).line; }
};

double number_of(const pugi::xml_node& element, const Source& source) {
  std::string text;  // in pieces where comments stand in it
  for (const auto& piece : element.children()) text += piece.value();
  if (text.empty()) throw BadInput(source.place(element), "nothing", "a number");
  return deck_number(text, source.place(element));
}

pugi::xml_node need(const pugi::xml_node& material, const std::string& name, const Source& source) {
  if (const auto found = material.child(name.c_str())) return found;
  throw BadInput({source.file, source.line(material), name},
                 fmt::format("nothing in material '{}'", material.attribute("name").value()), "a number");
}

FoundCard read_material(const pugi::xml_node& element, const Source& source, const UnitSystem& units) {
  const bool unconstrained = element.attribute("type").value() != std::string("Ogden");
  const std::string name = element.attribute("name").value();
  FoundCard card{.material = {.name = name.empty() ? std::string("material ") + element.attribute("id").value() : name},
                 .line = source.line(element)};
  if (const auto density = element.child("density"))
    card.material.density = number_of(density, source) * units.density();
  std::set<std::string> known = {"density", unconstrained ? "cp" : "k"};
  for (int k = 1; k <= most_terms; ++k) {
    const std::string c = "c" + std::to_string(k), m = "m" + std::to_string(k);
    known.insert({c, m});
    const auto modulus = element.child(c.c_str());
    if (!modulus || number_of(modulus, source) == 0) continue;
    const auto exponent = need(element, m, source);
    add_term(card.material, number_of(modulus, source) * units.stress, number_of(exponent, source), CardModulus::two_mu,
             source.place(exponent));
  }
  for (const auto& child : element.children()) {
    if (child.type() != pugi::node_element) continue;
    if (!known.count(child.name())) card.ignored.push_back(fmt::format("<{}> of the material", child.name()));
    if (child.attribute("lc"))
      throw BadInput(source.place(child), "a load curve (lc)", "a number that does not change");
  }
  const double volumetric = number_of(need(element, unconstrained ? "cp" : "k", source), source) * units.stress;
  // Unconstrained: the terms are in the full stretches, so near J = 1 cp is Lame's lambda, K = cp + 2 mu/3.
  card.material.bulk_modulus = unconstrained ? volumetric + 2 * shear_modulus(card.material) / 3 : volumetric;
  if (unconstrained)
    card.ignored.push_back(
        "that the terms are in full stretches, not isochoric ones: the same to first order in J - 1");
  check_solid(card.material, Place{.file = source.file, .line = card.line, .key = ""});
  return card;
}

// The least first principal Green-Lagrange strain at which an adaptor erodes; nothing where it does otherwise.
std::optional<double> erosion_of(const pugi::xml_node& adaptor, const Source& source) {
  const auto filter = adaptor.find_child_by_attribute("criterion", "type", "min-max filter");
  const auto least = filter.child("min");
  if (!least || filter.child("data").child_value("element_data") != std::string("E1")) return std::nullopt;
  return number_of(least, source);
}

// The name of the material of the elements that an adaptor looks at; nothing where it looks at all.
std::optional<std::string> material_of(const pugi::xml_document& document, const pugi::xml_node& adaptor) {
  const std::string set = adaptor.attribute("elem_set").value();
  if (set.empty()) return std::nullopt;
  for (const auto& domain : document.select_nodes("//SolidDomain"))
    if (domain.node().attribute("name").value() == set) return domain.node().attribute("mat").value();
  return set;  // a card alone: percal names the set as the material
}

void read_adaptor(const pugi::xml_document& document, const pugi::xml_node& adaptor, const Source& source,
                  FoundMaterials& found) {
  const auto limit = erosion_of(adaptor, source);
  const auto material = material_of(document, adaptor);
  bool taken = false;
  for (FoundCard& card : found.cards) {
    if (material && *material != card.material.name) continue;
    taken = true;
    if (limit) {
      card.material.erosion = CardErosion{*limit, StrainMeasure::green_lagrange};
      check_solid(card.material, Place{.file = source.file, .line = source.line(adaptor), .key = ""});
    } else {
      card.ignored.push_back(fmt::format("the erosion adaptor of line {}", source.line(adaptor)));
      card.erodes_otherwise = true;
    }
  }
  if (taken) return;
  for (FoundCard& card : found.cards)
    card.ignored.push_back(fmt::format("the erosion adaptor of line {}, of elements that are not known to be its own",
                                       source.line(adaptor)));
}

// A material of another law, or Ogden's inside another material.
OtherMaterial other_of(const pugi::xml_node& element, const Source& source) {
  const std::string type = element.attribute("type").value();
  const bool inside = type == "Ogden" || type == "Ogden unconstrained";
  return {source.line(element), fmt::format("<{} type=\"{}\">", element.name(), type),
          inside ? fmt::format("Ogden inside another material, \"{}\": what that adds is not read",
                               element.parent().attribute("type").value())
                 : law_of(other_laws, type)};
}

}  // namespace

FoundMaterials read_febio_cards(const std::string& text, const std::string& file, const UnitSystem& units) {
  const Source source{text, file};
  pugi::xml_document document;
  const auto parsed =
      document.load_buffer(text.data(), text.size(),
                           pugi::parse_default | pugi::parse_fragment | pugi::parse_trim_pcdata, pugi::encoding_utf8);
  if (!parsed) {
    const std::string rest = text.substr(std::min<std::size_t>(parsed.offset, text.size()));
    throw BadInput(source.at(parsed.offset, ""), fmt::format("{} at {}", parsed.description(), in_quotes(rest)), "XML");
  }
  FoundMaterials found;
  for (const auto& one : document.select_nodes("//material[@type='Ogden' or @type='Ogden unconstrained']"))
    found.cards.push_back(read_material(one.node(), source, units));
  for (const auto& one : document.select_nodes("//material[@type!='Ogden' and @type!='Ogden unconstrained'] | "
                                               "//material//*[@type='Ogden' or @type='Ogden unconstrained']"))
    found.others.push_back(other_of(one.node(), source));
  for (const auto& one : document.select_nodes("//mesh_adaptor[@type='erosion']"))
    read_adaptor(document, one.node(), source, found);
  return found;
}

}  // namespace percal
