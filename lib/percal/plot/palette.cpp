#include "percal/plot/palette.hpp"

#include <array>

namespace percal {

std::string palette_colour(int index) {
  constexpr std::array colours{"#d0583f", "#2f86c6", "#3f9444", "#9a6bc0", "#b0812a", "#26948f", "#cc5f98", "#8a7462"};
  return index < 0 ? "#808080" : colours[static_cast<std::size_t>(index) % colours.size()];
}

}  // namespace percal
