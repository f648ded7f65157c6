#include <fmt/core.h>

#include "percal/card/card_comments.hpp"
#include "percal/card/card_text.hpp"
#include "percal/card/febio/febio.hpp"

namespace percal {
namespace {

constexpr std::size_t name_characters = 80;

// One XML comment of all lines: "--" may not stand in it.
std::string xml_comment(std::string lines) {
  for (auto at = lines.find("--"); at != std::string::npos; at = lines.find("--", at)) lines.insert(at + 1, " ");
  return "<!--\n" + lines + "-->\n";
}

std::string erosion_section(double limit, const std::string& elements) {
  return fmt::format(
      "<MeshAdaptor>\n"
      "  <mesh_adaptor type=\"erosion\" elem_set=\"{}\">\n"
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
      elements, number_field(limit));
}

}  // namespace

std::string febio_card(const CardMaterial& material, const UnitSystem& units) {
  check(material, Place{});
  const auto& erosion = material.erosion;
  std::string comments =
      card_comments({" ", "c", CardModulus::two_mu, "volumetric law: k = K; U = K (ln J)^2 / 2"}, material, units);
  const auto add = [&](const std::string& line) { comments += comment_lines(" ", line); };
  const std::string name = ascii_name(material.name, "-_. ,()%+", name_characters);
  add("these sections stand inside febio_spec version 4.0");
  if (erosion) {
    add("elements go at a largest principal strain of " + in_all_measures(*erosion));
    add("strain measure of min: green-lagrange (E1 of FEBio's log variables, averaged over the element)");
    add("MeshAdaptor stands after Mesh, and its elem_set is the name of this material's <Elements> block: rename one "
        "of the two. "
        "Without elem_set elements of other materials go too");
  } else {
    add(no_erosion_comment(material));
  }
  std::string text = xml_comment(comments);
  text += fmt::format("<Material>\n  <material id=\"1\" name=\"{}\" type=\"Ogden\">\n", name);
  text += "    <density>" + number_field(material.density / units.density()) + "</density>\n";
  for (std::size_t k = 0; k < material.terms.size(); ++k) {
    text += fmt::format("    <c{0}>{1}</c{0}>\n    <m{0}>{2}</m{0}>\n", k + 1,
                        number_field(modulus_field(material.terms[k], CardModulus::two_mu) / units.stress),
                        number_field(material.terms[k].alpha));
  }
  text += "    <k>" + number_field(material.bulk_modulus / units.stress) + "</k>\n  </material>\n</Material>\n";
  if (erosion)
    text +=
        erosion_section(strain_at(stretch_at(erosion->limit, erosion->measure), StrainMeasure::green_lagrange), name);
  return text;
}

}  // namespace percal
