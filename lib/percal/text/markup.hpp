// Text within HTML and SVG.
#pragma once
#include <string>

namespace percal {

// Text that a browser shows as it stands, within an element or a quoted attribute. Control characters become blanks; line
// ends and tabs are kept.
std::string escaped(const std::string& text);

}  // namespace percal
