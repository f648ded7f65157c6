// docs/tutorial as its reader follows it: every command in order, in one folder, with one store.
// Minutes of processor time: label slow.
#include <sstream>

#include "support/program.hpp"

namespace percal {
namespace {

namespace fs = std::filesystem;

class SlowTutorial : public test::Program {
 protected:
  SlowTutorial() { fs::create_directory_symlink(PERCAL_DATA, path("data")); }

  // The indented lines that begin with the program's name, without it.
  static std::vector<std::string> commands() {
    const std::string start = "    percal ";
    std::vector<std::string> found;
    std::istringstream lines(text_of(test::docs + "tutorial/README.md"));
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with(start)) found.push_back(line.substr(start.size()));
    return found;
  }
};

TEST_F(SlowTutorial, EveryCommandDoesWhatThePageSays) {
  const std::vector<std::string> found = commands();
  ASSERT_GE(found.size(), 15u);
  for (const std::string& command : found) {
    const test::Ended ended = run(test::words_of(command));
    EXPECT_EQ(ended.code, 0) << "percal " << command << "\n" << ended.err;
  }
  for (const char* file : {"block.k", "block_speeds/shots.csv", "skin.out/result.json", "skin.k", "skin.inp",
                           "skin.html", "bb.png", "bb.out/report.html", "skin_cube.inp"})
    EXPECT_TRUE(fs::exists(path(file))) << file;
}

}  // namespace
}  // namespace percal
