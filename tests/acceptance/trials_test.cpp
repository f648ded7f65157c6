// Kills and crowds, on a store that others have filled: whatever ends a command and whoever works beside it, the same command ends
// with the same depths, no finished run is lost, and nothing half-written is left.
#include <gmock/gmock.h>
#include <sqlite3.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "acceptance/gel.hpp"
#include "acceptance/liver.hpp"
#include "percal/store/store.hpp"

namespace percal {
namespace {

using acceptance::LiverJob;
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

constexpr int others = 10000;  // rows of the store that no command of these asks for

// Every number under a key that speaks of a depth, in the order of the result.
void add_depths(const json& value, bool of_depth, std::vector<double>& depths) {
  if (value.is_number() && of_depth) depths.push_back(value);
  if (value.is_object())
    for (const auto& [key, below] : value.items()) add_depths(below, of_depth || key.starts_with("depth"), depths);
  if (value.is_array())
    for (const json& below : value) add_depths(below, of_depth, depths);
}

class SlowTrials : public LiverJob, public testing::WithParamInterface<std::string> {
 protected:
  SlowTrials() {
    job();
    acceptance::write_gel_job(*this);
    write("layer.toml", text_of(test::test_data + "layer.toml"));
  }

  // A store of 10,000 rows.
  std::string filled_store(const std::string& name) const {
    const Store made(path(name));
    sqlite3* database = nullptr;
    EXPECT_EQ(sqlite3_open(path(name).c_str(), &database), SQLITE_OK);
    const std::string rows = "INSERT INTO evaluations WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < " +
                             std::to_string(others) +
                             ") SELECT 'other ' || i, 'stopped', printf('%.2000c', 'x'), 1, '' FROM n";
    EXPECT_EQ(sqlite3_exec(database, rows.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(database);
    return name;
  }
  long rows(const std::string& store) const { return Store(path(store)).size() - others; }
  bool is_sound(const std::string& store) const {
    sqlite3* database = nullptr;
    std::string answer;
    const auto take = [](void* to, int, char** cells, char**) {
      *static_cast<std::string*>(to) = cells[0];
      return 0;
    };
    const bool asked = sqlite3_open(path(store).c_str(), &database) == SQLITE_OK &&
                       sqlite3_exec(database, "PRAGMA integrity_check", take, &answer, nullptr) == SQLITE_OK;
    sqlite3_close(database);
    return asked && answer == "ok";
  }

  std::vector<std::string> command(const std::string& store, const std::string& out) const {
    auto words = test::words_of(GetParam());
    words.insert(words.end(), {"--quiet", "--store", store, "--out", out});
    return words;
  }
  std::vector<double> depths(const std::string& out) const {
    std::vector<double> all;
    add_depths(result(out + "/result.json"), false, all);
    return all;
  }
};

TEST_P(SlowTrials, KilledAgainAndAgainItLosesNothing) {
  const auto begin = std::chrono::steady_clock::now();
  const Ended undisturbed = run(command(filled_store("whole.store"), "whole"));
  ASSERT_TRUE(undisturbed.code == 0 || undisturbed.code == 3) << undisturbed.err;
  const auto took = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);

  filled_store("killed.store");
  std::mt19937 random(20090401);
  std::uniform_int_distribution<long> moment(1000, took.count() / 2);
  long stored = 0;
  constexpr int kills = 8;
  for (int k = 0; k < kills; ++k) {
    const pid_t child = start(command("killed.store", "killed"));
    std::this_thread::sleep_for(std::chrono::microseconds(moment(random)));
    kill(child, std::array{SIGKILL, SIGTERM, SIGKILL, SIGINT}[k % 4]);
    wait_for(child);
    EXPECT_GE(rows("killed.store"), stored) << "a finished run was lost";
    stored = rows("killed.store");
  }
  const Ended ended = run(command("killed.store", "killed"));
  EXPECT_EQ(ended.code, undisturbed.code) << ended.err;
  EXPECT_EQ(depths("killed"), depths("whole"));
  EXPECT_FALSE(depths("whole").empty());
  EXPECT_EQ(rows("killed.store"), rows("whole.store"));
  EXPECT_TRUE(is_sound("killed.store"));
  for (const std::string& name : files("killed")) EXPECT_THAT(name, Not(HasSubstr(".tmp")));
}

TEST_P(SlowTrials, SeveralAtOnceOnOneStoreDoNotDisturbEachOther) {
  ASSERT_NE(run(command(filled_store("whole.store"), "whole")).code, -1);
  filled_store("shared.store");
  std::vector<pid_t> children;
  for (const char* out : {"a", "b", "c"}) children.push_back(start(command("shared.store", out)));
  for (const pid_t child : children) EXPECT_NE(wait_for(child).code, -1);
  for (const char* out : {"a", "b", "c"}) EXPECT_EQ(depths(out), depths("whole")) << out;
  EXPECT_EQ(rows("shared.store"), rows("whole.store"));
  EXPECT_TRUE(is_sound("shared.store"));
}

INSTANTIATE_TEST_SUITE_P(SlowAcceptance, SlowTrials,
                         testing::Values("identify liver.toml", "calibrate gel.toml", "impact layer.toml --replicates 60",
                                         "study layer.toml --error-vs-time --meshes 4,5,6,8 --replicates 3"),
                         [](const auto& info) { return info.param.substr(0, info.param.find(' ')); });

}  // namespace
}  // namespace percal
