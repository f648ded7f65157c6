#include "percal/card/deck.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "percal/card/field.hpp"

namespace percal {
namespace {

std::string upper_without_blanks(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (!std::isspace(byte)) result += static_cast<char>(std::toupper(byte));
  }
  return result;
}

}  // namespace

const DeckLine& DeckBlock::line(std::size_t index, const std::string& file, const std::string& what) const {
  if (index < data.size()) return data[index];
  throw BadInput(Place{file, number, keyword}, std::to_string(data.size()) + " lines of numbers",
                 "a line with " + what);
}

const DeckBlock* Deck::find(const std::string& keyword) const {
  const auto found = std::find_if(blocks.begin(), blocks.end(),
                                  [&](const DeckBlock& block) { return block.keyword.starts_with(keyword); });
  return found == blocks.end() ? nullptr : &*found;
}

const DeckBlock& Deck::need(const std::string& keyword, const std::string& file) const {
  if (const DeckBlock* block = find(keyword)) return *block;
  throw BadInput(Place{.file = file, .line = 0, .key = keyword}, "no such keyword", "a card with " + keyword);
}

Deck parse_deck(const std::string& text, const std::string& comment) {
  Deck deck;
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.starts_with(comment)) {
      deck.comments.push_back({number, line});
    } else if (line.starts_with('*')) {
      deck.blocks.push_back({number, upper_without_blanks(line), {}});
    } else if (line.find_first_not_of(" \t") != std::string::npos && !deck.blocks.empty()) {
      deck.blocks.back().data.push_back({number, line});
    }
  }
  return deck;
}

double deck_number(const std::string& field, const Place& place) {
  if (const auto value = field_number(field)) return *value;
  throw BadInput(place, "'" + field + "'", "a number");
}

}  // namespace percal
