// An input deck as lines: keywords, their data lines, comments. Shared by the readers of cards.
#pragma once
#include <string>
#include <vector>

#include "percal/base/error.hpp"

namespace percal {

struct DeckLine {
  int number;  // 1-based
  std::string text;
};

// A keyword ("*DENSITY") with the data lines under it.
struct DeckBlock {
  int number;
  std::string keyword;  // the whole line in upper case, without blanks
  std::vector<DeckLine> data;

  // Throws BadInput where there is no such data line. `what` says what should stand there.
  const DeckLine& line(std::size_t index, const std::string& file, const std::string& what) const;
};

struct Deck {
  std::vector<DeckBlock> blocks;
  std::vector<DeckLine> comments;

  // The first block whose keyword starts with `keyword`; null where there is none.
  const DeckBlock* find(const std::string& keyword) const;
  // As find, but throws BadInput.
  const DeckBlock& need(const std::string& keyword, const std::string& file) const;
};

// Lines that start with `comment` are comments, lines that start with '*' are keywords. Empty lines are passed over.
Deck parse_deck(const std::string& text, const std::string& comment);

// The number in a field. Throws BadInput with file, line and the field's name.
double deck_number(const std::string& field, const Place& place);

}  // namespace percal
