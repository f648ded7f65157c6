#include "percal/card/abaqus.hpp"

#include <cctype>

#include "percal/card/field.hpp"
#include "percal/card/header.hpp"

namespace percal {
namespace {

constexpr int field_characters = 20;  // CalculiX's limit
constexpr std::size_t name_characters = 80;

// A name that both programs take: letters, digits, '_' and '-', a letter first, at most 80 characters.
std::string material_name(const std::string& name) {
  const bool letter_first = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front()));
  std::string fit = letter_first ? "" : "M";
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    if ((byte & 0xC0) == 0x80) continue;  // the rest of a character in UTF-8
    fit += byte < 128 && (std::isalnum(byte) || letter == '-') ? letter : '_';
  }
  return fit.substr(0, name_characters);
}

}  // namespace

std::string abaqus_card(const CardMaterial& material, const UnitSystem& units) {
  check(material, Place{});
  const auto field = [](double value) { return number_field(value, field_characters); };
  std::string text = card_header("**", material, units, {"mu", material.mu_true});
  text += comment_lines("**", "D1 = 2/K; U = (J - 1)^2 / D1");
  if (material.erosion) {
    text += comment_lines("**", "no erosion in this card: elements should go at a largest principal strain of " +
                                    in_all_measures(*material.erosion));
  } else {
    text += comment_lines("**", "no erosion in this card");
  }
  text += card_sources("**", material);
  text += "*MATERIAL, NAME=" + material_name(material.name) + "\n";
  text += "*DENSITY\n" + field(material.density / units.density()) + "\n";
  text += "*HYPERELASTIC, OGDEN, N=1\n";
  text += field(material.mu_true / units.stress) + ", " + field(material.alpha) + ", " +
          field(2 / (material.bulk_modulus / units.stress)) + "\n";
  return text;
}

}  // namespace percal
