// docs/formats/scene.md against the reader: the same keys, the same defaults, examples that work.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "percal/scene/scene_toml.hpp"
#include "percal/text/file.hpp"

namespace percal {
namespace {

std::string page() { return read_file(PERCAL_DATA "/../docs/formats/scene.md"); }

std::vector<std::string> examples() {
  std::vector<std::string> found;
  const std::string text = page(), open = "```toml\n", close = "```";
  for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    at += open.size();
    const std::size_t end = text.find(close, at);
    found.push_back(text.substr(at, end - at));
    at = end;
  }
  return found;
}

// The keys of the page's tables, by the heading they stand under.
std::map<std::string, std::set<std::string>> described_keys() {
  std::map<std::string, std::set<std::string>> keys;
  std::istringstream lines(page());
  std::string heading;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("## ")) heading = line.substr(3);
    if (line.starts_with("| `")) keys[heading].insert(line.substr(3, line.find('`', 3) - 3));
  }
  return keys;
}

// A heading of the page, the place in a scene where an unknown key is put, and what the reader needs beside it.
struct TablePlace {
  std::string heading;
  std::string header;  // "[mesh]"; empty at the top level
  std::string needs;   // lines of the table
  std::string before;  // lines of the scene before the table
};

const std::vector<TablePlace>& places() {
  static const std::string erosion = "[target.erosion]\nstrain = 0.7\n";
  static const std::string layer = "[[below]]\ndensity = \"1 t/m3\"\nmu = \"1 MPa\"\nalpha = 2\ndepth = \"1 mm\"\n";
  static const std::vector<TablePlace> all{
      {"Top level", "", "", ""},
      {"[particle]", "[particle]", "", ""},
      {"[target]", "[target]", "", ""},
      {"[target.fibres]", "[target.fibres]", "k1 = \"1 MPa\"\nk2 = 1\n", ""},
      {"[target.erosion]", "[target.erosion]", "strain = 0.7\n", ""},
      {"[[target.relaxation]]", "[[target.relaxation]]", "share = 0.3\ntime = \"1 us\"\n", ""},
      {"[[below]]", "[[below]]", layer.substr(layer.find('\n') + 1), ""},
      {"[below.fibres]", "[below.fibres]", "k1 = \"1 MPa\"\nk2 = 1\n", layer},
      {"[below.erosion]", "[below.erosion]", "strain = 0.7\n", erosion + layer},
      {"[mesh]", "[mesh]", "", ""},
      {"[solver]", "[solver]", "", ""},
      {"[output]", "[output]", "", ""}};
  return all;
}

// The keys that the reader says it accepts where it finds one that it does not know.
std::set<std::string> accepted_keys(const TablePlace& place) {
  const std::string base = examples().at(0), wrong = "zzzzzzzz = 1\n", header = place.header + "\n";
  std::string text = base + place.before + header + wrong + place.needs;
  if (const std::size_t at = base.find(header); at != std::string::npos)
    text = base.substr(0, at + header.size()) + wrong + base.substr(at + header.size());
  if (place.header.empty()) text = wrong + base;
  std::set<std::string> keys;
  try {
    parse_scene(text, "x");
  } catch (const BadInput& error) {
    std::string message = error.what();
    const std::string accepted = "accepted: ";
    message.erase(0, message.find(accepted) + accepted.size());
    std::istringstream words(message);
    for (std::string word; std::getline(words >> std::ws, word, ',');) keys.insert(word);
  }
  return keys;
}

TEST(ScenePage, DescribesEveryKeyThatIsAcceptedAndNoOther) {
  const auto described = described_keys();
  EXPECT_EQ(described.size(), places().size());
  for (const TablePlace& place : places()) {
    ASSERT_TRUE(described.contains(place.heading)) << place.heading;
    EXPECT_EQ(described.at(place.heading), accepted_keys(place)) << place.heading;
  }
}

TEST(ScenePage, TheDefaultsItWritesOutAreTheDefaults) {
  EXPECT_EQ(parse_scene(examples()[0], "x"), parse_scene(examples()[1], "x"));
}

TEST(ScenePage, EveryExampleIsAScene) {
  EXPECT_GE(examples().size(), 4u);
  for (const auto& example : examples()) EXPECT_NO_THROW(parse_scene(example, "x")) << example;
}

TEST(ScenePage, TheLongExampleNamesEveryKeyWithADefault) {
  const std::set<std::string> without_default{"particle",
                                              "target",
                                              "below",
                                              "mesh",
                                              "solver",
                                              "output",
                                              "youngs_modulus",
                                              "nu",
                                              "erosion",
                                              "relaxation",
                                              "strain",
                                              "measure",
                                              "stress",
                                              "energy",
                                              "share",
                                              "time",
                                              "vertices",
                                              "side",
                                              "tip_angle",
                                              "orientation",
                                              "rotation",
                                              "mass",
                                              "thickness",
                                              "diameter",
                                              "bulk_to_shear",
                                              "end_time",
                                              "graded_columns",
                                              "width",
                                              "length",
                                              "length_in_radii",
                                              "cell",
                                              "strain_below",
                                              "fibres",
                                              "k1",
                                              "k2",
                                              "kappa",
                                              "angle",
                                              "growth",
                                              "stretch_across",
                                              "fine_thickness",
                                              "fine_depth",
                                              "stl_unit",
                                              "whole_across"};
  for (const auto& [heading, keys] : described_keys()) {
    for (const auto& key : keys) {
      const bool written = examples().at(1).find(key + " = ") != std::string::npos;
      EXPECT_TRUE(written || without_default.contains(key)) << heading << " " << key;
    }
  }
}

}  // namespace
}  // namespace percal
