#include "percal/base/threads.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>

#include "percal/base/error.hpp"

namespace percal {

std::vector<std::thread> threads_to_be_had(int wanted, const std::function<void(int)>& work) {
  std::vector<std::thread> threads;
  try {
    threads.reserve(static_cast<std::size_t>(std::max(wanted, 0)));  // so that none is lost where it cannot grow
    for (int k = 1; k <= wanted; ++k) threads.emplace_back(work, k);
  } catch (const std::system_error&) {
  } catch (const std::bad_alloc&) {
  }
  return threads;
}

int threads_of_this_machine() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

namespace {

// Those of all calls of side_by_side in this process.
std::atomic<int> helpers_at_work{0};

// As many of the wanted ones as are left to have.
int claim_helpers(int threads, int wanted) {
  int others = helpers_at_work;
  while (true) {
    const int claimed = std::clamp(threads - 1 - others, 0, std::max(wanted, 0));
    if (helpers_at_work.compare_exchange_weak(others, others + claimed)) return claimed;
  }
}

}  // namespace

void side_by_side(int threads, int count, const std::function<void(int)>& work) {
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::vector<int> given_back;  // for want of memory, one by each thread, which then leaves
  std::mutex mutex;
  given_back.reserve(static_cast<std::size_t>(std::max(std::min(threads, count), 1)));
  const int helpers_wanted = claim_helpers(threads, count - 1);
  const auto give_back = [&](int k) {
    const std::lock_guard lock(mutex);
    given_back.push_back(k);
  };
  const auto take_turns = [&](int) {
    for (int k = next++; k < count; k = next++) {
      try {
        work(k);
      } catch (const std::bad_alloc&) {
        return give_back(k);
      } catch (const NoMemory&) {
        return give_back(k);
      } catch (...) {
        next = count;
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
      }
    }
  };
  auto helpers = threads_to_be_had(helpers_wanted, [&](int k) {
    take_turns(k);
    --helpers_at_work;
  });
  helpers_at_work -= helpers_wanted - static_cast<int>(helpers.size());
  take_turns(0);
  for (auto& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
  for (const int k : given_back) work(k);
  for (int k = next++; k < count; k = next++) work(k);
}

}  // namespace percal
