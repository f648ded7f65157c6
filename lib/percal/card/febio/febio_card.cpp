#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <pugixml.hpp>
#include <set>

#include "percal/card/card_comments.hpp"
#include "percal/card/card_text.hpp"
#include "percal/card/febio/febio.hpp"
#include "percal/card/read_deck.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr std::size_t name_characters = 80;

// One XML comment of all lines: "--" may not stand in it.
std::string xml_comment(std::string lines) {
  for (auto at = lines.find("--"); at != std::string::npos; at = lines.find("--", at)) lines.insert(at + 1, " ");
  return "<!--\n" + lines + "-->\n";
}

std::string erosion_section(double limit) {
  return fmt::format(
      "<MeshAdaptor>\n"
      "  <mesh_adaptor type=\"erosion\">\n"
      "    <max_iters>1</max_iters>\n"
      "    <criterion type=\"min-max filter\">\n"
      "      <min>{}</min>\n"
      "      <clamp>0</clamp>\n"
      "      <data type=\"element data\">\n"
      "        <element_data>E1</element_data>\n"
      "      </data>\n"
      "    </criterion>\n"
      "  </mesh_adaptor>\n"
      "</MeshAdaptor>\n",
      number_field(limit));
}

}  // namespace

std::string febio_card(const CardMaterial& material, const UnitSystem& units) {
  check(material, Place{});
  const auto& erosion = material.erosion;
  std::string comments =
      card_comments({" ", "c", CardModulus::two_mu, "volumetric law: k = K; U = K (ln J)^2 / 2"}, material, units);
  const auto add = [&](const std::string& line) { comments += comment_lines(" ", line); };
  add("these sections stand inside febio_spec version 4.0");
  if (erosion) {
    add("elements go at a largest principal strain of " + in_all_measures(*erosion));
    add("strain measure of min: green-lagrange (E1 of FEBio's log variables, averaged over the element)");
  } else {
    add(no_erosion_comment(material));
  }
  std::string text = xml_comment(comments);
  text += fmt::format("<Material>\n  <material id=\"1\" name=\"{}\" type=\"Ogden\">\n",
                      ascii_name(material.name, "-_. ,()%+", name_characters));
  text += "    <density>" + number_field(material.density / units.density()) + "</density>\n";
  for (std::size_t k = 0; k < material.terms.size(); ++k) {
    text += fmt::format("    <c{0}>{1}</c{0}>\n    <m{0}>{2}</m{0}>\n", k + 1,
                        number_field(modulus_field(material.terms[k], CardModulus::two_mu) / units.stress),
                        number_field(material.terms[k].alpha));
  }
  text += "    <k>" + number_field(material.bulk_modulus / units.stress) + "</k>\n  </material>\n</Material>\n";
  if (erosion)
    text += erosion_section(strain_at(stretch_at(erosion->limit, erosion->measure), StrainMeasure::green_lagrange));
  return text;
}

namespace {

constexpr int most_terms = 6;  // FEBio's

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
  FoundCard card{.material = {.name = name.empty() ? std::string("material ") + element.attribute("id").value() : name,
                              .density = number_of(need(element, "density", source), source) * units.density()},
                 .line = source.line(element)};
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
  check(card.material, Place{.file = source.file, .line = card.line, .key = ""});
  return card;
}

// The least first principal Green-Lagrange strain at which an adaptor erodes; nothing where it does otherwise.
std::optional<double> erosion_of(const pugi::xml_node& adaptor, const Source& source) {
  const auto filter = adaptor.find_child_by_attribute("criterion", "type", "min-max filter");
  const auto least = filter.child("min");
  if (!least || filter.child("data").child_value("element_data") != std::string("E1")) return std::nullopt;
  return number_of(least, source);
}

}  // namespace

std::vector<FoundCard> read_febio_cards(const std::string& text, const std::string& file, const UnitSystem& units) {
  const Source source{text, file};
  pugi::xml_document document;
  const auto parsed =
      document.load_buffer(text.data(), text.size(),
                           pugi::parse_default | pugi::parse_fragment | pugi::parse_trim_pcdata, pugi::encoding_utf8);
  if (!parsed) {
    const std::string rest = text.substr(std::min<std::size_t>(parsed.offset, text.size()));
    throw BadInput(source.at(parsed.offset, ""), fmt::format("{} at {}", parsed.description(), in_quotes(rest)), "XML");
  }
  std::vector<FoundCard> cards;
  for (const auto& found : document.select_nodes("//material[@type='Ogden' or @type='Ogden unconstrained']"))
    cards.push_back(read_material(found.node(), source, units));
  for (const auto& found : document.select_nodes("//mesh_adaptor[@type='erosion']")) {
    const auto adaptor = found.node();
    const auto limit = erosion_of(adaptor, source);
    for (FoundCard& card : cards) {
      if (limit && cards.size() == 1 && !adaptor.attribute("elem_set")) {
        card.material.erosion = CardErosion{*limit, StrainMeasure::green_lagrange};
        check(card.material, Place{.file = file, .line = source.line(adaptor), .key = ""});
      } else {
        card.ignored.push_back(fmt::format("the erosion adaptor of line {}", source.line(adaptor)));
      }
    }
  }
  return cards;
}

}  // namespace percal
