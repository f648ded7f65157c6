// docs/formats/identify.md against the reader and the result: every key that is asked for or written stands on the page.
#include <gmock/gmock.h>

#include <map>

#include "acceptance/liver.hpp"
#include "percal/identify/job.hpp"
#include "support/described_keys.hpp"

namespace percal {
namespace {

using acceptance::LiverJob;
using nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;
using test::Keys;

class IdentifyPage : public LiverJob {
 protected:
  static std::string page() { return text_of(test::docs + "formats/identify.md"); }

  static Keys described() { return test::described_keys(page()); }

  void collect(const std::string& text, Keys& keys) const {
    const auto read = [this](const std::string& job) { read_identify_job(write("page.toml", job)); };
    test::collect_accepted_keys(read, text, keys);
  }
};

TEST_F(IdentifyPage, DescribesEveryKeyThatIsAcceptedAndNoOther) {
  for (const auto& table : fs::directory_iterator(test::guha2009))
    if (table.path().extension() == ".csv") fs::copy_file(table.path(), folder / table.path().filename());
  Keys keys;
  collect(text_of(test::guha2009 + "skin.toml"), keys);
  collect(text_of(test::test_data + "liver/liver.toml"), keys);
  keys["[scaled_line.cases]"].insert("particle_column");  // as in [[predictions]]
  // Read only where they are there.
  for (const char* block : {"[gelatin.formulations]", "[alpha.target]", "[[predictions]]", "[[trends]]",
                            "[scaled_line.shots]", "[scaled_line.cases]"})
    keys[block].insert("where");
  keys["[card]"].insert("comments");
  EXPECT_EQ(keys, described());
}

TEST_F(IdentifyPage, NamesEveryKeyOfTheReference) {
  std::set<std::string> known{"name"};
  for (const auto& [key, dimension] : reference_keys()) known.insert(key);
  EXPECT_EQ(described()["[reference]"], known);
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

TEST_F(IdentifyPage, NamesEveryKeyOfAResult) {
  write("pairs.csv", "mu_MPa,strain\n17.5,0.3\n11.7,0.6\n5.65,0.8\n");
  job({{"value = 5",
        "scan = [4, 6]\nelements_per_radius = 3\nreplicates = 2\n[alpha.target]\nfile = \"pairs.csv\"\nmu = "
        "\"mu\"\nerosion_strain = \"strain\""}});
  run({"identify", "liver.toml", "--store", "store", "--out", "out", "--quiet"});
  std::set<std::string> keys;
  collect_keys(result("out/result.json"), keys);
  EXPECT_GT(keys.size(), 60u);
  const std::string all = page(), results = all.substr(all.find("# Results"));
  for (const auto& key : keys) EXPECT_THAT(results, HasSubstr("`" + key + "`"));
}

}  // namespace
}  // namespace percal
