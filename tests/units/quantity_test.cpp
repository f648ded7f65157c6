#include "percal/units/quantity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <locale>
#include <random>
#include <stdexcept>

namespace percal {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
  try {
    const Quantity quantity = parse_quantity(text);
    return "accepted as " + std::to_string(quantity.value);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

double value(const std::string& text, const Dimension& dimension) {
  const Quantity quantity = parse_quantity(text);
  EXPECT_EQ(quantity.dimension, dimension) << text;
  return quantity.value;
}

TEST(Quantity, ADecimalPrefixCostsNoRounding) {
  EXPECT_EQ(value("26 um", dimension::length), 26e-6);
  EXPECT_EQ(value("3.18 mm", dimension::length), 3.18e-3);
  EXPECT_EQ(value("113 kPa", dimension::pressure), 113e3);
  EXPECT_EQ(value("1.2 MPa", dimension::pressure), 1.2e6);
  EXPECT_EQ(value("4.7e1 nm", dimension::length), 47e-9);
  EXPECT_EQ(value("1.0102 g/cm3", dimension::density), 1010.2);
}

TEST(Quantity, AUnitIsComposedOfFactorsWithPowers) {
  for (const char* text :
       {"16800 kg/m3", "16800 kg/m^3", "16800 kg m^-3", "16800kg*m^-3", "16.8 g/cm3", "16800 kg m-3",
        "16800 kg/(m m m)", "16800 kg/m/m/m", "16800 kg/m\u00b3", "16800 kg\u00b7m\u207b\u00b3", "16.8 t/m3"}) {
    EXPECT_EQ(value(text, dimension::density), 16800) << text;
  }
  EXPECT_EQ(value("5 kg/(m s)", dimension::impact_parameter), 5);
  EXPECT_EQ(value("5 kg/m/s", dimension::impact_parameter), 5);
  EXPECT_EQ(value("0.6 mm/us", dimension::speed), 600);
  EXPECT_EQ(value("0.6 km/s", dimension::speed), 600);
  EXPECT_EQ(value("2 N/mm2", dimension::pressure), 2e6);
  EXPECT_EQ(value("2 J/m3", dimension::pressure), 2);
  EXPECT_EQ(value("3 1/s", Dimension{.time = -1}), 3);
  EXPECT_EQ(value("2 (m/s)^2", (Dimension{.length = 2, .time = -2})), 2);
}

TEST(Quantity, UnitsThatAreNoPowersOfTen) {
  EXPECT_DOUBLE_EQ(value("1 in", dimension::length), 0.0254);
  EXPECT_DOUBLE_EQ(value("10 ft", dimension::length), 3.048);
  EXPECT_DOUBLE_EQ(value("0.177 inch", dimension::length), 0.0044958);
  EXPECT_DOUBLE_EQ(value("40 mil", dimension::length), 1.016e-3);
  EXPECT_DOUBLE_EQ(value("590 fps", dimension::speed), 179.832);
  EXPECT_DOUBLE_EQ(value("590 ft/s", dimension::speed), 179.832);
  EXPECT_DOUBLE_EQ(value("100 mph", dimension::speed), 44.704);
  EXPECT_DOUBLE_EQ(value("5.4 gr", dimension::mass), 3.49914114e-4);
  EXPECT_DOUBLE_EQ(value("7000 grain", dimension::mass), 0.45359237);
  EXPECT_DOUBLE_EQ(value("16 oz", dimension::mass), value("1 lb", dimension::mass));
  EXPECT_DOUBLE_EQ(value("0.284 lb/in3", dimension::density), 7861.0929376976865);
  EXPECT_DOUBLE_EQ(value("30 ksi", dimension::pressure), 30e3 * 6894.757293168361);
  EXPECT_DOUBLE_EQ(value("1 psi", dimension::pressure), 6894.757293168361);
  EXPECT_DOUBLE_EQ(value("36 km/h", dimension::speed), 10);
  EXPECT_DOUBLE_EQ(value("2 min", dimension::time), 120);
  EXPECT_DOUBLE_EQ(value("1.5 bar", dimension::pressure), 1.5e5);
}

TEST(Quantity, BothCodePointsOfMicroAreRead) {
  EXPECT_EQ(value("26 \u00b5m", dimension::length), 26e-6);
  EXPECT_EQ(value("26 \u03bcm", dimension::length), 26e-6);
}

TEST(Quantity, SpacesAndSignsAreFree) {
  EXPECT_EQ(value("  26um ", dimension::length), 26e-6);
  EXPECT_EQ(value("+26 um", dimension::length), 26e-6);
  EXPECT_EQ(value("-.5 kg / m / s", dimension::impact_parameter), -0.5);
  EXPECT_EQ(value("0.7", dimension::none), 0.7);
  EXPECT_EQ(value("0 mm", dimension::length), 0);
}

TEST(Quantity, ABareUnitIsItsFactor) {
  EXPECT_EQ(parse_unit("kPa").value, 1000);
  EXPECT_EQ(parse_unit("kPa").dimension, dimension::pressure);
  EXPECT_EQ(parse_unit("mm").value, 1e-3);
  for (const char* text : {"", "-", "1", " "}) {
    EXPECT_EQ(parse_unit(text).value, 1) << text;
    EXPECT_EQ(parse_unit(text).dimension, dimension::none) << text;
  }
  EXPECT_THROW(parse_unit("5 kPa"), std::invalid_argument);
}

TEST(Quantity, WhatIsNotANumberWithAUnitIsRefused) {
  for (const char* text : {"",
                           " ",
                           "um",
                           "nan",
                           "nan m",
                           "inf m",
                           "-inf",
                           "infinity m",
                           "- 5 m",
                           "--5 m",
                           "+-5 m",
                           "1.5.2 m",
                           "5 m extra",
                           "5 kg/",
                           "5 /m",
                           "5 (m",
                           "5 m)",
                           "5 m^",
                           "5 m^x",
                           "5 m^0",
                           "5 m^99",
                           "5 m^3.5",
                           "5 1",
                           "5 2 m",
                           "5 m**3",
                           "0x10 m",
                           "1e999 m",
                           "1e-400 m",
                           "1e308 km",
                           "1e-320 nm",
                           "5e-324 1/h",
                           "5 m;",
                           "5 \xff",
                           "5 m - 2",
                           "5 ((((m^9)^9)^9)^9)",
                           "5 km^9 km^9 km^9 km^9 km^9 km^9 km^9 km^9 km^9 km^9 km^9 km^9"}) {
    EXPECT_THROW(parse_quantity(text), std::invalid_argument) << text;
  }
  EXPECT_THAT(refusal("5 ((((km/m)^9)^9)^9)^9"), HasSubstr("powers are too large"));
  EXPECT_THROW(parse_quantity(std::string(100000, '(')), std::invalid_argument);
  EXPECT_THROW(parse_quantity("5 " + std::string(100000, 'm')), std::invalid_argument);
}

TEST(Quantity, AQuotientThatMayBeReadInTwoWaysIsRefused) {
  EXPECT_THAT(refusal("5 kg/m s"), HasSubstr("two ways"));
  EXPECT_THAT(refusal("5 kg/m*s"), HasSubstr("kg/(m s)"));
}

TEST(Quantity, TheMessageHelps) {
  EXPECT_THAT(refusal("5 furlong"), AllOf(HasSubstr("\"furlong\""), HasSubstr("kPa"), HasSubstr("um")));
  EXPECT_THAT(refusal("5 mpa"), HasSubstr("did you mean MPa?"));
  EXPECT_THAT(refusal("5 KG/m3"), HasSubstr("did you mean kg?"));
  EXPECT_THAT(refusal("5 wt%"), HasSubstr("fraction"));
  EXPECT_THAT(refusal("5 %"), HasSubstr("fraction"));
  EXPECT_THAT(refusal("5,5 mm"), HasSubstr("point"));
  EXPECT_THAT(refusal("5 \x01m"), HasSubstr("\\x01"));
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(Quantity, TheLocaleChangesNothing) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  EXPECT_EQ(parse_quantity("1.5 mm").value, 1.5e-3);
  EXPECT_EQ(format_quantity(1.5e-3, dimension::length), "1.5 mm");
  std::locale::global(before);
}

TEST(FormatQuantity, ThePrefixThatReadsBest) {
  EXPECT_EQ(format_quantity(0.0413, dimension::length), "41.3 mm");
  EXPECT_EQ(format_quantity(26e-6, dimension::length), "26 um");
  EXPECT_EQ(format_quantity(-26e-6, dimension::length), "-26 um");
  EXPECT_EQ(format_quantity(15e6, dimension::pressure), "15 MPa");
  EXPECT_EQ(format_quantity(16800, dimension::density), "16800 kg/m3");
  EXPECT_EQ(format_quantity(600, dimension::speed), "600 m/s");
  EXPECT_EQ(format_quantity(0, dimension::length), "0 m");
  EXPECT_EQ(format_quantity(0.7, dimension::none), "0.7");
  EXPECT_EQ(format_quantity(2, Dimension{.length = 3}), "2 m^3");
}

TEST(FormatQuantity, RoundingCarriesIntoTheNextPrefix) {
  EXPECT_EQ(format_quantity(999960, dimension::pressure), "1 MPa");
  EXPECT_EQ(format_quantity(999960, dimension::pressure, 5), "999.96 kPa");
}

TEST(FormatQuantity, WhatIsPrintedCanBeReadBack) {
  for (const Dimension& dimension :
       {dimension::length, dimension::area, dimension::mass, dimension::time, dimension::speed, dimension::density,
        dimension::pressure, dimension::impact_parameter, Dimension{2, -3, 1}}) {
    for (const double x : {1.23456789e-14, 3.3e-5, -0.02, 7.0, 4.4e4, 9.87654321e12}) {
      const Quantity back = parse_quantity(format_quantity(x, dimension, 6));
      EXPECT_EQ(back.dimension, dimension);
      EXPECT_NEAR(back.value, x, 5.1e-6 * std::abs(x));  // six digits
    }
  }
}

TEST(UnitsOf, NamesUnitsThatReallyHaveTheDimension) {
  EXPECT_EQ(units_of(dimension::pressure), "Pa, kPa, MPa, GPa");
  EXPECT_EQ(name_of(dimension::pressure), "pressure");
  for (const Dimension& dimension :
       {dimension::length, dimension::area, dimension::mass, dimension::time, dimension::speed, dimension::density,
        dimension::pressure, dimension::impact_parameter, Dimension{2, -3, 1}}) {
    const std::string list = units_of(dimension);
    for (std::size_t begin = 0; begin < list.size();) {
      const std::size_t end = std::min(list.find(", ", begin), list.size());
      EXPECT_EQ(parse_unit(list.substr(begin, end - begin)).dimension, dimension) << list;
      begin = end + 2;
    }
  }
}

TEST(Quantity, MutatedTextIsAValueOrARefusal) {
  const std::vector<std::string> seeds{"1.2 MPa", "16800 kg/m^3", "-3.5e-7 kg/(m s)", "26\u00b5m", "0.7", "83 m/s"};
  const std::string alphabet = "0123456789.eE+-*/^() kgmsPaMGu\xc2\xb5\xff%\t,nif";
  std::mt19937 random(20240611);
  int values = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = seeds[random() % seeds.size()];
    for (unsigned change = random() % 4; change-- > 0 && !text.empty();) {
      const std::size_t at = random() % text.size();
      const char c = alphabet[random() % alphabet.size()];
      switch (random() % 3) {
        case 0: text[at] = c; break;
        case 1: text.insert(at, 1, c); break;
        default: text.erase(at, 1);
      }
    }
    try {
      EXPECT_TRUE(std::isfinite(parse_quantity(text).value)) << text;
      ++values;
    } catch (const std::invalid_argument&) {
    }
  }
  EXPECT_GT(values, 5000);  // unchanged texts alone are a quarter
  EXPECT_LT(values, 20000);
}

}  // namespace
}  // namespace percal
