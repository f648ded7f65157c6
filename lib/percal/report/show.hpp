// Numbers as the pages show them, with their units; "-" for one that is not there. For the .cpp files of this folder.
#pragma once
#include <optional>
#include <string>

#include "percal/units/quantity.hpp"

namespace percal::report_parts {

std::string shown(const std::optional<double>& value, int digits = 4);
std::string quantity(const std::optional<double>& value, const Dimension& dimension, int digits = 4);
std::string pressure(const std::optional<double>& pascals, int digits = 4);
std::string length(const std::optional<double>& metres, int digits = 4);
std::string percent(const std::optional<double>& share, int decimals = 1);         // "2.3 %"
std::string signed_percent(const std::optional<double>& share, int decimals = 1);  // "+2.3 %"
std::string with_error(const std::string& value, const std::string& error);  // "value ± error", or the value alone

// A column's name as an axis' label: "velocity_m_s" -> "velocity, m/s".
std::string column_label(const std::string& column);

// The unit in which pressures of this size are plotted, and its size in Pa.
struct PressureUnit {
  std::string name;
  double pascals;
};
PressureUnit pressure_unit(double typical);

// The same for lengths: micrometres, millimetres or centimetres.
struct LengthUnit {
  std::string name;
  double metres;
};
LengthUnit length_unit(double typical);

}  // namespace percal::report_parts
