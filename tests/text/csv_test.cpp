#include "percal/text/csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include "percal/text/csv_cells.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const BadInput& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return "";
}

std::string refusal_of(const std::string& text) {
  return refusal([&] { parse_csv(text, "t.csv"); });
}

std::vector<double> stresses(const std::string& text) {
  return parse_csv(text, "t.csv").numbers("stress", dimension::pressure);
}

TEST(CsvHeader, TheUnitStandsInTheName) {
  const auto check = [](const std::string& header, const std::string& name, const std::string& unit) {
    const CsvColumn column = split_header(header);
    EXPECT_EQ(column.name, name) << header;
    EXPECT_EQ(column.unit, unit) << header;
    EXPECT_EQ(column.header, header);
  };
  check("stress_kPa", "stress", "kPa");
  check("stress [kPa]", "stress", "kPa");
  check("stress[MPa]", "stress", "MPa");
  check("stress (kPa)", "stress", "kPa");
  check("nominal_stress_MPa", "nominal_stress", "MPa");
  check("density_kg_m3", "density", "kg/m3");
  check("velocity_m_s", "velocity", "m/s");
  check("velocity_tol_m_s", "velocity_tol", "m/s");
  check("mu_highrate_kPa", "mu_highrate", "kPa");
  check("penetration_cm", "penetration", "cm");
  check("concentration_wtpct", "concentration", "wtpct");
  check("concentration_wt_percent", "concentration", "wt_percent");
  check("strain [%]", "strain", "%");
  check("impact_area_mm2", "impact_area", "mm2");
  check("stretch [-]", "stretch", "-");
}

TEST(CsvHeader, ANameThatOnlyLooksLikeAUnitStaysAName) {
  for (const std::string header :
       {"stretch_x", "x_stretch_or_gamma", "kPa", "stretch_min", "temperature_C", "source_of_mu", "strip (stretch_x=1)",
        "_kPa", "stress_", "_", "[kPa]", "sigma_11", "stress_kpa"}) {
    EXPECT_EQ(split_header(header).name, header);
    EXPECT_EQ(split_header(header).unit, "") << header;
  }
}

TEST(Csv, NumbersComeInSi) {
  EXPECT_THAT(stresses("stretch,stress_kPa\n1.1,12\n1.2,1.3e1\n"), ElementsAre(12000, 13000));
  EXPECT_THAT(stresses("stress [MPa]\n0.5\n"), ElementsAre(0.5e6));
  const auto table = parse_csv("r_um,rho_kg_m3,v_m_s,c_wtpct,d_cm\n26,464,83,12,4.19\n", "t.csv");
  EXPECT_EQ(table.numbers("r", dimension::length)[0], 26e-6);  // rounded once, as in TOML
  EXPECT_EQ(table.numbers("rho", dimension::density)[0], 464);
  EXPECT_EQ(table.numbers("v", dimension::speed)[0], 83);
  EXPECT_EQ(table.numbers("c", dimension::none)[0], 12);  // as it stands
  EXPECT_EQ(table.numbers("D_CM", dimension::length)[0], 4.19e-2);
}

TEST(Csv, DialectsOfPeopleReadTheSame) {
  const std::vector<double> expected = {1500, -250};
  EXPECT_EQ(stresses("x,stress_kPa\n1,1.5\n2,-0.25\n"), expected);
  EXPECT_EQ(stresses("\xEF\xBB\xBF# note, with commas; and ; semicolons\r\nx,stress_kPa\r\n1,1.5\r\n\r\n2,-0.25\r\n"),
            expected);
  EXPECT_EQ(stresses("x;stress_kPa\n1;1,5\n2;-0,25\n"), expected);
  EXPECT_EQ(stresses("x;stress_kPa\n1;1.5\n2;-0.25\n"), expected);
  EXPECT_EQ(stresses("x\tstress_kPa\n1\t1,5\n2\t-0,25\n"), expected);
  EXPECT_EQ(stresses("x\tstress_kPa\n\t1.5\n2\t-0.25\n"), expected);
  EXPECT_EQ(stresses("x,stress_kPa,,\n1,1.5,,\n2,-0.25\n,,,\n"), expected);
  EXPECT_EQ(stresses("  x , stress_kPa\n # indented comment\n 1 ,\"1.5\"\n\"2\", -0.25 "), expected);
  EXPECT_EQ(stresses("x,stress_kPa\r1,1.5\r2,\xE2\x88\x92"
                     "0.25\r"),
            expected);
  EXPECT_EQ(stresses("x;\"stress [kPa]\";\n\"1\";\"+1,5\";\n2;-,25;\n"), expected);
}

TEST(Csv, AQuotedCellMayHoldSeparatorsAndQuotes) {
  const auto table = parse_csv("name,note\na,\"one, \"\"two\"\"\"\n", "t.csv");
  EXPECT_THAT(table.texts("note"), ElementsAre("one, \"two\""));
}

TEST(Csv, EveryBadLineIsNamedInOneMessage) {
  const auto shape = refusal_of("a,b\n1,2\n3\n\n4,5,6\n\"7,8\n");
  EXPECT_THAT(shape, HasSubstr("t.csv:3: found 1 cell; accepted: 2"));
  EXPECT_THAT(shape, HasSubstr("t.csv:5: found 3 cells"));
  EXPECT_THAT(shape, HasSubstr("t.csv:6: found a quoted cell"));
  EXPECT_THAT(shape, Not(HasSubstr("t.csv:2")));

  const auto numbers =
      refusal([] { stresses("# c\nstress_kPa\n1\nabc\n2\n1.2.3\nnan\ninf\n1e999\n0x10\n\"1,5\"\n- 1\n"); });
  for (const std::string line : {"t.csv:4: stress_kPa: found \"abc\"",
                                 "t.csv:6:", "t.csv:7:", "t.csv:8:", "t.csv:9:", "t.csv:10:", "t.csv:11:", "t.csv:12:"})
    EXPECT_THAT(numbers, HasSubstr(line));
  EXPECT_THAT(numbers, Not(HasSubstr("t.csv:5:")));
}

TEST(Csv, ManyBadLinesAreStillAllNamed) {
  std::string text = "stress_kPa\n";
  for (int i = 0; i < 80; ++i) text += i == 70 ? "1\n" : "x" + std::to_string(i) + "\n";
  EXPECT_THAT(refusal([&] { stresses(text); }), HasSubstr("also lines 52-71, 73-81"));
  EXPECT_THAT(refusal([&] { stresses("stress_kPa\nx\nx\n1\nx\n"); }), HasSubstr("number (also lines 3, 5)"));
}

TEST(Csv, WhatCannotBeReadIsRefusedWithItsReason) {
  EXPECT_THAT(refusal_of(""), HasSubstr("no header"));
  EXPECT_THAT(refusal_of("# only a comment\n"), HasSubstr("no header"));
  EXPECT_THAT(refusal_of("a,b\n"), HasSubstr("without rows"));
  EXPECT_THAT(refusal_of("1.0,2.0\n3,4\n"), HasSubstr("accepted: a header"));
  EXPECT_THAT(refusal_of("a,a\n3,4\n"), HasSubstr("twice"));
  EXPECT_THAT(refusal_of(std::string("a\0b\n1\n", 6)), HasSubstr("UTF-16"));
  EXPECT_THAT(refusal_of("\"a,b\n1,2\n"), HasSubstr("t.csv:1"));
  EXPECT_THROW(read_csv("/nowhere/at/all.csv"), BadInput);
  EXPECT_THROW(read_csv(std::filesystem::temp_directory_path().string()), BadInput);
  EXPECT_THAT(refusal([] { stresses("x;stress_kPa\n1;1,5\n2;1.5\n"); }), HasSubstr("decimal commas"));
}

TEST(Csv, UnitsAreChecked) {
  EXPECT_THAT(refusal([] { stresses("stress\n1\n"); }), HasSubstr("without a unit"));
  EXPECT_THAT(refusal([] { stresses("stress_mm\n1\n"); }), HasSubstr("the unit mm"));
  EXPECT_THAT(refusal([] { stresses("stress [kpa]\n1\n"); }), HasSubstr("kPa"));
  EXPECT_EQ(parse_csv("stress\n2\n", "t").numbers(0, dimension::pressure, "kPa")[0], 2000);
  EXPECT_THROW(parse_csv("stretch_mm\n2\n", "t").numbers(0, dimension::none), BadInput);
}

TEST(Csv, ColumnsAreFoundByHeaderOrName) {
  const auto table = parse_csv("Stress_kPa,stress_MPa,Mode\n1,2,UT\n", "t.csv");
  EXPECT_EQ(table.find("stress_kpa"), 0);
  EXPECT_EQ(table.find("stress_MPa"), 1);
  EXPECT_EQ(table.find("mode"), 2);
  EXPECT_EQ(table.find("none"), std::nullopt);
  EXPECT_EQ(table.find(""), std::nullopt);
  EXPECT_THAT(refusal([&] { table.find("stress"); }), HasSubstr("several columns"));
  EXPECT_THAT(refusal([&] { table.column("none"); }), HasSubstr("Stress_kPa, stress_MPa, Mode"));
}

TEST(Csv, EmptyCellsAreNumbersOnlyWhereAllowed) {
  const auto table = parse_csv("a,v_m_s\n1,5\n2,\n", "t.csv");
  const auto speeds = table.optional_numbers("v", dimension::speed);
  EXPECT_EQ(speeds[0], 5);
  EXPECT_EQ(speeds[1], std::nullopt);
  EXPECT_THAT(refusal([&] { table.numbers("v", dimension::speed); }), HasSubstr("t.csv:3: v_m_s: found an empty cell"));
}

TEST(Csv, RowsAreChosenByTextOrNumber) {
  const auto table = parse_csv("protocol,n\nstrip (x=1),1.0\nequi,2\nstrip (x=1),3\n", "t.csv");
  EXPECT_EQ(table.where({"protocol=strip (x=1)"}).rows.size(), 2u);
  EXPECT_EQ(table.where({"protocol = strip (x=1)", "n=1"}).rows[0].line, 2);
  EXPECT_EQ(table.where({}).rows.size(), 3u);
  const auto none = refusal([&] { table.where({"protocol=Equi"}); });
  EXPECT_THAT(none, HasSubstr("\"strip (x=1)\", \"equi\""));
  EXPECT_THROW(table.where({"protocol"}), BadInput);
  EXPECT_THROW(table.where({"=1"}), BadInput);
  EXPECT_THROW(table.where({"m=1"}), BadInput);
}

TEST(Csv, EveryShippedFileIsRead) {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(PERCAL_DATA)) {
    if (entry.path().extension() != ".csv") continue;
    EXPECT_NO_THROW(EXPECT_FALSE(read_csv(entry.path().string()).rows.empty())) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 12);
}

TEST(Csv, HostileTextIsReadOrRefusedButNeverCrashes) {
  const std::string seeds[] = {
      "\xEF\xBB\xBF# c\r\nmode,stretch,stress [kPa]\r\nUT,1.5,\"12\"\r\nET,2,3e1,\r\n",
      "a_m_s;b_kPa;c\n1,5;2;\"x;\"\"y\"\n;;\n3;4,5e-3;z\n",
      "x\ty [%]\n1\t2\n\n-3\t\xE2\x88\x92"
      "4\n",
  };
  constexpr unsigned seed = 20090501;
  std::mt19937 random(seed);
  const std::string alphabet = ",;\t\"'#\r\n[]()_=.eE+-019 \xEF\xBB\xBF\xFF\x80kPa%";
  int read = 0, refused = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = seeds[round % 3];
    for (int change = 1 + random() % 8; change > 0; --change) {
      const std::size_t at = random() % (text.size() + 1);
      const char c = random() % 16 ? alphabet[random() % alphabet.size()] : static_cast<char>(random() % 256);
      switch (random() % 4) {
        case 0: text.insert(at, 1, c); break;
        case 1:
          if (at < text.size()) text[at] = c;
          break;
        case 2: text.erase(at, random() % 5); break;
        default: text.insert(at, text.substr(random() % (text.size() + 1), random() % 9)); break;
      }
    }
    try {
      const auto table = parse_csv(text, "hostile.csv");
      for (int i = 0; i < static_cast<int>(table.columns.size()); ++i) {
        for (const auto& row : table.rows)
          ASSERT_EQ(table.cells(row).size(), table.columns.size()) << "seed " << seed << " round " << round;
        for (const double value : table.numbers(i, dimension::none)) ASSERT_TRUE(std::isfinite(value));
      }
      ++read;
    } catch (const BadInput& error) {
      ASSERT_THAT(error.what(), HasSubstr("hostile.csv")) << "seed " << seed << " round " << round;
      ++refused;
    }
  }
  EXPECT_GT(read, 0);
  EXPECT_GT(refused, 100);
}

TEST(Csv, RowsAreChosenByComparisonToo) {
  const CsvTable table = parse_csv("test;strain;stress_kPa\na;0,5;1\na;1,0;2\nb;1,5;3\n", "t.csv");
  const auto lines = [&](const std::vector<std::string>& conditions) {
    std::vector<int> all;
    for (const auto& row : table.where(conditions).rows) all.push_back(row.line);
    return all;
  };
  EXPECT_THAT(lines({"strain<1"}), ElementsAre(2));
  EXPECT_THAT(lines({"strain <= 1,0"}), ElementsAre(2, 3));
  EXPECT_THAT(lines({"strain>0.5", "test=a"}), ElementsAre(3));
  EXPECT_THAT(lines({"strain>=1"}), ElementsAre(3, 4));
  EXPECT_THAT(lines({"test!=a"}), ElementsAre(4));
  const auto refused = [&](const std::string& condition) { return refusal([&] { table.where({condition}); }); };
  EXPECT_THAT(refused("strain<2<3"), HasSubstr("a number behind <"));
  EXPECT_THAT(refused("strain>2"), HasSubstr("no row with > \"2\""));
  EXPECT_THAT(refused("test<2"), HasSubstr("t.csv:2: test: found"));
  EXPECT_THAT(refused("strain!2"), HasSubstr("COLUMN<NUMBER"));
}

TEST(Csv, ATableTakesLessThanFiveBytesForEachOfItsFile) {
  std::string text = "a,b\n";
  for (int i = 0; i < 10000; ++i) text += "1,2\n";
  const CsvTable table = parse_csv(text, "t.csv");
  EXPECT_LE(table.text->capacity() + table.rows.capacity() * sizeof(CsvRow), 5 * text.size());
  EXPECT_EQ(table.cell(table.rows[9999], 1), "2");
}

TEST(Csv, AFileAbove64MiBIsRefusedBeforeItIsRead) {
  const test::TemporaryFolder folder;
  const std::string file = folder.path("large.csv");
  std::ofstream(file) << "a,b\n1,2\n";
  std::filesystem::resize_file(file, largest_csv + (std::size_t{8} << 20));
  EXPECT_THAT(refusal([&] { read_csv(file); }), AllOf(HasSubstr("found a file of 72 MiB"), HasSubstr("64 MiB")));
}

}  // namespace
}  // namespace percal
