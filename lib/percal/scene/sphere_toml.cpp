#include "percal/scene/sphere_toml.hpp"

#include <cmath>
#include <numbers>

#include "percal/text/job_table.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

const Range a_length = positive("length");
const std::vector<std::string> sizes{"radius", "diameter"};

// What a sphere's mass may be given as.
struct Heaviness {
  std::string key;
  Dimension dimension;
  Range range;
  double (*density)(double value, double radius);
};
const std::vector<Heaviness>& heavinesses() {
  static const std::vector<Heaviness> all{
      {"density", dimension::density, positive("density"), [](double density, double) { return density; }},
      {"mass", dimension::mass, positive("mass"), sphere_density},
      {"sectional_density", dimension::sectional_density, positive("mass over area"),
       [](double mass_over_area, double radius) {
         return sphere_density(mass_over_area * std::numbers::pi * radius * radius, radius);
       }}};
  return all;
}

std::vector<std::string> heaviness_keys(const std::string& prefix) {
  std::vector<std::string> keys;
  for (const Heaviness& one : heavinesses()) keys.push_back(prefix + one.key);
  return keys;
}

// Which of these keys the table has, itself or behind one of `forms`; the first where it has none. All are known.
std::size_t one_of(const TomlTable& table, const std::vector<std::string>& keys,
                   const std::vector<std::string>& forms = {""}) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    bool given = false;
    for (const std::string& form : forms) {
      table.knows(keys[k] + form);
      given = given || table.has(keys[k] + form);
    }
    if (given && found) {
      const std::string first = keys[*found];
      table.refuse(table.has(first) ? first : first + forms.back(), "this beside " + keys[k], "one of the two");
    }
    if (given) found = k;
  }
  return found.value_or(0);
}

// A quantity that others may stand for, which the message names where none is given.
double quantity_or_others(const TomlTable& table, const std::string& key, const Dimension& of, Range accepted,
                          const std::string& others) {
  if (!table.has(key)) accepted.words += ", or " + others + " in its place";
  return table.quantity(key, of, accepted);
}

double density_of(const TomlTable& table, const std::string& key, const Heaviness& given, double value, double radius) {
  const double density = given.density(value, radius);
  if (!std::isnormal(density))
    table.refuse(key, "a mass whose density is out of the range of numbers", "a mass that fits the size");
  return density;
}

}  // namespace

double radius_from(const TomlTable& table) {
  return one_of(table, sizes) == 1 ? table.quantity("diameter", dimension::length, a_length) / 2
                                   : quantity_or_others(table, "radius", dimension::length, a_length, "a diameter");
}

double sphere_density(double mass, double radius) {
  return mass / (4 * std::numbers::pi / 3 * radius * radius * radius);
}

Sphere sphere_from(const TomlTable& table, const std::string& prefix) {
  const double radius = radius_from(table);
  const auto keys = heaviness_keys(prefix);
  const std::size_t k = one_of(table, keys);
  const Heaviness& given = heavinesses()[k];
  const double value =
      quantity_or_others(table, keys[k], given.dimension, given.range, "a " + keys[1] + " or a " + keys[2]);
  return {radius, density_of(table, keys[k], given, value, radius)};
}

std::vector<Sphere> spheres_of_rows(const TomlTable& block, const CsvTable& table) {
  const std::vector<std::string> forms{"", "_column"};
  const bool by_diameter = one_of(block, sizes, forms) == 1;
  const auto lengths = values_of_rows(block, by_diameter ? "diameter" : "radius", table, dimension::length, a_length);
  const auto keys = heaviness_keys("particle_");
  const std::size_t k = one_of(block, keys, forms);
  const Heaviness& given = heavinesses()[k];
  const auto values = values_of_rows(block, keys[k], table, given.dimension, given.range);
  const std::string key = block.has(keys[k]) ? keys[k] : keys[k] + "_column";
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double radius = by_diameter ? lengths[i] / 2 : lengths[i];
    spheres.push_back({radius, density_of(block, key, given, values[i], radius)});
  }
  return spheres;
}

}  // namespace percal
