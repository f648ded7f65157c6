// docs/formats/calibrate.md against the reader and the result: every key that is asked for or written stands on the
// page.
#include <gmock/gmock.h>

#include <map>

#include "calibrate/small_job.hpp"
#include "percal/calibrate/page/page.hpp"
#include "support/described_keys.hpp"

namespace percal {
namespace {

using nlohmann::json;
using test::Keys;
using testing::HasSubstr;

class CalibratePage : public calibrate_test::SmallJob {
 protected:
  static std::string page() { return text_of(test::docs + "formats/calibrate.md"); }

  static Keys described() { return test::described_keys(page()); }

  // "[parameters.mu]" is described as [parameters.NAME].
  static std::string heading_of(const std::string& header) {
    if (header.starts_with("[[targets.")) return "[[targets.NAME.covers]]";
    for (const char* named : {"parameters", "materials", "scatter", "targets"})
      if (header.starts_with("[" + std::string(named) + ".")) return "[" + std::string(named) + ".NAME]";
    return header;
  }

  void collect(const std::string& text, Keys& keys) const {
    const auto read = [this](const std::string& job) { read_calibration_job(write("page.toml", job)); };
    test::collect_accepted_keys(read, text, keys, heading_of);
  }
};

TEST_F(CalibratePage, DescribesEveryKeyThatIsAcceptedAndNoOther) {
  Keys keys;
  collect(calibrate_test::small_job, keys);
  std::string layers = calibrate_test::small_job;
  const std::string of_hand = "name = \"by hand\"\nmaterial = \"hard\"";
  layers.replace(layers.find(of_hand), of_hand.size(), "name = \"by hand\"\ntarget = \"dressed\"");
  layers.insert(layers.find("[materials.soft]"), calibrate_test::layers_of_a_job + "\n");
  collect(layers, keys);
  collect(text_of(test::docs + "../tools/templates/variants/calibrate_bodies.toml"), keys);
  // Read only where they are there, or where others are not.
  for (const char* key :
       {"particle", "particle_density", "radius", "radius_column", "diameter", "speed", "depth_error_column"})
    keys["[[shots]]"].insert(key);
  keys["[[ridge_points]]"].insert("where");
  keys["[materials.NAME]"].insert("erosion_length");
  keys["[[materials.NAME.relaxation]]"] = {"share", "time"};
  EXPECT_EQ(keys, described());
}

TEST_F(CalibratePage, NamesTheDefaultsOfTraining) {
  const std::string all = page(), section = all.substr(all.find("## [training]"),
                                                       all.find("## [solver]") - all.find("## [training]"));
  const auto default_of = [&](const std::string& key) {
    std::istringstream cells(section.substr(section.find("| `" + key + "`")));
    std::string cell;
    for (int column = 0; column < 5; ++column) std::getline(cells, cell, '|');
    return std::stod(cell);
  };
  const TrainingSettings defaults;
  EXPECT_EQ(default_of("coarse"), defaults.coarse);
  EXPECT_EQ(default_of("fine"), defaults.fine);
  EXPECT_EQ(default_of("verify"), defaults.verify);
  EXPECT_EQ(default_of("initial"), defaults.initial);
  EXPECT_EQ(default_of("batch"), defaults.batch);
  EXPECT_EQ(default_of("most"), defaults.most);
  EXPECT_EQ(default_of("fine_share"), defaults.fine_share);
  EXPECT_EQ(default_of("accuracy"), defaults.accuracy);
  EXPECT_EQ(default_of("failures_tolerated"), defaults.failures_tolerated);
  EXPECT_EQ(default_of("verify_replicates"), defaults.verify_replicates);
  EXPECT_EQ(default_of("seed"), defaults.seed);
}

void collect_keys(const json& value, std::set<std::string>& keys) {
  if (value.is_object())
    for (const auto& [key, inner] : value.items()) {
      keys.insert(key);
      collect_keys(inner, keys);
    }
  if (value.is_array())
    for (const json& inner : value) collect_keys(inner, keys);
}

TEST_F(CalibratePage, NamesEveryKeyOfAResult) {
  const auto job = read_job();
  std::set<std::string> keys;
  collect_keys(calibration_to_json(job, calibrate_test::made_up_result(job)), keys);
  EXPECT_GT(keys.size(), 100u);
  const std::string all = page(), results = all.substr(all.find("# Results"));
  for (const auto& key : keys) EXPECT_THAT(results, HasSubstr("`" + key + "`"));
}

TEST_F(CalibratePage, ReadsTheBlocksThatMissEachOther) {
  // The keys above that the small job does not use: a set with one ball, its size and its speed in the job.
  const auto job = read_job(
      {{"particle_column = \"ball\"\nparticle_density_column = \"density_kg_m3\"\ndiameter_column = "
        "\"diameter_mm\"\nspeed_column = \"speed_m_s\"",
        "particle = \"bead\"\nparticle_density = \"2500 kg/m3\"\nradius = \"1 mm\"\nspeed = \"30 m/s\""},
       {"depth_error = \"5 %\"\ndepth_error_where = [\"ball=steel\"]", "depth_error_column = \"diameter_mm\""}});
  EXPECT_EQ(job.shots[0].label, "bead 2 mm at 30 m/s into soft");
  EXPECT_DOUBLE_EQ(job.shots[0].density, 2500);
  EXPECT_DOUBLE_EQ(job.shots[0].depth_error, 3e-3);
}

}  // namespace
}  // namespace percal
