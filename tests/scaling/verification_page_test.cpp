// The table of docs/verification/guha2009_scaling.md is computed, and this test holds the page to it. After a change:
//   PERCAL_WRITE_PAGES=1 scaling_test --gtest_filter='VerificationPage.*'
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "guha2009.hpp"
#include "percal/text/file.hpp"

namespace percal {
namespace {

using namespace guha2009;

const std::string page = std::string(PERCAL_DATA) + "/../docs/verification/guha2009_scaling.md";

// Lines of a table: what, printed in the thesis ("" where it prints none), ours, both in the unit named.
class Table {
 public:
  Table() : text_("| what | unit | printed | percal | difference |\n| --- | --- | --- | --- | --- |\n") {}

  void add(const std::string& what, const std::string& unit, const std::string& printed, double ours, int digits) {
    auto difference = printed.empty() ? "" : fmt::format("{:+.2f} %", 100 * (ours / std::stod(printed) - 1));
    text_ += fmt::format("| {} | {} | {} | {:.{}f} | {} |\n", what, unit, printed.empty() ? "-" : printed, ours, digits,
                         difference);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void add_similarity(Table& table) {
  table.add("model's target density", "kg/m3", "464", *steel().target_density, 2);
  table.add("model's modulus over skin's (Eq. 4-1)", "-", "0.00755", modulus_ratio(gold(), steel()), 6);
  table.add("model's penetration", "cm", "4.13", map_penetration(*gold().penetration, gold(), steel()) * 100, 3);
  auto ridge = guha2009::table("ridge");
  auto skin = ridge.numbers("mu_skin", dimension::pressure);
  auto printed = ridge.texts("mu_model_kPa");
  for (std::size_t i = 0; i < skin.size(); ++i)
    table.add(fmt::format("Table 4-1: model's modulus for {:g} MPa", skin[i] / 1e6), "kPa", printed[i],
              map_modulus(skin[i], gold(), steel()) / 1e3, 2);
}

void add_gelatin(Table& table) {
  auto law = gelatin_law({"source_of_mu=curve"}, Misfit::absolute);
  table.add("k of mu = k c^1.8, three measured rows, absolute", "kPa", "", law.factor / 1e3, 5);
  table.add("k with 10 wt% added", "kPa", "", gelatin_law({}, Misfit::absolute).factor / 1e3, 5);
  table.add("k, relative least squares", "kPa", "", gelatin_law({"source_of_mu=curve"}, Misfit::relative).factor / 1e3,
            5);
  auto free = gelatin_law_with_free_exponent();
  table.add("n, free", "-", "", free.exponent, 3);
  table.add("n, free: standard error", "-", "", *free.exponent_error, 3);
  table.add("k, n free", "kPa", "", free.factor / 1e3, 5);
  table.add("quasi-static modulus at 10 wt%", "kPa", "8.61", law.at(10) / 1e3, 3);
  table.add("high-rate modulus at 10 wt%", "kPa", "80",
            high_rate_modulus(law.at(10), constant("gelatin_rate_factor")) / 1e3, 2);
  table.add("rate factor, mean of the measured rows", "-", "9.74", rate_factor().factor, 3);
}

void add_lines(Table& table) {
  table.add("3.18 mm steel line: slope", "cm per kg/(m s)", "0.0049", steel_line().slope * 100, 7);
  table.add("3.18 mm steel line: intercept", "cm", "-0.7794", steel_line().intercept * 100, 5);
  table.add("45 degree line: slope", "cm per m/s", "0.1306", angular_line("45").slope * 100, 5);
  table.add("45 degree line: intercept", "cm", "-2.9022", angular_line("45").intercept * 100, 4);
  table.add("60 degree line: slope", "cm per m/s", "", angular_line("60").slope * 100, 5);
  table.add("60 degree line: intercept", "cm", "", angular_line("60").intercept * 100, 4);
}

void add_depths(Table& table) {
  auto cases = gold_cases(steel_line());
  auto printed = guha2009::table("gold_skin").texts("scaled_um");
  for (std::size_t i = 0; i < cases.size(); ++i)
    table.add(fmt::format("Table 4-4: {:.1f} um gold at {:g} m/s", cases[i].radius * 1e6, cases[i].speed), "um",
              printed[i], cases[i].scaled * 1e6, 3);
  table.add("Table 4-4: mean error", "%", "11.08", 100 * mean_error(cases, &GoldCase::scaled), 2);
  auto depths = equal_mass_depths();
  auto shapes = guha2009::table("angularity").texts("penetration_cm");
  table.add("Table 5-3: rhombus, as measured", "cm", shapes[0], depths.rhombus * 100, 3);
  table.add("Table 5-3: square", "cm", shapes[1], depths.square * 100, 3);
  table.add("Table 5-3: sphere", "cm", shapes[2], depths.sphere * 100, 3);
}

void add_skin(Table& table) {
  double skin = map_modulus(113e3, steel(), gold());
  double quasi_static = quasi_static_modulus(skin, constant("skin_rate_factor"));
  table.add("skin's high-rate modulus, as given", "MPa", "15", skin / 1e6, 3);
  table.add("skin's quasi-static modulus, as given", "MPa", "0.75", quasi_static / 1e6, 4);
  table.add("skin's quasi-static Young's modulus, as given", "MPa", "2.25",
            youngs_modulus_incompressible(quasi_static) / 1e6, 3);
}

void add_errata(Table& table) {
  double density = constant("steel_angular_density"), root = std::numbers::sqrt2;
  table.add("rhombus's mass from its dimensions", "g", "0.7027",
            6e-3 * 6e-3 * std::sin(std::numbers::pi / 3) * 3.1e-3 * density * 1e3, 4);
  table.add("square's mass from its dimensions", "g", "0.7509", 5.83e-3 * 5.83e-3 * 2.9e-3 * density * 1e3, 4);
  table.add("square's impact area", "mm2", "23.93", 5.64 * root * 2.9, 2);
  table.add("rhombus's impact area", "mm2", "18.29", 6.0 * 3.1, 2);
  table.add("sphere's impact area", "mm2", "24.28",
            std::numbers::pi * std::pow(equal_mass_radius(0.7027e-3, constant("steel_density")) * 1e3, 2), 2);
  table.add("square at 40 m/s from the printed line", "cm", "2.31", 0.1306 * 40 - 2.9022, 2);
  table.add("square at 40 m/s from the refitted line", "cm", "2.31", angular_line("45").at(40) * 100, 2);
  auto ball = steel(), sphere = ball;
  sphere.radius = 2.78e-3;
  sphere.speed = 40;
  table.add("sphere of Table 5-3 from the printed line", "cm", "2.77",
            depth_from_model(printed_steel_line(), ball, 1, sphere) * 100, 2);
  table.add("Table 4-4: mean error with the printed line", "%", "11.08",
            100 * mean_error(gold_cases(printed_steel_line()), &GoldCase::scaled), 2);
  table.add("Table 4-4: LS-DYNA's mean error", "%", "", 100 * mean_error(gold_cases(steel_line()), &GoldCase::fe), 2);
  table.add("standard error of 26 um, 18 um a standard deviation", "um", "18",
            18 / std::sqrt(constant("calibration_particles")), 2);
  table.add("LS-DYNA, 60 degrees: mean error of six shots", "%", "5.2", 100 * angular_fe_error("60", 0), 2);
  table.add("LS-DYNA, 60 degrees: without the calibrated shot", "%", "", 100 * angular_fe_error("60", 40), 2);
  table.add("LS-DYNA, 45 degrees: mean error of six shots", "%", "4.7", 100 * angular_fe_error("45", 0), 2);
  table.add("LS-DYNA, 45 degrees: without the calibrated shot", "%", "", 100 * angular_fe_error("45", 50), 2);
}

// `text` with what stands between <!-- NAME --> and <!-- end --> replaced.
std::string with_table(const std::string& text, const std::string& name, const Table& table) {
  std::string begin = "<!-- " + name + " -->\n", end = "<!-- end -->";
  auto from = text.find(begin);
  auto to = text.find(end, from);
  if (from == std::string::npos || to == std::string::npos) return "the page has no table " + name;
  from += begin.size();
  return text.substr(0, from) + table.text() + text.substr(to);
}

TEST(VerificationPage, HoldsTheNumbersThatAreComputedNow) {
  Table chain, errata;
  add_similarity(chain);
  add_gelatin(chain);
  add_lines(chain);
  add_depths(chain);
  add_skin(chain);
  add_errata(errata);
  auto written = read_file(page);
  auto computed = with_table(with_table(written, "chain", chain), "errata", errata);
  if (std::getenv("PERCAL_WRITE_PAGES"))
    write_file(page, computed);
  else
    EXPECT_EQ(written, computed)
        << "write it anew: PERCAL_WRITE_PAGES=1 scaling_test --gtest_filter='VerificationPage.*'";
}

}  // namespace
}  // namespace percal
