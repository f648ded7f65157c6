// The unit in a column's header.
#pragma once
#include <string>

#include "percal/text/csv.hpp"
#include "percal/units/quantity.hpp"

namespace percal {

// Name and unit of a header: "stress [kPa]", "stress (kPa)" and "stress_kPa" are stress in kPa, "density_kg_m3" is
// density in kg/m3: of several trailing parts the first multiplies and the others divide. What stands in brackets is
// always taken as the unit; in parentheses and after '_' only where it is a known unit, so "stretch_x" has none.
CsvColumn split_header(const std::string& header);

// The SI value and dimension of 1 unit. Percent, weight percent and degrees are dimensionless and count as 1.
// Throws std::invalid_argument that names the unknown unit.
Quantity column_unit(const std::string& unit);

// Whether the unit counts hundredths: "%", "pct", "percent" (not weight percent).
bool is_percent(const std::string& unit);

}  // namespace percal
