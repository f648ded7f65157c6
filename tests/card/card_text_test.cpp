#include "percal/card/card_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "card/card_test.hpp"
#include "percal/base/error.hpp"

namespace percal {
namespace {

TEST(NumberField, ReadsAsAPersonWouldWriteIt) {
  EXPECT_EQ(number_field(0.7, 10), "0.7");
  EXPECT_EQ(number_field(8.5, 10), "8.5");
  EXPECT_EQ(number_field(15e6, 10), "1.5e7");
  EXPECT_EQ(number_field(1000, 10), "1000.");
  EXPECT_EQ(number_field(-15, 10), "-15.");
  EXPECT_EQ(number_field(0, 10), "0.");
  EXPECT_EQ(number_field(1e-9, 10), "1.e-9");
}

TEST(NumberField, DropsTheLeadingZeroOnlyWhereThatBuysADigit) {
  EXPECT_EQ(number_field(148. / 302, 10), ".490066225");  // 0.4900662251655...
  EXPECT_EQ(number_field(-148. / 302, 10), "-.49006623");
  EXPECT_EQ(number_field(0.25, 10), "0.25");
}

TEST(NumberField, ChoosesTheFormWithTheMostDigits) {
  EXPECT_EQ(number_field(0.00123456789, 10), ".001234568");  // 1.23457e-3 holds one digit less
  EXPECT_EQ(number_field(63.75123456789, 10), "63.7512346");
  EXPECT_EQ(number_field(1234567890123.0, 10), "1.23457e12");
}

TEST(NumberField, IsTheNearestOfItsWidthForAnyDouble) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> digits(-1, 1), exponents(-300, 300);
  for (int i = 0; i < 2000; ++i) {
    const double value = digits(random) * std::pow(10, exponents(random));
    for (const int width : {10, 20}) {
      const std::string field = number_field(value, width);
      ASSERT_LE(field.size(), static_cast<std::size_t>(width)) << value;
      ASSERT_NE(field.find('.'), std::string::npos) << field;
      // "-1.23e-300" leaves three digits of ten columns, so half a unit of the third: 5e-3 of the leading 1.
      const double tolerance = width == 10 ? 5e-3 : 1e-12;
      ASSERT_LE(std::abs(*field_number(field) / value - 1), tolerance) << value << " as " << field;
    }
  }
}

TEST(NumberField, TwentyColumnsHoldFifteenDigitsOfEverydayNumbers) {
  for (const double value : {63.75e6 / 7, 1e-9 / 3, -2.0 / 3, 123456.789012345}) {
    EXPECT_NEAR(*field_number(number_field(value, 20)) / value, 1, 1e-14) << value;
  }
}

TEST(NumberField, LeavesOutTheRoundingOfAUnitsFactor) {
  EXPECT_EQ(number_field(0.3 / 0.1, 20), "3.");  // 2.9999999999999996
  EXPECT_EQ(number_field(1e-12 / 1e-18, 20), "1.e6");
}

TEST(NumberField, RefusesWhatIsNotFinite) {
  EXPECT_THROW(number_field(std::numeric_limits<double>::infinity(), 10), BadInput);
  EXPECT_THROW(number_field(std::nan(""), 20), BadInput);
}

TEST(FieldNumber, TakesBlanksAndSignsAndRefusesTheRest) {
  EXPECT_EQ(field_number("   -15.  "), -15);
  EXPECT_EQ(field_number("+.5e1"), 5);
  EXPECT_EQ(field_number("          "), 0);
  EXPECT_FALSE(field_number("1.2x"));
  EXPECT_FALSE(field_number("inf"));
  EXPECT_FALSE(field_number("+"));
}

TEST(CommentLines, CannotBeBrokenOutOf) {
  const std::string lines = comment_lines("$",
                                          "a\n*END\r\n$ b\tc\v\fd\x01"
                                          "e\x7f");
  EXPECT_EQ(lines, "$ a *END $ b c d e\n");
}

TEST(CommentLines, StayWithinEightyColumns) {
  const std::string lines = comment_lines("**", std::string(300, 'x') + " and then some words " + std::string(90, 'y'));
  std::string letters;
  for (const auto& line : card_test::lines_of(lines)) {
    EXPECT_LE(line.size(), 80u);
    EXPECT_TRUE(line.starts_with("** ")) << line;
    for (char letter : line) {
      if (letter == 'x' || letter == 'y') letters += letter;
    }
  }
  EXPECT_EQ(letters, std::string(300, 'x') + std::string(90, 'y'));
}

TEST(CommentLines, WriteOneMarkForACharacterOutsideAscii) {
  EXPECT_EQ(comment_lines("$", "M\xC3\xBCller 2 \xC2\xB5m"), "$ M?ller 2 ?m\n");
}

TEST(CommentLines, KeepAnEmptyTextAsAnEmptyComment) { EXPECT_EQ(comment_lines("$", ""), "$\n"); }

}  // namespace
}  // namespace percal
