// Dimensions and quantities in words, for messages and tables.
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <span>

#include "percal/units/quantity.hpp"

namespace percal {
namespace {

struct Step {
  const char* unit;
  double factor;  // in SI
};

// The units that a table prints, rising.
constexpr std::array lengths{Step{"nm", 1e-9}, Step{"um", 1e-6}, Step{"mm", 1e-3}, Step{"m", 1}, Step{"km", 1e3}};
constexpr std::array areas{Step{"um2", 1e-12}, Step{"mm2", 1e-6}, Step{"m2", 1}};
constexpr std::array masses{Step{"pg", 1e-15}, Step{"ng", 1e-12}, Step{"ug", 1e-9}, Step{"mg", 1e-6},
                            Step{"g", 1e-3},   Step{"kg", 1},     Step{"t", 1e3}};
constexpr std::array times{Step{"ns", 1e-9}, Step{"us", 1e-6}, Step{"ms", 1e-3}, Step{"s", 1}};
constexpr std::array speeds{Step{"mm/s", 1e-3}, Step{"m/s", 1}};
constexpr std::array densities{Step{"kg/m3", 1}};
constexpr std::array pressures{Step{"Pa", 1}, Step{"kPa", 1e3}, Step{"MPa", 1e6}, Step{"GPa", 1e9}};
constexpr std::array impact_parameters{Step{"kg/(m s)", 1}};
constexpr std::array sectional_densities{Step{"g/m2", 1e-3}, Step{"kg/m2", 1}};
constexpr std::array forces{Step{"uN", 1e-6}, Step{"mN", 1e-3}, Step{"N", 1}, Step{"kN", 1e3}};
constexpr std::array energies{Step{"uJ", 1e-6}, Step{"mJ", 1e-3}, Step{"J", 1}, Step{"kJ", 1e3}};

struct Kind {
  Dimension dimension;
  const char* name;
  const char* units;  // for messages
  std::span<const Step> steps;
};

const std::array kinds{
    Kind{dimension::length, "length", "m, mm, um, nm", lengths},
    Kind{dimension::area, "area", "m2, mm2, um2", areas},
    Kind{dimension::mass, "mass", "kg, g, mg, ug", masses},
    Kind{dimension::time, "time", "s, ms, us, ns", times},
    Kind{dimension::speed, "speed", "m/s, km/s, mm/us", speeds},
    Kind{dimension::density, "density", "kg/m3, g/cm3", densities},
    Kind{dimension::pressure, "pressure", "Pa, kPa, MPa, GPa", pressures},
    Kind{dimension::impact_parameter, "density times speed times radius", "kg/(m s)", impact_parameters},
    Kind{dimension::sectional_density, "mass over area", "kg/m2, g/cm2", sectional_densities},
    Kind{{.mass = 1, .length = 1, .time = -2}, "force", "N, mN, kN", forces},
    Kind{{.mass = 1, .length = 2, .time = -2}, "energy", "J, mJ, kJ", energies},
};

const Kind* find_kind(const Dimension& dimension) {
  for (const auto& kind : kinds) {
    if (kind.dimension == dimension) return &kind;
  }
  return nullptr;
}

// "kg m^-1 s^-2"; empty without dimension.
std::string base_units(const Dimension& dimension) {
  std::string text;
  const auto add = [&text](const char* unit, int power) {
    if (power == 0) return;
    if (!text.empty()) text += ' ';
    text += power == 1 ? std::string(unit) : fmt::format("{}^{}", unit, power);
  };
  add("kg", dimension.mass);
  add("m", dimension.length);
  add("s", dimension.time);
  return text;
}

double rounded(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, std::max(digits, 1) - 1);
  double result = value;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

}  // namespace

std::string name_of(const Dimension& dimension) {
  if (dimension == dimension::none) return "number";
  const Kind* kind = find_kind(dimension);
  return kind ? kind->name : "quantity in " + base_units(dimension);
}

std::string units_of(const Dimension& dimension) {
  if (dimension == dimension::none) return "no unit";
  const Kind* kind = find_kind(dimension);
  return kind ? kind->units : base_units(dimension);
}

std::string format_quantity(double si_value, const Dimension& dimension, int digits) {
  const Kind* kind = find_kind(dimension);
  if (!std::isfinite(si_value) || !kind) {
    const std::string unit = base_units(dimension);
    return fmt::format("{}{}{}", rounded(si_value, digits), unit.empty() ? "" : " ", unit);
  }
  const auto steps = kind->steps;
  const Step* best = &steps.front();
  for (const auto& step : steps) {
    const bool is_base = si_value == 0 && step.factor == 1;
    if (is_base || std::abs(rounded(si_value / step.factor, digits)) >= 1) best = &step;
  }
  return fmt::format("{} {}", rounded(si_value / best->factor, digits), best->unit);
}

}  // namespace percal
