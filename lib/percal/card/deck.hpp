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

Deck without_blank_lines(Deck deck);

std::vector<std::string> split_at_commas(const std::string& line);
bool is_blank(const std::string& text);
std::string trimmed(const std::string& text);
std::string upper_without_blanks(const std::string& text);

// The number in a field; a blank one is 0. Throws BadInput with file, line and the field's name.
double deck_number(const std::string& field, const Place& place);

}  // namespace percal
