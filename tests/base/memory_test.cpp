#include "percal/base/memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace percal {
namespace {

TEST(Memory, SomeIsAvailable) {
  EXPECT_GT(available_memory(), 1e6);
  EXPECT_LT(available_memory(), 1e15);
}

// Eight pieces of work of 2 in a room of 5, and two of 9.
TEST(MemoryRoom, HoldsWhatFitsAndLetsTheLargeInAlone) {
  MemoryRoom room(5);
  std::atomic<int> inside{0}, most{0}, beside_large{0};
  std::vector<std::thread> threads;
  for (int k = 0; k < 10; ++k)
    threads.emplace_back([&, bytes = k < 8 ? 2.0 : 9.0] {
      const MemoryRoom::Place place(room, bytes);
      const int now = ++inside;
      int before = most;
      while (before < now && !most.compare_exchange_weak(before, now)) {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      if (bytes > 5) beside_large = std::max(beside_large.load(), inside - 1);
      --inside;
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(most, 2);
  EXPECT_EQ(beside_large, 0);
}

}  // namespace
}  // namespace percal
