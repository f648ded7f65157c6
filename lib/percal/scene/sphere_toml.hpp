// Size and mass of a round particle as a table gives them, in scenes and in jobs: a radius or a diameter, a density or a mass.
#pragma once
#include <string>
#include <vector>

#include "percal/text/csv.hpp"
#include "percal/text/toml.hpp"

namespace percal {

struct Sphere {
  double radius;   // m
  double density;  // kg/m3
};

// m, of `radius`, or half of `diameter`.
double radius_from(const TomlTable& table);

// kg/m3: of a sphere of that radius (m) and mass (kg).
double sphere_density(double mass, double radius);

// `radius` or `diameter`; `density`, `mass` or `sectional_density` (mass over pi a^2), or with the prefix "particle_" `particle_density`
// and so on. Throws BadInput.
Sphere sphere_from(const TomlTable& table, const std::string& prefix = "");

// Of every row of a block's table: `radius` or `diameter`, `particle_density`, `particle_mass` or `particle_sectional_density`, each as one value for all rows or,
// behind `_column`, as the name of a column.
std::vector<Sphere> spheres_of_rows(const TomlTable& block, const CsvTable& table);

}  // namespace percal
