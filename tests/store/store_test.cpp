#include "percal/store/store.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "percal/base/error.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class StoreTest : public testing::Test, protected test::TemporaryFolder {
 protected:
  std::string content() const {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }

  const std::string file = path("percal.store");
};

const StoredEvaluation stopped{.outcome = "stopped", .payload = "{\"depth\": 26.5}", .cpu_seconds = 1.25};

std::string failure(const std::string& path) {
  try {
    const Store store(path);
    return "opened";
  } catch (const IoFailure& error) {
    return error.what();
  }
}

// Runs `work` in a process of its own; its exit code is 0 where nothing was thrown.
template <class Work>
pid_t in_child(Work&& work) {
  const pid_t child = fork();
  if (child != 0) return child;
  try {
    work();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "child: %s\n", error.what());
    _exit(1);
  }
  _exit(0);
}

int exit_code(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(StoreTest, WhatWasPutIsFoundAfterReopening) {
  const std::string payload = std::string("a\0b", 3) + std::string(100000, 'x') + "\u00b5";
  {
    Store store(file);
    EXPECT_EQ(store.size(), 0);
    EXPECT_EQ(store.find("key"), std::nullopt);
    store.put("key", {"passed through", payload, 2.5});
    EXPECT_EQ(store.path(), file);
  }
  const Store store(file);
  const auto found = store.find("key");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->outcome, "passed through");
  EXPECT_EQ(found->payload, payload);
  EXPECT_EQ(found->cpu_seconds, 2.5);
  EXPECT_EQ(store.find("ke"), std::nullopt);
  EXPECT_EQ(store.find("KEY"), std::nullopt);
  EXPECT_EQ(store.size(), 1);
}

TEST_F(StoreTest, TheFirstRowOfAKeyStays) {
  Store store(file);
  store.put("key", stopped);
  store.put("key", {"unstable", "{}", 9});
  EXPECT_EQ(store.find("key")->outcome, "stopped");
  EXPECT_EQ(store.find("key")->cpu_seconds, 1.25);
  EXPECT_EQ(store.size(), 1);
}

TEST_F(StoreTest, ARowThatKnowsMoreTakesItsPlace) {
  Store store(file);
  store.put("key", stopped);
  store.replace("key", {"unstable", "{}", 9});
  store.replace("new", stopped);
  EXPECT_EQ(store.find("key")->outcome, "unstable");
  EXPECT_EQ(store.find("key")->cpu_seconds, 9);
  EXPECT_EQ(store.find("new")->outcome, "stopped");
  EXPECT_EQ(store.size(), 2);
}

TEST_F(StoreTest, RowsWithAPrefixComeInTheOrderOfTheirKeys) {
  Store store(file);
  for (const char* key : {"b", "ab", "a%", "aB", "a", "A", "a\xc3\xb5"}) store.put(key, {"stopped", key, 0.5});
  std::string order;
  for (const auto& [key, evaluation] : store.with_prefix("a")) {
    EXPECT_EQ(evaluation, (StoredEvaluation{"stopped", key, 0.5}));
    order += key + " ";
  }
  EXPECT_EQ(order, "a a% aB ab a\xc3\xb5 ");
  EXPECT_EQ(store.with_prefix("a%").size(), 1u);
  EXPECT_EQ(store.with_prefix("").size(), 7u);
  EXPECT_TRUE(store.with_prefix("x").empty());
}

TEST_F(StoreTest, TheFirstNoteOfANameStays) {
  {
    Store store(file);
    EXPECT_EQ(store.note("rows"), std::nullopt);
    store.put_note("rows", "one\ntwo");
    store.put_note("rows", "three");
    store.put_note("none", "");
  }
  const Store store(file);
  EXPECT_EQ(store.note("rows"), "one\ntwo");
  EXPECT_EQ(store.note("none"), "");
  EXPECT_EQ(store.size(), 0);
}

TEST_F(StoreTest, AStoreMadeWithoutNotesGetsThem) {
  { Store(file).put("key", stopped); }
  sqlite3* older = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &older), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(older, "DROP TABLE notes", nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(older);
  Store store(file);
  store.put_note("name", "text");
  EXPECT_EQ(store.note("name"), "text");
  EXPECT_TRUE(store.find("key"));
}

TEST_F(StoreTest, AMovedStoreStillWorks) {
  Store first(file);
  Store second(std::move(first));
  second.put("key", stopped);
  EXPECT_TRUE(second.find("key"));
}

TEST_F(StoreTest, SeveralThreadsShareOneStore) {
  Store store(file);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&store, t] {
      for (int i = 0; i < 25; ++i) {
        const std::string key = std::to_string(t % 2) + ":" + std::to_string(i);  // each key from two threads
        store.put(key, {"stopped", key, 0});
        EXPECT_EQ(store.find(key)->payload, key);
      }
    });
  }
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(store.size(), 50);
}

TEST_F(StoreTest, SeveralProcessesMakeAndFillOneStore) {
  constexpr int stores = 10, processes = 4, rows = 5;
  for (int n = 0; n < stores; ++n) {  // the race is for making it, so it is made several times
    const std::string path = file + std::to_string(n);
    std::vector<pid_t> children;
    for (int p = 0; p < processes; ++p) {
      children.push_back(in_child([&] {
        Store store(path);
        for (int i = 0; i < rows; ++i) store.put(std::to_string(p) + ":" + std::to_string(i), stopped);
      }));
    }
    for (const pid_t child : children) EXPECT_EQ(exit_code(child), 0);
    EXPECT_EQ(Store(path).size(), processes * rows);
  }
}

TEST_F(StoreTest, AKilledWriterLosesNothingThatItAcknowledged) {
  for (int round = 0; round < 3; ++round) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = in_child([&] {
      Store store(file);
      for (int i = 0;; ++i) {
        store.put(std::to_string(round) + ":" + std::to_string(i), stopped);
        if (write(ends[1], &i, sizeof i) != sizeof i) return;
      }
    });
    close(ends[1]);
    int last = -1, read_now = 0;
    while (last < 20 + 7 * round && read(ends[0], &read_now, sizeof read_now) == sizeof read_now) last = read_now;
    kill(child, SIGKILL);
    while (read(ends[0], &read_now, sizeof read_now) == sizeof read_now) last = read_now;
    close(ends[0]);
    EXPECT_EQ(exit_code(child), -1);
    EXPECT_GE(last, 20);
    Store store(file);
    for (int i = 0; i <= last; ++i)
      EXPECT_TRUE(store.find(std::to_string(round) + ":" + std::to_string(i))) << i << " of " << last;
    store.put("after " + std::to_string(round), stopped);
  }
}

TEST_F(StoreTest, AFullDiskIsAnIoFailureAndWhatWasThereStays) {
  const pid_t child = in_child([&] {
    Store store(file);
    store.put("before", stopped);
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = 200000;  // bytes a file may have
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      for (int i = 0; i < 100; ++i) store.put("full " + std::to_string(i), {"stopped", std::string(50000, 'x'), 0});
      throw std::runtime_error("a full disk went unnoticed");
    } catch (const IoFailure& error) {
      if (std::string(error.what()).find(file) == std::string::npos)
        throw std::runtime_error("no path: " + std::string(error.what()));
    }
    if (!store.find("before")) throw std::runtime_error("the store cannot be read any more");
  });
  EXPECT_EQ(exit_code(child), 0);
  Store store(file);
  EXPECT_TRUE(store.find("before"));
  EXPECT_TRUE(store.find("full 0"));
  store.put("after", stopped);
  EXPECT_TRUE(store.find("after"));
}

TEST_F(StoreTest, AFullDiskWhileItIsMadeIsAnIoFailure) {
  const pid_t child = in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = 1000;
    setrlimit(RLIMIT_FSIZE, &limit);
    if (failure(file) == "opened") throw std::runtime_error("opened on a full disk");
  });
  EXPECT_EQ(exit_code(child), 0);
  Store(file).put("later", stopped);
  EXPECT_TRUE(Store(file).find("later"));
}

TEST_F(StoreTest, WhatIsNoStoreIsRefusedAndNotTouched) {
  std::ofstream(file) << std::string(5000, 'x');
  const std::string before = content();
  EXPECT_THAT(failure(file), testing::StartsWith(file));
  EXPECT_EQ(content(), before);
}

TEST_F(StoreTest, TheDatabaseOfAnotherProgramIsRefusedAndNotTouched) {
  sqlite3* other = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &other), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(other, "CREATE TABLE songs (name TEXT)", nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(other);
  const std::string before = content();
  EXPECT_THAT(failure(file), HasSubstr("another program"));
  EXPECT_EQ(content(), before);
}

TEST_F(StoreTest, ANewerSchemaIsRefused) {
  { const Store store(file); }
  sqlite3* newer = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &newer), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(newer, "PRAGMA user_version = 99", nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(newer);
  EXPECT_THAT(failure(file), HasSubstr("schema 99"));
}

TEST_F(StoreTest, TakesInWhatItHasNotAndKeepsWhatItHas) {
  Store here(file), there((folder / "there.store").string());
  StoredEvaluation other = stopped;
  other.payload = "{\"other\":1}";
  here.put("both", stopped);
  there.put("both", other);
  there.put("new", other);
  there.put_note("ladder", "text");
  EXPECT_EQ(here.take_in(there), 1);
  EXPECT_EQ(here.find("both"), stopped);
  EXPECT_EQ(here.find("new"), other);
  EXPECT_EQ(here.note("ladder"), "text");
  EXPECT_EQ(here.take_in(there), 0);
  EXPECT_EQ(there.size(), 2);
}

TEST_F(StoreTest, ACopyHasWhatAKilledWriterLeftAndTouchesNothing) {
  fs::create_directories(folder / "source");
  const std::string source = (folder / "source" / "killed.store").string();
  const pid_t child = in_child([&] {
    Store store(source);
    for (int i = 0; i < 5; ++i) store.put(std::to_string(i), stopped);
    kill(getpid(), SIGKILL);  // its rows are in the log
  });
  exit_code(child);
  const auto state = [&] {
    std::map<std::string, std::pair<std::string, fs::file_time_type>> all;
    for (const auto& entry : fs::directory_iterator(folder / "source")) {
      std::ostringstream text;
      text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
      all[entry.path().filename().string()] = {text.str(), entry.last_write_time()};
    }
    return all;
  };
  const auto before = state();
  ASSERT_TRUE(before.contains("killed.store-wal"));
  for (const auto& entry : fs::directory_iterator(folder / "source"))
    fs::permissions(entry.path(), fs::perms::owner_read);
  fs::permissions(folder / "source", fs::perms::owner_read | fs::perms::owner_exec);
  {
    const Store copy = Store::copy_of(source);
    EXPECT_EQ(copy.size(), 5);
    EXPECT_EQ(copy.find("4"), stopped);
    EXPECT_EQ(copy.path(), source);
    Store here(file);
    EXPECT_EQ(here.take_in(copy), 5);
  }
  EXPECT_EQ(state(), before);
  fs::permissions(folder / "source", fs::perms::owner_all);
}

TEST_F(StoreTest, ACopyOfWhatIsNoStoreNamesIt) {
  std::ofstream(file) << std::string(5000, 'x');
  for (const std::string& path : {file, (folder / "nowhere").string()}) {
    try {
      Store::copy_of(path);
      ADD_FAILURE() << path;
    } catch (const IoFailure& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(path));
    }
  }
}

TEST_F(StoreTest, AnUnwritablePlaceIsAnIoFailure) {
  std::ofstream((folder / "regular").string()) << "x";
  EXPECT_THAT(failure((folder / "regular" / "percal.store").string()), HasSubstr("regular"));
  EXPECT_THAT(failure(folder.string()), HasSubstr(folder.string()));
  EXPECT_NE(failure("/proc/percal/percal.store"), "opened");
  EXPECT_NE(failure(""), "opened");
}

TEST_F(StoreTest, FoldersAreMadeAndNamesHaveNoMeaningOfTheirOwn) {
  const auto before = fs::current_path();
  fs::current_path(folder);
  Store(":memory:").put("key", stopped);
  EXPECT_TRUE(Store(":memory:").find("key"));
  EXPECT_TRUE(fs::exists(folder / ":memory:"));
  Store("new/folder/percal.store").put("key", stopped);
  fs::current_path(before);
  EXPECT_TRUE(fs::exists(folder / "new/folder/percal.store"));
}

TEST(DefaultStorePath, FollowsTheEnvironment) {
  const auto with = [](const char* cache, const char* home) {
    cache ? setenv("XDG_CACHE_HOME", cache, 1) : unsetenv("XDG_CACHE_HOME");
    home ? setenv("HOME", home, 1) : unsetenv("HOME");
    return default_store_path();
  };
  const char* home = std::getenv("HOME");
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const std::string home_before = home ? home : "", cache_before = cache ? cache : "";
  EXPECT_EQ(with("/c", "/h"), "/c/percal/percal.store");
  EXPECT_EQ(with(nullptr, "/h"), "/h/.cache/percal/percal.store");
  EXPECT_EQ(with("relative", "/h"), "/h/.cache/percal/percal.store");
  EXPECT_EQ(with("", ""), "percal.store");
  with(cache ? cache_before.c_str() : nullptr, home ? home_before.c_str() : nullptr);
}

}  // namespace
}  // namespace percal
