// docs/formats/scene.md against the reader: the same keys, the same defaults, examples that work.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

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

// The keys that the reader says it accepts where it finds one that it does not know.
std::set<std::string> accepted_keys(const std::string& table) {
  const std::string base = examples().at(0);
  const std::string wrong = "zzzzzzzz = 1\n";
  const std::string header = "[" + table + "]\n";
  std::string text = table.empty() ? wrong + base : base + header + wrong;
  if (const std::size_t at = base.find(header); !table.empty() && at != std::string::npos) {
    text = base.substr(0, at + header.size()) + wrong + base.substr(at + header.size());
  }
  if (table == "target.erosion") text += "strain = 0.7\n";
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
  const std::map<std::string, std::string> tables{
      {"Top level", ""},  {"[particle]", "particle"}, {"[target]", "target"}, {"[target.erosion]", "target.erosion"},
      {"[mesh]", "mesh"}, {"[solver]", "solver"},     {"[output]", "output"}};
  const auto described = described_keys();
  EXPECT_EQ(described.size(), tables.size());
  for (const auto& [heading, table] : tables) {
    ASSERT_TRUE(described.contains(heading)) << heading;
    EXPECT_EQ(described.at(heading), accepted_keys(table)) << heading;
  }
}

TEST(ScenePage, TheDefaultsItWritesOutAreTheDefaults) {
  ASSERT_EQ(examples().size(), 2u);
  EXPECT_EQ(parse_scene(examples()[0], "x"), parse_scene(examples()[1], "x"));
}

TEST(ScenePage, TheLongExampleNamesEveryKeyWithADefault) {
  const std::set<std::string> without_default{
      "particle",      "target",  "mesh",   "solver",  "output",         "youngs_modulus", "nu",
      "bulk_to_shear", "erosion", "strain", "measure", "graded_columns", "end_time"};
  for (const auto& [heading, keys] : described_keys()) {
    for (const auto& key : keys) {
      const bool written = examples().at(1).find(key + " = ") != std::string::npos;
      EXPECT_TRUE(written || without_default.contains(key)) << heading << " " << key;
    }
  }
}

}  // namespace
}  // namespace percal
