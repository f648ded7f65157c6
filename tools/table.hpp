// Aligned tables on the terminal.
#pragma once
#include <string>
#include <vector>

namespace percal::tools {

// The first row is the header, underlined and on a terminal bold; the first column is flush left, the others flush right, the
// last flush left. Widths count characters, not bytes. Every line is indented by two. On a terminal that is too narrow
// the last column is folded; where that is not enough each row is shown as a list of its cells.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

// As above for a given number of columns; 0: as many as it takes. Without colours.
std::string aligned_within(const std::vector<std::vector<std::string>>& rows, int columns);

}  // namespace percal::tools
