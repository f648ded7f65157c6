// A few threads that do the same thing on different columns, again and again, within one run.
#pragma once
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace percal {

class Team {
 public:
  // workers >= 1; the calling thread is one of them. Fewer where no more threads are to be had.
  explicit Team(int workers);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int workers() const { return static_cast<int>(threads_.size()) + 1; }

  // Processor time of the threads besides the calling one up to now, s.
  double helper_cpu_seconds() const;

  // work(0) ... work(workers - 1), each on its own thread; returns when all are done. The first exception is thrown here then.
  void each(const std::function<void(int)>& work);

 private:
  void serve(int worker);
  void take_part(int worker);
  std::atomic<long> call_{0};
  std::atomic<int> busy_{0};
  std::atomic<bool> over_{false};
  const std::function<void(int)>* work_ = nullptr;
  std::mutex failure_mutex_;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;  // the last member: they use the others as soon as they are there
};

}  // namespace percal
