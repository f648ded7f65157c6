// A page for the terminal: the answer first, the rest where it is asked for.
#pragma once
#include <string>
#include <vector>

#include "percal/page/page.hpp"

namespace percal::page {

struct TextStyle {
  int columns = 0;      // of the terminal; 0: no limit (a pipe, a file)
  bool colour = false;  // bold headers, yellow notes and warnings
  Detail detail = Detail::answer;
};

// Title, summary and the sections of the wanted detail. Figures and kept texts are named; html.hpp shows them.
std::string as_text(const Page& page, const TextStyle& style);
std::string as_text(const Section& section, const TextStyle& style);

// The first row is the header, underlined and bold; columns of numbers are flush right, the others flush left. Widths count
// characters, not bytes; every line is indented by two. Where the columns do not suffice the last column of words is folded, and
// where that is not enough each row is shown as a list of its cells.
std::string as_text(const Table& table, const TextStyle& style);

// Lines of at most so many characters, broken at blanks; a longer word stays whole.
std::vector<std::string> folded(const std::string& text, std::size_t width);

}  // namespace percal::page
