#include "percal/impact/march/team.hpp"

#include <pthread.h>
#include <time.h>

#include <utility>

#include "percal/base/threads.hpp"

namespace percal {
namespace {

// To fall asleep and be woken up takes longer than a sweep. So a worker first looks for about 50 microseconds, then a millisecond or two
// in which it lets others have the processor.
constexpr int looks = 1000, yields = 2000;

void breathe() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

// Returns when `number` is not `value` any more.
template <class T>
void wait_while(const std::atomic<T>& number, T value) {
  for (int look = 0; look < looks + yields; ++look) {
    if (number.load(std::memory_order_acquire) != value) return;
    if (look < looks)
      breathe();
    else
      std::this_thread::yield();
  }
  number.wait(value);
}

}  // namespace

Team::Team(int workers) : threads_(threads_to_be_had(workers - 1, [this](int worker) { serve(worker); })) {}

Team::~Team() {
  over_ = true;
  ++call_;
  call_.notify_all();
  for (auto& thread : threads_) thread.join();
}

double Team::helper_cpu_seconds() const {
  double sum = 0;
  for (const auto& thread : threads_) {
    clockid_t clock{};
    timespec now{};
    if (pthread_getcpuclockid(const_cast<std::thread&>(thread).native_handle(), &clock) != 0) continue;
    clock_gettime(clock, &now);
    sum += static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }
  return sum;
}

void Team::each(const std::function<void(int)>& work) {
  work_ = &work;
  busy_ = static_cast<int>(threads_.size());
  if (!threads_.empty()) {
    ++call_;
    call_.notify_all();
  }
  take_part(0);
  for (int left = busy_; left > 0; left = busy_) wait_while(busy_, left);
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Team::take_part(int worker) {
  try {
    (*work_)(worker);
  } catch (...) {
    const std::lock_guard lock(failure_mutex_);
    if (!failure_) failure_ = std::current_exception();
  }
}

void Team::serve(int worker) {
  for (long seen = 0;;) {
    wait_while(call_, seen);
    ++seen;
    if (over_) return;
    take_part(worker);
    if (--busy_ == 0) busy_.notify_one();
  }
}

}  // namespace percal
