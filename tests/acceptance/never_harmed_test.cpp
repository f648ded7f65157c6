// What a command reads is never lost by what it writes, whatever name leads to it.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "support/program.hpp"

namespace percal {
namespace {

using test::Ended;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

const std::string similar_job = "[prototype]\nscene = \"s.toml\"\n[model]\nradius = \"2 mm\"\n"
                                "particle_density = \"7800 kg/m3\"\nspeed = \"30 m/s\"\n";

class NeverHarmed : public test::Program {
 protected:
  NeverHarmed() {
    write("s.toml", text_of(test::test_data + "layer.toml"));
    write("j.toml", similar_job);
    fs::create_symlink("s.toml", path("link.toml"));
    fs::create_hard_link(path("s.toml"), path("hard.png"));
    fs::create_directories(path("out/fields"));
    fs::copy_file(path("s.toml"), path("out/fields/s.pvd"));
    fs::copy_file(PERCAL_DATA "/synthetic/joint_curve.csv", path("out/result.json"));
  }

  // Every input with its text. Kept runs do not count.
  std::map<std::string, std::string> texts() const {
    std::map<std::string, std::string> all;
    for (const std::string& name : files())
      if (fs::is_regular_file(path(name)) && !name.starts_with("store")) all[name] = read(name);
    return all;
  }
  void expect_refused(const std::string& command) const {
    const auto before = texts();
    const Ended ended = run(test::words_of(command));
    EXPECT_EQ(ended.code, 2) << command << "\n" << ended.out << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("a file that this command reads")) << command;
    EXPECT_THAT(ended.out, IsEmpty()) << command;
    EXPECT_EQ(texts(), before) << command;
    EXPECT_FALSE(fs::exists(path("store"))) << command << ": found out before anything is run";
  }
};

TEST_F(NeverHarmed, AnInputOfAnImpactOrAStudy) {
  const std::string store = " --store store";
  for (const std::string name : {"s.toml", "./s.toml", "link.toml", "hard.png"})
    expect_refused("impact s.toml --out none --history " + name + store);
  expect_refused("impact link.toml --out none --history s.toml" + store);
  expect_refused("impact s.toml --out none --picture hard.png" + store);
  expect_refused("study s.toml --error-vs-time --out none --markdown s.toml" + store);
}

TEST_F(NeverHarmed, AnEarlierSeriesIsRemovedButNoInput) {
  const auto before = texts();
  const Ended ended = run(test::words_of("impact out/fields/s.pvd --out out --fields every=10% --store store"));
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_EQ(texts(), before);
}

TEST_F(NeverHarmed, AnInputOfAFitOrAScaling) {
  expect_refused("fit out/result.json --out out");
  expect_refused("scale j.toml --out none --write-scene j.toml");
  expect_refused("scale j.toml --out none --write-scene link.toml");
}

TEST_F(NeverHarmed, AResultOrACard) {
  ASSERT_EQ(run({"fit", PERCAL_DATA "/synthetic/joint_curve.csv", "--out", "gel", "--quiet"}).code, 0);
  const std::string card = "card write gel/result.json --solver febio --density 1010kg/m3 --nu 0.49 --file ";
  ASSERT_EQ(run(test::words_of(card + "k.feb")).code, 0);
  fs::create_symlink("k.feb", path("link.feb"));
  expect_refused("report gel/result.json -o gel/result.json");
  expect_refused(card + "gel/result.json");
  expect_refused("card check k.feb --csv k.feb");
  expect_refused("card check link.feb --csv k.feb");
}

TEST_F(NeverHarmed, AStoreIsNeitherOverwrittenNorMergedIntoItself) {
  ASSERT_EQ(run(test::words_of("impact s.toml --out none --quiet --store a.store")).code, 0);
  const auto before = texts();
  EXPECT_EQ(run(test::words_of("impact s.toml --out none --quiet --store a.store --history a.store")).code, 2);
  EXPECT_EQ(run(test::words_of("store merge a.store --store a.store")).code, 2);
  EXPECT_EQ(texts(), before);
}

TEST_F(NeverHarmed, AJobWritesItsSceneBesideItselfOrWithTheResults) {
  const std::string scene_text = read("s.toml"), letter = "a letter\n";
  write("here/s.toml", scene_text);
  write("here/notes.txt", letter);
  fs::create_directories(path("here/folder"));
  fs::create_symlink("..", path("here/away"));
  const auto scale_to = [&](const std::string& scene, const std::string& options = " --out res") {
    write("here/j.toml", similar_job + "[output]\nscene = \"" + scene + "\"\n");
    return run(test::words_of("scale here/j.toml --quiet" + options));
  };
  EXPECT_EQ(scale_to("new.toml").code, 0);
  EXPECT_EQ(scale_to("new.toml").code, 0) << "a scene may be written again";
  EXPECT_EQ(scale_to("below/new.toml").code, 0);
  EXPECT_EQ(scale_to("../res/new.toml").code, 0) << "with the results";
  for (const std::string& scene : {std::string("../outside.toml"), path("outside.toml"), std::string("away/outside.toml")})
    EXPECT_THAT(scale_to(scene).err, AllOf(HasSubstr("output.scene"), HasSubstr("in the job's folder"))) << scene;
  for (const std::string scene : {"notes.txt", "folder"})
    EXPECT_THAT(scale_to(scene).err, AllOf(HasSubstr("output.scene"), HasSubstr("is no scene"))) << scene;
  EXPECT_EQ(scale_to("j.toml").code, 2);
  EXPECT_EQ(scale_to("s.toml").code, 2) << "the scene that it reads";
  EXPECT_EQ(read("here/notes.txt"), letter);
  EXPECT_EQ(read("here/s.toml"), scene_text);
  EXPECT_FALSE(fs::exists(path("outside.toml")));
}

}  // namespace
}  // namespace percal
