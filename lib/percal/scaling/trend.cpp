#include "percal/scaling/trend.hpp"

#include <cmath>
#include <numbers>

namespace percal {
namespace {

std::vector<double> positive_numbers(const CsvTable& table, const std::string& column, const Dimension& dimension) {
  auto numbers = table.numbers(column, dimension);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!(numbers[i] > 0))
      throw BadInput({table.file, table.rows[i].line, column}, table.cell(table.rows[i], table.column(column)),
                     "a positive number");
  return numbers;
}

}  // namespace

double impact_parameter(double density, double speed, double radius) { return density * speed * radius; }

double impact_parameter(const Shot& shot) { return impact_parameter(shot.density, shot.speed, shot.radius); }

std::vector<Shot> read_shots(const CsvTable& table, const ShotColumns& columns) {
  auto densities = positive_numbers(table, columns.density, dimension::density);
  auto sizes = positive_numbers(table, columns.radius.empty() ? columns.diameter : columns.radius, dimension::length);
  auto speeds = positive_numbers(table, columns.speed, dimension::speed);
  auto depths = positive_numbers(table, columns.depth, dimension::length);
  double radius_over_size = columns.radius.empty() ? 0.5 : 1;
  std::vector<Shot> shots;
  for (std::size_t i = 0; i < depths.size(); ++i)
    shots.push_back(
        {.density = densities[i], .radius = sizes[i] * radius_over_size, .speed = speeds[i], .depth = depths[i]});
  return shots;
}

Line depth_trend(std::span<const Shot> shots) {
  std::vector<double> parameters, depths;
  for (const auto& shot : shots) {
    parameters.push_back(impact_parameter(shot));
    depths.push_back(shot.depth);
  }
  return linear_trend(parameters, depths);
}

double depth_from_model(const Line& line, const System& model, double speed_ratio, const System& prototype) {
  double model_radius = required(model, &System::radius);
  double speed = required(prototype, &System::speed) * speed_ratio;
  double depth = line.at(impact_parameter(required(model, &System::particle_density), speed, model_radius));
  return depth * required(prototype, &System::radius) / model_radius;
}

double equal_mass_radius(double mass, double density) { return std::cbrt(3 * mass / (4 * std::numbers::pi * density)); }

double equal_mass_prism_scale(double mass_from, double mass_to) { return std::sqrt(mass_to / mass_from); }

}  // namespace percal
