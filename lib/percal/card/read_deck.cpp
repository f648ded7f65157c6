#include "percal/card/read_deck.hpp"

#include <fmt/core.h>

#include <cctype>
#include <sstream>

#include "percal/card/card_text.hpp"

namespace percal {

const DeckLine& DeckBlock::line(std::size_t index, const std::string& file, const std::string& what) const {
  if (index < data.size()) return data[index];
  throw BadInput(Place{file, number, keyword}, std::to_string(data.size()) + " lines of numbers",
                 "a line with " + what);
}

Deck parse_deck(const std::string& text, const std::string& comment, char keyword) {
  Deck deck;
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.starts_with(comment)) {
      deck.comments.push_back({number, line});
    } else if (line.starts_with(keyword)) {
      deck.blocks.push_back({number, upper_without_blanks(line), line, {}});
    } else if (!deck.blocks.empty()) {
      deck.blocks.back().data.push_back({number, line});
    }
  }
  return deck;
}

std::vector<std::string> split_at(char separator, const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char letter : line) {
    if (letter == separator) {
      fields.emplace_back();
    } else {
      fields.back() += letter;
    }
  }
  return fields;
}

bool is_blank(const std::string& text) { return text.find_first_not_of(" \t\r") == std::string::npos; }

std::string upper_without_blanks(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (!std::isspace(byte)) result += static_cast<char>(std::toupper(byte));
  }
  return result;
}

double deck_number(const std::string& field, const Place& place) {
  if (const auto value = field_number(field)) return *value;
  throw BadInput(place, "'" + field + "'", "a number");
}

void add_term(CardMaterial& material, double modulus, double alpha, CardModulus meaning, const Place& place) {
  if (modulus == 0) return;
  if (alpha == 0) throw BadInput(place, "0 with a modulus", "an exponent other than 0");
  if (material.terms.size() == most_card_terms)
    throw BadInput(place, "more terms", fmt::format("at most {} Ogden terms with a modulus", most_card_terms));
  material.terms.push_back(term_of_field(modulus, alpha, meaning));
}

void set_bulk_modulus(CardMaterial& material, double d1, double stress_unit, const Place& place) {
  if (!(d1 >= 0))
    throw BadInput(place, fmt::format("{:.12g}", d1), "a positive number, or 0 where it is incompressible");
  material.bulk_modulus = d1 > 0 ? 2 / d1 * stress_unit : without_limit;
  if (d1 == 0) material.comments.push_back("incompressible: " + place.key + " = 0");
}

double ratio_of(double nu, const Place& place) {
  if (!(nu > 0 && nu < 0.5))
    throw BadInput(place, fmt::format("{:.12g}", nu),
                   nu < 0 ? "a number between 0 and 0.5: no rubber is auxetic (in some decks the sign is a flag)"
                          : "a number between 0 and 0.5");
  return bulk_to_shear(nu);
}

std::string law_of(std::span<const LawSign> signs, const std::string& keyword) {
  for (const LawSign& one : signs)
    if (keyword.starts_with(one.sign)) return one.law;
  return "";
}

}  // namespace percal
