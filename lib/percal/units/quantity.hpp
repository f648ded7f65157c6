// "1.2 MPa" -> 1.2e6, with its dimension checked. Everything behind this layer is plain double in SI.
#pragma once
#include <string>
#include <string_view>

namespace percal {

// Powers of mass, length and time; a dimensionless number has none.
struct Dimension {
  int mass = 0, length = 0, time = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{.length = 1};
inline constexpr Dimension area{.length = 2};
inline constexpr Dimension mass{.mass = 1};
inline constexpr Dimension time{.time = 1};
inline constexpr Dimension rate{.time = -1};
inline constexpr Dimension speed{.length = 1, .time = -1};
inline constexpr Dimension density{.mass = 1, .length = -3};
inline constexpr Dimension force{.mass = 1, .length = 1, .time = -2};
inline constexpr Dimension pressure{.mass = 1, .length = -1, .time = -2};
inline constexpr Dimension impact_parameter{.mass = 1, .length = -1, .time = -1};  // density times speed times radius
inline constexpr Dimension sectional_density{.mass = 1, .length = -2};  // mass over the area that faces the target
}  // namespace dimension

struct Quantity {
  double value;  // in SI
  Dimension dimension;
};

// The SI value of a text with a unit: "1.2 MPa", "16800 kg/m3", "83 m/s", "26um", "0.7". Units are factors joined by
// '*' or ' ' and '/', each with an integer power ("kg/m3", "kg/m^3", "kg m^-3"); brackets group them ("kg/(m s)"), and
// "kg/m s" is refused because it may be read in two ways. Decimal prefixes cost no rounding: "26 um" is the double
// nearest to 26e-6. The decimal mark is a point, whatever the locale. Throws std::invalid_argument with a message that
// names the unknown unit and the known ones; nan, infinity, numbers beyond the range of double and trailing characters
// are refused as well.
Quantity parse_quantity(std::string_view text);

// As above for a bare unit: "kPa" -> 1000 with the dimension of a pressure. "-", "1" and "" are dimensionless.
Quantity parse_unit(std::string_view unit);

// What has this dimension, for messages: "length", "pressure"; "quantity in kg m^2" for one without a name.
std::string name_of(const Dimension& dimension);

// An example of a unit with this dimension, for messages: "Pa, kPa, MPa, GPa" for a pressure.
std::string units_of(const Dimension& dimension);

// 0.0413 with dimension::length -> "41.3 mm": digits significant digits and the unit prefix that reads best.
std::string format_quantity(double value, const Dimension& dimension, int digits = 4);

}  // namespace percal
