// docs/how-to as its reader follows it: the files that a page holds, then its commands in order, in one folder.
#include <gmock/gmock.h>

#include <iomanip>

#include "support/program.hpp"

namespace percal {
namespace {

namespace fs = std::filesystem;

struct Step {
  std::string file, text;  // a file of the page
  std::string command;     // or a command
};

// Fenced blocks headed "```kind NAME" are files; indented lines that begin with the program's name are commands.
std::vector<Step> steps_of(const std::string& page) {
  std::vector<Step> steps;
  std::istringstream lines(page);
  const std::string start = "    percal ", fence = "```";
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(start)) steps.push_back({"", "", line.substr(4)});
    if (!line.starts_with(fence)) continue;
    Step file;
    if (const auto blank = line.find(' '); blank != std::string::npos) file.file = line.substr(blank + 1);
    while (std::getline(lines, line) && !line.starts_with(fence)) file.text += line + "\n";
    if (!file.file.empty()) steps.push_back(file);
  }
  return steps;
}

// Words, of which some are in double quotes.
std::vector<std::string> quoted_words(const std::string& command) {
  std::vector<std::string> words;
  std::istringstream stream(command);
  for (std::string word; stream >> std::quoted(word);) words.push_back(word);
  words.erase(words.begin());
  return words;
}

class HowTo : public test::Program {
 protected:
  HowTo() { fs::create_directory_symlink(PERCAL_DATA, path("data")); }

  void follow(const std::string& page) {
    int commands = 0;
    for (const Step& step : steps_of(text_of(test::docs + "how-to/" + page))) {
      if (!step.file.empty()) {
        write(step.file, step.text);
        continue;
      }
      ++commands;
      const test::Ended ended = run(quoted_words(step.command));
      EXPECT_EQ(ended.code, 0) << page << ": " << step.command << "\n" << ended.err;
    }
    EXPECT_GT(commands, 0) << page;
  }
};

TEST_F(HowTo, MyOwnCsv) {
  follow("own_csv.md");
  EXPECT_TRUE(fs::exists(path("mine.html")));
  const auto power = result("muscle.out/result.json")["hypotheses"][0]["parameters"][2];
  EXPECT_EQ(power["name"], "rate_power");
  EXPECT_NEAR(power["value"].get<double>(), 0.169, 0.001);
}

TEST_F(HowTo, RampsAndHolds) {
  follow("relaxation.md");
  EXPECT_TRUE(fs::exists(path("across/target.toml")));
  const auto parameters = result("relaxing.out/result.json")["hypotheses"][0]["parameters"];
  EXPECT_EQ(parameters[3]["name"], "tau");
  EXPECT_GT(parameters[3]["value_s"].get<double>(), 15);
  EXPECT_LT(parameters[3]["value_s"].get<double>(), 50);
}

TEST_F(HowTo, MyOwnParticle) { follow("own_particle.md"); }

TEST_F(HowTo, ManyImpacts) {
  follow("sweeps.md");
  EXPECT_TRUE(fs::exists(path("speeds.out/depths1.svg")));
  EXPECT_EQ(result("groups.out/result.json")["points"].size(), 20U);
}

TEST_F(HowTo, ACardForMySolver) {
  follow("solver_card.md");
  EXPECT_TRUE(fs::exists(path("silicone.inp")));
}

// The script of a task, as the array would start two of them; then the page's own commands.
TEST_F(HowTo, ManyCoresOrACluster) {
  for (const Step& step : steps_of(text_of(test::docs + "how-to/cluster.md")))
    if (!step.file.empty()) write(step.file, step.text);
  const std::string program_folder = fs::path(PERCAL_PROGRAM).parent_path().string();
  for (const char* task : {"0", "1"}) {
    const std::string command = "cd " + folder.string() + " && PATH=" + program_folder +
                                ":$PATH TMPDIR=" + folder.string() + " SLURM_ARRAY_TASK_ID=" + task + " sh sweep.sh";
    ASSERT_EQ(std::system(command.c_str()), 0);
  }
  follow("cluster.md");
  const test::Ended again =
      run({"impact", "data/guha2009/gold.toml", "--elements-per-radius", "6", "--store", "all.store", "--json"});
  EXPECT_EQ(nlohmann::json::parse(again.out)["cost"]["reused"], 5);
}

class SlowHowTo : public HowTo {};

TEST_F(SlowHowTo, MyOwnLayer) { follow("own_layer.md"); }

TEST_F(SlowHowTo, APowder) {
  follow("powders.md");
  EXPECT_TRUE(fs::exists(path("powder.out/dose.svg")));
  EXPECT_FALSE(result("design.out/result.json")["best"].is_null());
}

}  // namespace
}  // namespace percal
