#include "percal/scene/sphere_toml.hpp"

#include <cmath>
#include <numbers>

#include "percal/text/job_table.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

const Range a_length = positive("length"), a_density = positive("density"), a_mass = positive("mass");

// The one of two keys that the table has; the first where it has neither. Both are known.
std::string one_of(const TomlTable& table, const std::string& first, const std::string& second) {
  for (const std::string& key : {first, second}) table.knows(key);
  if (table.has(first) && table.has(second)) table.refuse(first, "this beside " + second, "one of the two");
  return table.has(second) ? second : first;
}

// A quantity that another one may stand for, which the message names where neither is given.
double quantity_or_other(const TomlTable& table, const std::string& key, const Dimension& of, Range accepted,
                         const std::string& other) {
  if (!table.has(key)) accepted.words += ", or " + other + " in its place";
  return table.quantity(key, of, accepted);
}

// The same where either may be one value (`key`) or a column (`key`_column).
std::string one_of_rows(const TomlTable& block, const std::string& first, const std::string& second) {
  for (const std::string& key : {first, second, first + "_column", second + "_column"}) block.knows(key);
  const auto given = [&](const std::string& key) { return block.has(key) || block.has(key + "_column"); };
  if (given(first) && given(second))
    block.refuse(block.has(first) ? first : first + "_column", "this beside a " + second, "one of the two");
  return given(second) ? second : first;
}

double density_of(const TomlTable& table, const std::string& key, double mass, double radius) {
  const double density = sphere_density(mass, radius);
  if (!std::isnormal(density))
    table.refuse(key, "a mass whose density is out of the range of numbers", "a mass that fits the size");
  return density;
}

}  // namespace

double radius_from(const TomlTable& table) {
  return one_of(table, "radius", "diameter") == "diameter"
             ? table.quantity("diameter", dimension::length, a_length) / 2
             : quantity_or_other(table, "radius", dimension::length, a_length, "a diameter");
}

double sphere_density(double mass, double radius) {
  return mass / (4 * std::numbers::pi / 3 * radius * radius * radius);
}

Sphere sphere_from(const TomlTable& table, const std::string& prefix) {
  const double radius = radius_from(table);
  const std::string density = prefix + "density", mass = prefix + "mass";
  if (one_of(table, density, mass) == density)
    return {radius, quantity_or_other(table, density, dimension::density, a_density, "a " + mass)};
  return {radius, density_of(table, mass, table.quantity(mass, dimension::mass, a_mass), radius)};
}

std::vector<Sphere> spheres_of_rows(const TomlTable& block, const CsvTable& table) {
  const bool by_diameter = one_of_rows(block, "radius", "diameter") == "diameter";
  const auto sizes =
      values_of_rows(block, by_diameter ? "diameter" : "radius", table, dimension::length, a_length);
  const bool by_mass = one_of_rows(block, "particle_density", "particle_mass") == "particle_mass";
  const auto amounts = by_mass ? values_of_rows(block, "particle_mass", table, dimension::mass, a_mass)
                               : values_of_rows(block, "particle_density", table, dimension::density, a_density);
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double radius = by_diameter ? sizes[i] / 2 : sizes[i];
    const std::string key = block.has("particle_mass") ? "particle_mass" : "particle_mass_column";
    spheres.push_back({radius, by_mass ? density_of(block, key, amounts[i], radius) : amounts[i]});
  }
  return spheres;
}

}  // namespace percal
