// A material that a reader found in a file.
#pragma once
#include <string>
#include <vector>

#include "percal/card/card_material.hpp"

namespace percal {

struct FoundCard {
  CardMaterial material;
  int line;                          // of its keyword
  std::vector<std::string> ignored;  // what of it was passed over, one text each
};

// The only one of a file. Throws BadInput where there is none or where there are several: their names are listed.
FoundCard only_card(const std::vector<FoundCard>& cards, const std::string& file);

// The one with this name. Throws BadInput with the names there are.
FoundCard named_card(const std::vector<FoundCard>& cards, const std::string& name, const std::string& file);

// Takes a term into a material; a term of zeros is none. Throws BadInput for a modulus without an exponent, and for more
// than three terms.
void add_term(CardMaterial& material, const Ogden& term, const Place& place);

}  // namespace percal
