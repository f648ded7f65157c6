#include "percal/fit/points/specimen.hpp"

#include <numbers>

namespace percal {

Specimen specimen_of(const SpecimenSizes& sizes, const RefusedKey& refuse) {
  const auto& [gauge_length, area, width, thickness, diameter] = sizes;
  constexpr const char* one_section = "one cross-section: an area, a width with a thickness, or a diameter";
  if (area && width) refuse("width", "a width beside an area", one_section);
  if (area && thickness) refuse("thickness", "a thickness beside an area", one_section);
  if (diameter && area) refuse("specimen_diameter", "a diameter beside an area", one_section);
  if (diameter && (width || thickness))
    refuse("specimen_diameter", "a diameter beside a width or a thickness", one_section);
  if (width && !thickness) refuse("thickness", "none beside the width", "the cross-section's other side");
  if (thickness && !width) refuse("width", "none beside the thickness", "the cross-section's other side");
  Specimen specimen{gauge_length, area};
  if (width) specimen.area = *width * *thickness;
  if (diameter) specimen.area = std::numbers::pi / 4 * *diameter * *diameter;
  return specimen;
}

}  // namespace percal
