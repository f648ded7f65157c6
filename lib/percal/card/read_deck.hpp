// What the readers of cards share: an input deck as keywords with their data lines, and the numbers in it.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "percal/card/card_material.hpp"

namespace percal {

struct DeckLine {
  int number;  // 1-based
  std::string text;
};

// A keyword ("*DENSITY") with the data lines under it, blank ones included.
struct DeckBlock {
  int number;
  std::string keyword;  // the whole line in upper case, without blanks
  std::string written;  // as it stands
  std::vector<DeckLine> data;

  // Throws BadInput where there is no such data line. `what` says what should stand there.
  const DeckLine& line(std::size_t index, const std::string& file, const std::string& what) const;
};

struct Deck {
  std::vector<DeckBlock> blocks;
  std::vector<DeckLine> comments;
};

// Lines that start with `comment` are comments, lines that start with `keyword` are keywords.
Deck parse_deck(const std::string& text, const std::string& comment, char keyword);

std::vector<std::string> split_at(char separator, const std::string& line);
bool is_blank(const std::string& text);
std::string upper_without_blanks(const std::string& text);

// The number in a field; a blank one is 0. Throws BadInput with file, line and the field's name.
double deck_number(const std::string& field, const Place& place);

// A modulus in Pa that is `meaning`, and its exponent, as a term of the material; a modulus of 0 is none. Throws BadInput for
// a modulus with exponent 0, and for more than three terms.
void add_term(CardMaterial& material, double modulus, double alpha, CardModulus meaning, const Place& place);

// K of D1 in U = (J - 1)^2/D1, with D1 over `stress_unit` in Pa; without limit for 0, which a comment of the material says then. Throws
// BadInput for a negative D1.
void set_bulk_modulus(CardMaterial& material, double d1, double stress_unit, const Place& place);

// K/mu of Poisson's ratio. Throws BadInput outside 0 to 0.5: no rubber is auxetic, and some decks code a flag in the sign.
double ratio_of(double nu, const Place& place);

// What a keyword's law is called, by how the keyword begins; empty where no sign fits.
struct LawSign {
  const char* sign;
  const char* law;
};
std::string law_of(std::span<const LawSign> signs, const std::string& keyword);

inline constexpr const char* ogden_from_curve = "Ogden from a curve: fit the curve with percal fit";
inline constexpr const char* rubber_from_curve = "a rubber from a curve: fit the curve with percal fit";
inline constexpr const char* as_mooney_rivlin =
    "Mooney-Rivlin: two Ogden terms, alpha 2 with mu = 2 C10 and alpha -2 with mu = 2 C01";

}  // namespace percal
