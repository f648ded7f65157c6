#include "percal/base/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>

#include "percal/base/printable.hpp"

namespace percal {
namespace {
std::atomic<bool> enabled{false};
std::atomic<const Progress*> shown{nullptr};  // whose bar stands on the terminal
constexpr int bar_width = 30;
}  // namespace

void Progress::enable(bool wanted) { enabled = wanted && isatty(STDERR_FILENO) == 1; }

Progress::Progress(std::string label, long total)
    : label_(printable(label)), total_(total), visible_(enabled), start_(std::chrono::steady_clock::now()) {
  const Progress* nobody = nullptr;
  if (visible_) shown.compare_exchange_strong(nobody, this);
}

Progress::~Progress() {
  const Progress* mine = this;
  if (visible_ && shown.load() == mine) {
    std::fprintf(stderr, "\r\033[K");
    std::fflush(stderr);
    shown.compare_exchange_strong(mine, nullptr);
  }
}

void Progress::add(long finished) {
  const std::lock_guard lock(mutex_);
  done_ += finished;
  const auto now = std::chrono::steady_clock::now();
  if (visible_ && (done_ >= total_ || now - drawn_ > std::chrono::milliseconds(100))) {
    drawn_ = now;
    draw();
  }
}

void Progress::expect(long more) {
  const std::lock_guard lock(mutex_);
  total_ += more;
}

void Progress::draw() {
  const Progress* nobody = nullptr;
  if (!shown.compare_exchange_strong(nobody, this) && nobody != this) return;
  const double share = total_ > 0 ? std::min(1.0, static_cast<double>(done_) / static_cast<double>(total_)) : 0;
  const double elapsed = std::chrono::duration<double>(drawn_ - start_).count();
  const long left = share > 0 ? static_cast<long>(elapsed * (1 - share) / share + 0.5) : 0;
  std::string bar(bar_width, '.');
  std::fill_n(bar.begin(), static_cast<int>(share * bar_width), '#');
  std::fprintf(stderr, "\r\033[K%s  %ld/%ld  %s  %ld:%02ld left", label_.c_str(), done_, total_, bar.c_str(), left / 60,
               left % 60);
  std::fflush(stderr);
}

}  // namespace percal
