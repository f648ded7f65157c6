// Numbers as the tables of a calibration show them. For the .cpp files of this folder.
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "percal/calibrate/result.hpp"
#include "percal/units/quantity.hpp"

namespace percal::calibration_text {

inline std::string percent(double share) { return std::isfinite(share) ? fmt::format("{:.2f} %", 100 * share) : "-"; }
inline std::string signed_percent(double share) {
  return std::isfinite(share) ? fmt::format("{:+.2f} %", 100 * share) : "-";
}
inline std::string rough_percent(double share) {  // two digits
  if (!std::isfinite(share)) return "-";
  if (0 < share && share < 5e-5) return "< 0.01 %";
  return std::abs(share) < 0.995 ? fmt::format("{:.2g} %", 100 * share) : fmt::format("{:.0f} %", 100 * share);
}
inline std::string length(double metres) {
  return std::isfinite(metres) ? format_quantity(metres, dimension::length) : "-";
}
inline std::string pressure(double pascals) {
  return std::isfinite(pascals) ? format_quantity(pascals, dimension::pressure, 3) : "-";
}

// A number of a parameter, moduli with their unit.
inline std::string value_of(const FreeParameter& parameter, double natural) {
  return parameter.unit == "Pa" ? pressure(natural) : std::isfinite(natural) ? fmt::format("{:.3g}", natural) : "-";
}

// "1.2 to 3.4"; where a bound cut the interval off "below 1.2 to 3.4".
template <class Word>
std::string interval_words(const Interval& interval, const Word& word) {
  if (interval.low == interval.high) return "held";
  return fmt::format("{}{} to {}{}", interval.low_open ? "below " : "", word(interval.low),
                     interval.high_open ? "above " : "", word(interval.high));
}

}  // namespace percal::calibration_text
