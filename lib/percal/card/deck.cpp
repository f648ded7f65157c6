#include "percal/card/deck.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "percal/card/field.hpp"

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

Deck without_blank_lines(Deck deck) {
  for (DeckBlock& block : deck.blocks)
    std::erase_if(block.data, [](const DeckLine& line) { return is_blank(line.text); });
  return deck;
}

std::vector<std::string> split_at_commas(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char letter : line) {
    if (letter == ',') {
      fields.emplace_back();
    } else {
      fields.back() += letter;
    }
  }
  return fields;
}

bool is_blank(const std::string& text) { return text.find_first_not_of(" \t\r") == std::string::npos; }

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

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

}  // namespace percal
