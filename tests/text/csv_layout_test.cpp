#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "percal/text/csv.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

void expect_table(const std::string& text, int header_line) {
  const CsvTable table = parse_csv(text, "t.csv");
  EXPECT_EQ(table.header_line, header_line) << text;
  ASSERT_EQ(table.rows.size(), 3u) << text;
  EXPECT_THAT(table.numbers("strain", dimension::none), ElementsAre(5, 10, 15));
  EXPECT_THAT(table.numbers("stress", dimension::pressure), ElementsAre(7300, 14500, 21600));
}

const std::string rows = "5,0;7,3\n10,0;14,5\n15,0;21,6\n";

TEST(CsvLayout, LinesBeforeTheTableArePassedOver) {
  expect_table("strain;stress (kPa)\n" + rows, 1);
  expect_table("sep=;\nstrain;stress (kPa)\n" + rows, 2);
  expect_table("\"sep=;\"\r\nstrain;stress (kPa)\n" + rows, 2);
  expect_table("Tensile test of silicone\n\nstrain;stress (kPa)\n" + rows, 3);
  expect_table("Test, of 3 May; first run\nOperator: A\nstrain;stress (kPa)\n" + rows, 3);
  expect_table("Test;Tension\nWidth;10,0\nstrain;stress (kPa)\n" + rows, 3);
  expect_table("Test;Tension\nstrain;stress (kPa)\n" + rows, 2);
  EXPECT_THAT(parse_csv("Title\nOperator\nstrain;stress (kPa)\n" + rows, "t.csv").passed_over, ElementsAre(1, 2));
}

TEST(CsvLayout, ARowOfUnitsBelongsToTheColumnsAboveIt) {
  expect_table("strain;stress\n%;kPa\n" + rows, 1);
  expect_table("Test 7\nstrain;stress\n[%];[kPa]\n" + rows, 2);
  expect_table("strain;stress\n(mm/mm);(kPa)\n" + rows, 1);
  EXPECT_EQ(parse_csv("strain;stress\n%;kPa\n" + rows, "t.csv").columns[0].unit, "%");
  EXPECT_THROW(parse_csv("strain;stress [MPa]\n%;kPa\n" + rows, "t.csv"), BadInput);
}

TEST(CsvLayout, ARowOfTextIsNoHeader) {
  const auto table = parse_csv("stretch,stress_kPa\nn.a.,n.a.\n1.1,3\n1.2,4\n1.3,5\n", "t.csv");
  EXPECT_EQ(table.header_line, 1);
  EXPECT_EQ(table.rows.size(), 4u);
}

TEST(CsvLayout, TheSameFaultOfManyLinesIsOneMessage) {
  try {
    parse_csv("a,b\n1\n2\n3\n", "t.csv");
    FAIL() << "not refused";
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("t.csv:2: found 1 cell; accepted: 2"), HasSubstr("also lines 3-4"),
                                    HasSubstr("header in line 1"), Not(HasSubstr("\n"))));
  }
}

TEST(CsvLayout, Utf16IsReadAndASpreadsheetSaysWhatToSave) {
  const std::string text = "strain;stress (kPa)\n" + rows;
  std::string little = "\xFF\xFE", big = "\xFE\xFF";
  for (const char c : text) {
    little += {c, '\0'};
    big += {'\0', c};
  }
  expect_table(little, 1);
  expect_table(big, 1);
  EXPECT_THROW(parse_csv(little + "x", "t.csv"), BadInput);
  const std::string clef("\xFF\xFE\x34\xD8\x1E\xDD,\0a\0\n\0\x31\0,\0\x32\0", 18);
  EXPECT_EQ(parse_csv(clef, "t.csv").columns[0].header, "\xF0\x9D\x84\x9E");  // U+1D11E, a surrogate pair
  EXPECT_THAT([] { parse_csv("PK\x03\x04 and more", "t.xlsx"); },
              testing::ThrowsMessage<BadInput>(AllOf(HasSubstr("t.xlsx"), HasSubstr("CSV UTF-8"))));
}

}  // namespace
}  // namespace percal
