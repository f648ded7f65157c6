#include "percal/page/numbers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace percal::page {

std::string shown(const std::optional<double>& value, int digits) {
  return value && std::isfinite(*value) ? fmt::format("{:.{}g}", *value, digits) : absent;
}

std::string quantity(const std::optional<double>& value, const Dimension& dimension, int digits) {
  if (!value || !std::isfinite(*value)) return absent;
  return dimension == dimension::none ? shown(value, digits) : format_quantity(*value, dimension, digits);
}
std::string pressure(const std::optional<double>& pascals, int digits) {
  return quantity(pascals, dimension::pressure, digits);
}
std::string length(const std::optional<double>& metres, int digits) {
  return quantity(metres, dimension::length, digits);
}

std::string percent(const std::optional<double>& share, int decimals) {
  return share && std::isfinite(*share) ? fmt::format("{:.{}f} %", 100 * *share, decimals) : absent;
}
std::string signed_percent(const std::optional<double>& share, int decimals) {
  return share && std::isfinite(*share) ? fmt::format("{:+.{}f} %", 100 * *share, decimals) : absent;
}

std::string rough_percent(const std::optional<double>& share) {
  if (!share || !std::isfinite(*share)) return absent;
  if (0 < *share && *share < 5e-5) return "< 0.01 %";
  return std::abs(*share) < 0.995 ? fmt::format("{:.2g} %", 100 * *share) : fmt::format("{:.0f} %", 100 * *share);
}

std::string with_error(const std::string& value, const std::string& error) {
  return error == absent ? value : value + " \u00b1 " + error;
}

std::string counted(long n, const std::string& what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

const UnitSuffix* unit_suffix(const std::string& key) {
  for (const UnitSuffix& suffix : unit_suffixes)
    if (key.ends_with(suffix.ending)) return &suffix;
  return nullptr;
}

Dimension dimension_of_key(const std::string& key) {
  const UnitSuffix* const suffix = unit_suffix(key);
  return suffix ? suffix->dimension : dimension::none;
}

std::string column_label(const std::string& column) {
  static constexpr std::array<std::pair<const char*, const char*>, 9> units{{{"_m_s", "m/s"},
                                                                             {"_kg_m3", "kg/m3"},
                                                                             {"_um", "um"},
                                                                             {"_mm", "mm"},
                                                                             {"_cm", "cm"},
                                                                             {"_m", "m"},
                                                                             {"_kPa", "kPa"},
                                                                             {"_MPa", "MPa"},
                                                                             {"_deg", "degrees"}}};
  std::string name = column, unit;
  for (const auto& [suffix, word] : units)
    if (unit.empty() && name.ends_with(suffix)) {
      name.resize(name.size() - std::string(suffix).size());
      unit = std::string(", ") + word;
    }
  std::replace(name.begin(), name.end(), '_', ' ');
  return name + unit;
}

ShownUnit pressure_unit(double typical) {
  if (typical < 1e3) return {"Pa", 1};
  if (typical < 1e6) return {"kPa", 1e3};
  return typical < 1e9 ? ShownUnit{"MPa", 1e6} : ShownUnit{"GPa", 1e9};
}

ShownUnit length_unit(double typical) {
  if (typical < 1e-3) return {"um", 1e-6};
  return typical < 1e-2 ? ShownUnit{"mm", 1e-3} : ShownUnit{"cm", 1e-2};
}

}  // namespace percal::page
