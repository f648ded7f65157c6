// Claims on keys: one at a time has one, and the dead have none.
#include "percal/store/claims.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>

#include "percal/store/store.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

class ClaimsTest : public testing::Test, protected test::TemporaryFolder {
 protected:
  // A process that has claimed the key and waits; it has said so when this returns.
  pid_t holder_of(const std::string& key) const {
    int ends[2];
    if (pipe(ends) != 0) return -1;
    const pid_t child = fork();
    if (child == 0) {
      Claims claims(path("store"));
      const auto claim = claims.claim(key);
      const char had = claim ? 'y' : 'n';
      if (write(ends[1], &had, 1) != 1) _exit(1);
      for (;;) pause();
    }
    char had = 'n';
    EXPECT_EQ(read(ends[0], &had, 1), 1);
    EXPECT_EQ(had, 'y');
    close(ends[0]);
    close(ends[1]);
    return child;
  }
  bool has_file() const { return std::filesystem::exists(path("store-claims")); }
};

TEST_F(ClaimsTest, OneHasAKeyUntilItGivesItBack) {
  Claims one(path("store")), other(path("store"));
  {
    const auto claim = one.claim("a");
    ASSERT_TRUE(claim);
    EXPECT_FALSE(other.claim("a"));
    EXPECT_FALSE(one.claim("a")) << "a second thread of the same store";
    EXPECT_TRUE(other.claim("b"));
  }
  EXPECT_TRUE(other.claim("a"));
}

TEST_F(ClaimsTest, ADeadProcessHasNone) {
  const pid_t holder = holder_of("a");
  Claims mine(path("store"));
  EXPECT_FALSE(mine.claim("a"));
  EXPECT_TRUE(mine.claim("b"));
  kill(holder, SIGSTOP);
  EXPECT_FALSE(mine.claim("a")) << "it is not dead";
  kill(holder, SIGKILL);
  waitpid(holder, nullptr, 0);
  EXPECT_TRUE(mine.claim("a"));
}

TEST_F(ClaimsTest, TheFileIsThereOnlyAsLongAsSomebodyNeedsIt) {
  {
    Claims one(path("store"));
    EXPECT_FALSE(has_file());
    std::optional<Claims> other(std::in_place, path("store"));
    const auto claim = one.claim("a");
    { const auto second = other->claim("b"); }
    other.reset();
    EXPECT_TRUE(has_file()) << "one has a claim";
  }
  EXPECT_FALSE(has_file());
}

// Who opened the file before it was taken away finds the new one.
TEST_F(ClaimsTest, AFileThatWasTakenAwayIsMadeAgain) {
  Claims one(path("store"));
  { const auto claim = one.claim("a"); }
  std::filesystem::remove(path("store-claims"));
  const auto claim = one.claim("a");
  Claims other(path("store"));
  EXPECT_FALSE(other.claim("a"));
}

TEST_F(ClaimsTest, WhereNoFileCanBeMadeEverybodyGetsOne) {
  Claims one(path("no/such/folder/store")), other(path("no/such/folder/store"));
  const auto claim = one.claim("a");
  EXPECT_TRUE(claim);
  EXPECT_TRUE(other.claim("a"));
}

TEST_F(ClaimsTest, AStoreGivesThemByItsFileWhateverItsName) {
  const Store store(path("percal.store"));
  std::filesystem::create_symlink(path("percal.store"), path("link"));
  const Store linked(path("link"));
  const auto claim = store.claim("a");
  EXPECT_FALSE(linked.claim("a"));
}

}  // namespace
}  // namespace percal
