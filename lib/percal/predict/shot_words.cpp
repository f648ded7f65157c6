#include "percal/predict/shot_words.hpp"

#include <algorithm>
#include <cmath>

#include "percal/base/error.hpp"
#include "percal/scene/sphere_toml.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr const char* columns_of_shots[] = {"speed",         "radius",      "diameter", "particle_density",
                                            "particle_mass", "layer_depth", "label"};

}  // namespace

void refuse_option(const std::string& option, const std::string& found, const std::string& accepted) {
  throw BadInput(Place{.file = "", .line = 0, .key = option}, found, accepted);
}

std::vector<NamedText> named_texts(SphereWords& words) {
  return {{"radius", &words.radius},
          {"diameter", &words.diameter},
          {"particle_density", &words.density},
          {"particle_mass", &words.mass}};
}

std::vector<double> ShotRows::numbers(const std::string& name, const std::string& option,
                                      const Dimension& dimension) const {
  const Range accepted = positive(name_of(dimension));
  const auto in_column = column(name);
  if (!in_column) return std::vector(size(), one_quantity(option, option_of(name), dimension, accepted));
  const std::vector<double> values = table_->numbers(*in_column, dimension);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!contains(accepted, values[i]))
      throw BadInput({table_->file, table_->rows[i].line, table_->columns[*in_column].header},
                     in_quotes(table_->cell(table_->rows[i], *in_column)), words_of(accepted));
  return values;
}

std::vector<std::string> ShotRows::labels() const {
  if (const auto named = column("label")) return table_->texts(table_->columns[*named].header);
  return std::vector<std::string>(size());
}

// One of two that stand for each other: the second's own name where it is given.
std::vector<std::string> ShotRows::columns_passed_over() const {
  std::vector<std::string> over;
  if (!table_) return over;
  for (const CsvColumn& own : table_->columns) {
    const auto is_known = [&](const char* name) { return table_->find(name) == table_->find(own.header); };
    if (std::ranges::none_of(columns_of_shots, is_known)) over.push_back(own.header);
  }
  return over;
}

std::string ShotRows::one_of(const std::string& first, const std::string& first_option, const std::string& second,
                             const std::string& second_option) const {
  if (have(first, first_option) && have(second, second_option))
    refuse_option(option_of(first), "this beside " + option_of(second), "one of the two");
  return have(second, second_option) ? second : have(first, first_option) ? first : "";
}

std::optional<std::vector<double>> ShotRows::radii(const SphereWords& words) const {
  const std::string name = one_of("radius", words.radius, "diameter", words.diameter);
  if (name.empty()) return std::nullopt;
  if (name == "radius") return numbers(name, words.radius, dimension::length);
  std::vector<double> sizes = numbers(name, words.diameter, dimension::length);
  for (double& size : sizes) size /= 2;
  return sizes;
}

std::optional<std::vector<double>> ShotRows::densities(const SphereWords& words,
                                                       const std::vector<double>& radii) const {
  const std::string name = one_of("particle_density", words.density, "particle_mass", words.mass);
  if (name.empty()) return std::nullopt;
  if (name == "particle_density") return numbers(name, words.density, dimension::density);
  std::vector<double> amounts = numbers(name, words.mass, dimension::mass);
  for (std::size_t i = 0; i < amounts.size(); ++i) {
    amounts[i] = sphere_density(amounts[i], radii[i]);
    if (!std::isnormal(amounts[i]))
      refuse_option("--particle-mass", "a mass that does not fit the size", "one that does");
  }
  return amounts;
}

std::string ShotRows::option_of(std::string name) {
  std::ranges::replace(name, '_', '-');
  return "--" + name;
}

}  // namespace percal
