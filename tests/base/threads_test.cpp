#include "percal/base/threads.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <new>
#include <stdexcept>

#include "percal/base/error.hpp"
#include "support/sanitized.hpp"

namespace percal {
namespace {

TEST(SideBySide, DoesEachPieceOnce) {
  for (const int threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> done(100);
    side_by_side(threads, 100, [&](int k) { ++done[k]; });
    for (const auto& times : done) EXPECT_EQ(times, 1);
  }
  side_by_side(4, 0, [](int) { FAIL(); });
}

TEST(SideBySide, TheFirstExceptionEndsTheRestAndIsThrown) {
  for (const int threads : {1, 3}) {
    std::atomic<int> begun{0};
    const auto work = [&](int) {
      ++begun;
      throw std::invalid_argument("the third");
    };
    EXPECT_THROW(side_by_side(threads, 1000, work), std::invalid_argument);
    EXPECT_LE(begun, threads);
  }
}

TEST(SideBySide, CallsWithinCallsShareTheThreads) {
  std::atomic<int> alive{0}, most{0}, done{0};
  side_by_side(3, 4, [&](int) {
    side_by_side(3, 8, [&](int) {
      const int now = ++alive;
      for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      --alive;
      ++done;
    });
  });
  EXPECT_EQ(done, 32);
  EXPECT_LE(most, 3);
  EXPECT_GE(most, 2);
  // None is lost by an exception.
  EXPECT_THROW(side_by_side(3, 4, [](int) { throw std::invalid_argument("it"); }), std::invalid_argument);
  std::atomic<int> waiting{0};
  side_by_side(3, 3, [&](int) {
    ++waiting;
    while (waiting < 3) std::this_thread::yield();
  });
}

TEST(SideBySide, APieceWithoutMemoryBesideTheOthersIsDoneWhenTheyAreGone) {
  std::atomic<int> alive{0}, done{0};
  side_by_side(4, 50, [&](int) {
    ++alive;
    const bool alone = alive == 1;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    --alive;
    if (!alone) throw std::bad_alloc();
    ++done;
  });
  EXPECT_EQ(done, 50);
  EXPECT_THROW(side_by_side(2, 5, [](int) { throw NoMemory("it", 1e9); }), NoMemory) << "where one alone has none";
}

#ifndef PERCAL_SANITIZED  // which want all addresses for themselves
// In a process that may have so many more bytes of addresses: a thread's stack takes 8 MB of them.
int exit_code_with(long bytes, int threads) {
  const pid_t child = fork();
  if (child == 0) {
    long pages = 0;
    std::FILE* file = std::fopen("/proc/self/statm", "r");
    if (!file || std::fscanf(file, "%ld", &pages) != 1) _exit(3);
    const rlim_t most = static_cast<rlim_t>(pages * sysconf(_SC_PAGESIZE) + bytes);
    const rlimit limit{most, most};
    setrlimit(RLIMIT_AS, &limit);
    std::atomic<int> done{0};
    side_by_side(threads, 5000, [&](int) { ++done; });
    _exit(done == 5000 ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(SideBySide, WhereNoMoreThreadsAreToBeHadTheOthersDoTheWork) {
  for (const long bytes : {0L, 9L << 20, 100L << 20})
    for (const int threads : {1, 2, 7, 4096}) EXPECT_EQ(exit_code_with(bytes, threads), 0) << bytes << " " << threads;
}
#endif

}  // namespace
}  // namespace percal
