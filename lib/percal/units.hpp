// units: quantities with their units.
//
// Reads and writes "1.2 MPa". Inside, everything is SI in a plain double; units exist in texts alone.
//
//     const double mu = percal::parse_quantity("1.2 MPa").value;  // 1.2e6
//     const std::string text = percal::format_quantity(mu, percal::dimension::pressure);
#pragma once
#include "percal/units/quantity.hpp"
#include "percal/units/words.hpp"
