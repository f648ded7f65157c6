#include "percal/card/found_card.hpp"

#include <fmt/core.h>

namespace percal {
namespace {

std::string names_of(const std::vector<FoundCard>& cards) {
  std::string names;
  for (const FoundCard& card : cards)
    names += fmt::format("{}'{}' (line {})", names.empty() ? "" : ", ", card.material.name, card.line);
  return names;
}

}  // namespace

FoundCard only_card(const std::vector<FoundCard>& cards, const std::string& file) {
  if (cards.empty()) throw BadInput(Place{file, 0, ""}, "no Ogden material", "a card with one");
  if (cards.size() > 1)
    throw BadInput(Place{file, 0, ""}, fmt::format("{} materials: {}", cards.size(), names_of(cards)),
                   "one of them by its name (--name)");
  return cards.front();
}

FoundCard named_card(const std::vector<FoundCard>& cards, const std::string& name, const std::string& file) {
  if (cards.empty()) return only_card(cards, file);
  std::vector<FoundCard> of_name;
  for (const FoundCard& card : cards)
    if (card.material.name == name) of_name.push_back(card);
  if (of_name.size() != 1)
    throw BadInput(Place{file, 0, "--name"}, fmt::format("{} materials '{}'", of_name.size(), name), names_of(cards));
  return of_name.front();
}

void add_term(CardMaterial& material, const Ogden& term, const Place& place) {
  if (term.mu == 0) return;
  if (term.alpha == 0) throw BadInput(place, "a modulus with exponent 0", "an exponent other than 0");
  if (material.terms.size() == most_card_terms)
    throw BadInput(place, "more terms", fmt::format("at most {} Ogden terms with a modulus", most_card_terms));
  material.terms.push_back(term);
}

}  // namespace percal
