// Numbers in words, for every page, terminal and document: one form each. A number that is not there or not finite is `absent`.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "percal/units/quantity.hpp"

namespace percal::page {

inline const std::string absent = "-";

std::string shown(const std::optional<double>& value, int digits = 4);  // digits significant ones
std::string quantity(const std::optional<double>& value, const Dimension& dimension, int digits = 4);
std::string pressure(const std::optional<double>& pascals, int digits = 4);
std::string length(const std::optional<double>& metres, int digits = 4);
std::string percent(const std::optional<double>& share, int decimals = 1);         // "2.3 %"
std::string signed_percent(const std::optional<double>& share, int decimals = 1);  // "+2.3 %"
std::string rough_percent(const std::optional<double>& share);               // two digits: "0.21 %", "35 %", "< 0.01 %"
std::string with_error(const std::string& value, const std::string& error);  // "value ± error", or the value alone
std::string counted(long n, const std::string& what);                        // "1 run", "3 runs"

// The unit that a key's ending names, and what it stands for: "depth_m", "mu_Pa".
struct UnitSuffix {
  const char* ending;
  Dimension dimension;
};
inline constexpr std::array<UnitSuffix, 12> unit_suffixes{{{"_kg_m3", dimension::density},
                                                           {"_kg_m2", dimension::sectional_density},
                                                           {"_kg_m_s", dimension::impact_parameter},
                                                           {"_m_s", dimension::speed},
                                                           {"_rad_s", {.time = -1}},
                                                           {"_Pa", dimension::pressure},
                                                           {"_kg", dimension::mass},
                                                           {"_m2", dimension::area},
                                                           {"_m", dimension::length},
                                                           {"_s", dimension::time},
                                                           {"_J", {.mass = 1, .length = 2, .time = -2}},
                                                           {"_N", {.mass = 1, .length = 1, .time = -2}}}};
const UnitSuffix* unit_suffix(const std::string& key);  // null where the key has none
Dimension dimension_of_key(const std::string& key);

// A column's name as an axis' label: "velocity_m_s" -> "velocity, m/s".
std::string column_label(const std::string& column);

// The unit in which numbers of this size are shown side by side, and its size in SI: Pa to GPa; um, mm or cm.
struct ShownUnit {
  std::string name;
  double size;
};
ShownUnit pressure_unit(double typical);
ShownUnit length_unit(double typical);

}  // namespace percal::page
