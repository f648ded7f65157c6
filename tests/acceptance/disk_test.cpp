// Folders that cannot be written and disks that are full: exit code 4, before anything is computed where that can be known,
// and never a file that is half there.
#include <gmock/gmock.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include "acceptance/liver.hpp"
#include "percal/store/store.hpp"

namespace percal {
namespace {

using acceptance::LiverJob;
using acceptance::without_cost;
using nlohmann::json;
using test::Ended;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
namespace fs = std::filesystem;

constexpr int page = 4096;

class Disk : public LiverJob {
 protected:
  Disk() {
    job();
    write("layer.toml", text_of(test::test_data + "layer.toml"));
    write("in_the_way", "a file, not a folder\n");
  }
  ~Disk() override {
    if (mounted_) umount2(path("disk").c_str(), MNT_DETACH);
  }

  // A disk of that many bytes at "disk", if this user may have one.
  bool disk_of(long bytes) {
    fs::create_directories(path("disk"));
    const std::string size = "size=" + std::to_string(bytes);
    const unsigned long flags = mounted_ ? MS_REMOUNT : 0;
    mounted_ = mount("tmpfs", path("disk").c_str(), "tmpfs", flags, size.c_str()) == 0 || mounted_;
    return mounted_;
  }
  static long pages_of(long bytes) { return (bytes + page - 1) / page; }

  Ended identify(const std::string& out, const std::string& store) const {
    return run({"identify", "liver.toml", "--out", out, "--store", store});
  }
  void expect_failure(const Ended& ended, const std::string& says) const {
    EXPECT_EQ(ended.code, 4) << ended.err;
    EXPECT_THAT(ended.err, AllOf(HasSubstr("percal: "), HasSubstr(says), Not(HasSubstr("internal error"))));
  }

 private:
  bool mounted_ = false;
};

TEST_F(Disk, AFolderThatCannotBeIsRefusedBeforeAnythingIsComputed) {
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"identify", "liver.toml", "--out", "in_the_way/out"},
                                             {"impact", "layer.toml", "--out", "in_the_way/out"},
                                             {"impact", "layer.toml", "--out", "in_the_way"},
                                             {"impact", "layer.toml", "--history", "in_the_way/history.csv"},
                                             {"impact", "layer.toml", "--history", "."}}) {
    auto words = command;
    words.insert(words.end(), {"--store", "store"});
    const Ended ended = run(words);
    expect_failure(ended, command[3] == "." ? ".: is a folder" : "in_the_way");
    EXPECT_THAT(ended.out, IsEmpty());
    EXPECT_FALSE(fs::exists(path("store"))) << "nothing was run";
  }
}

TEST_F(Disk, AStoreThatIsNoStoreIsLeftAsItIs) {
  write("store",
        "this is a letter to somebody, and long enough not to be taken for a file that has only just been begun\n");
  const std::string before = read("store");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"identify", "liver.toml", "--out", "out"}, {"impact", "layer.toml"}}) {
    auto words = command;
    words.insert(words.end(), {"--store", "store"});
    const Ended ended = run(words);
    expect_failure(ended, "is not a store");
    EXPECT_THAT(ended.out, Not(HasSubstr("depth")));
  }
  EXPECT_EQ(read("store"), before);
  expect_failure(run({"impact", "layer.toml", "--store", "in_the_way/store"}), "in_the_way");
  expect_failure(run({"impact", "layer.toml", "--store", "."}), "store");
}

TEST_F(Disk, AFullOneCostsTheResultButNotTheRuns) {
  if (!disk_of(3 * page)) GTEST_SKIP() << "only root may mount a small disk";
  expect_failure(identify("disk/out", "store"), "result.json");
  EXPECT_EQ(files("disk"), (std::set<std::string>{"disk/out"})) << "no part of a result, no temporary file";
  const Ended again = identify("out", "store");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(result("out/result.json")["cost"]["runs"], 0);
}

TEST_F(Disk, AFullOneLeavesNoHalfCard) {
  ASSERT_EQ(identify("out", "store").code, 0);
  const long size = static_cast<long>(read("out/result.json").size());
  if (!disk_of((pages_of(size) + 1) * page)) GTEST_SKIP() << "only root may mount a small disk";
  expect_failure(identify("disk", "store"), "liver_abaqus.inp");
  EXPECT_EQ(files("disk"), (std::set<std::string>{"disk/result.json", "disk/liver_lsdyna.k"})) << "room for these";
  EXPECT_EQ(without_cost(result("disk/result.json")), without_cost(result("out/result.json")));
  EXPECT_EQ(read("disk/liver_lsdyna.k"), read("out/liver_lsdyna.k"));
}

TEST_F(Disk, AnOlderResultOutlivesAFullOne) {
  ASSERT_EQ(identify("out", "store").code, 0);
  const long size = static_cast<long>(read("out/result.json").size());
  if (!disk_of(pages_of(size) * page)) GTEST_SKIP() << "only root may mount a small disk";
  write("disk/result.json", "the older one\n");
  expect_failure(identify("disk", "store"), "disk/result.json");
  EXPECT_EQ(read("disk/result.json"), "the older one\n");
  EXPECT_EQ(files("disk"), (std::set<std::string>{"disk/result.json"}));
}

TEST_F(Disk, AFullOneUnderTheStoreEndsTheRunAndARoomierOneGoesOn) {
  ASSERT_EQ(identify("whole", "whole.store").code, 0);
  if (!disk_of(30 * page)) GTEST_SKIP() << "only root may mount a small disk";
  expect_failure(identify("out", "disk/store"), "disk/store");
  EXPECT_THAT(files("out"), IsEmpty()) << "no result of half a job";
  ASSERT_TRUE(disk_of(1000 * page));
  const long kept = Store(path("disk/store")).size();
  EXPECT_GT(kept, 0);
  ASSERT_EQ(identify("out", "disk/store").code, 0);
  const json rest = result("out/result.json"), whole = result("whole/result.json");
  EXPECT_EQ(without_cost(rest), without_cost(whole));
  EXPECT_EQ(rest["cost"]["runs"].get<long>() + kept, whole["cost"]["runs"].get<long>())
      << "what was stored was not run again";
}

TEST_F(Disk, AFileThatMayNotGrowIsAFailureAndNotTheEndOfTheProcess) {
  const auto at_most = [](rlim_t bytes) {
    return [bytes] {
      const rlimit limit{bytes, bytes};
      setrlimit(RLIMIT_FSIZE, &limit);
    };
  };
  const std::string job =
      "[prototype]\nscene = \"layer.toml\"\n[model]\nradius = \"2 mm\"\nparticle_density = \"7800 kg/m3\"\nspeed = "
      "\"30 m/s\"\n";
  write("scale.toml", job);
  const Ended scale = run({"scale", "scale.toml", "--quiet", "--out", "out"}, at_most(1000));
  expect_failure(scale, "out");
  EXPECT_THAT(files("out"), IsEmpty());
  expect_failure(run({"impact", "layer.toml", "--store", "store"}, at_most(6000)), "store");
}

TEST_F(Disk, AFullStandardOutputIsAFailureToo) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"identify", "liver.toml", "--store", "store"},
                                             {"identify", "liver.toml", "--store", "store", "--json"},
                                             {"impact", "layer.toml", "--store", "store"},
                                             {"impact", "layer.toml", "--store", "store", "--json"},
                                             {"impact", "layer.toml", "--check"},
                                             {"scale", test::guha2009 + "similar.toml", "--json"}}) {
    const Ended ended = run(command, test::into_a_full_disk);
    expect_failure(ended, "standard output");
  }
}

}  // namespace
}  // namespace percal
