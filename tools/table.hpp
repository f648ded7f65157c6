// Aligned tables on the terminal.
#pragma once
#include <string>
#include <vector>

namespace percal::tools {

// The first row is the header, underlined; the first column is flush left, the others flush right, the last flush left.
// Widths count characters, not bytes. Every line is indented by two.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace percal::tools
