// The colours of the series: each is readable on a white page and on a dark one (contrast of 3 with both).
#pragma once
#include <string>

namespace percal {

// "#c8553d" for the index of a series, taken modulo the palette's length; grey for a negative one.
std::string palette_colour(int index);

}  // namespace percal
