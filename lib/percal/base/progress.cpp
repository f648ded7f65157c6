#include "percal/base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>

#include "percal/base/printable.hpp"

namespace percal {
namespace {

std::atomic<bool> enabled{false};
std::atomic<const Progress*> shown{nullptr};  // who may speak
constexpr int longest_bar = 30, shortest_bar = 5, usual_columns = 80;
constexpr std::chrono::milliseconds between_bars{100};
constexpr std::chrono::minutes between_lines{1};

bool on_terminal() { return isatty(STDERR_FILENO) == 1; }

int columns_to_use() {
  const int columns = terminal_columns(STDERR_FILENO);
  return columns > 0 ? columns : usual_columns;
}

double share_of(long done, long total) {
  return total > 0 ? std::min(1.0, static_cast<double>(done) / static_cast<double>(total)) : 0;
}

}  // namespace

std::string progress_line(const std::string& label, long done, long total, long left, int columns) {
  const std::string count = fmt::format("  {}/{}", done, total),
                    time = fmt::format("  {}:{:02} left", left / 60, left % 60);
  const int room = columns - static_cast<int>(count.size() + time.size());
  const int bar = std::min(longest_bar, room - static_cast<int>(label.size()) - 2);
  if (bar < shortest_bar) return label.substr(0, static_cast<std::size_t>(std::max(room, 0))) + count + time;
  const int full = static_cast<int>(share_of(done, total) * bar);
  return label + count + "  " + std::string(full, '#') + std::string(bar - full, '.') + time;
}

void Progress::enable(bool wanted) { enabled = wanted; }

Progress::Progress(std::string label, long total, std::optional<Clock::time_point> deadline)
    : label_(printable(label)), total_(total), visible_(enabled), deadline_(deadline), start_(Clock::now()) {
  said_ = on_terminal() ? Clock::time_point() : start_;
  const Progress* nobody = nullptr;
  if (visible_) shown.compare_exchange_strong(nobody, this);
}

Progress::~Progress() {
  const Progress* mine = this;
  if (!visible_ || shown.load() != mine) return;
  if (on_terminal()) {
    std::fprintf(stderr, "\r\033[K");
    std::fflush(stderr);
  }
  shown.compare_exchange_strong(mine, nullptr);
}

void Progress::add(long finished, double work) {
  const std::lock_guard lock(mutex_);
  done_ += finished;
  done_work_ += work;
  if (!visible_) return;
  const auto now = Clock::now();
  const bool bar = on_terminal();
  if (now - said_ >= (bar ? Clock::duration(between_bars) : Clock::duration(between_lines)) || (bar && done_ >= total_))
    say(now);
}

void Progress::expect(long more) {
  const std::lock_guard lock(mutex_);
  total_ += more;
}

void Progress::weigh(double total_work) {
  const std::lock_guard lock(mutex_);
  total_work_ = total_work;
}

double Progress::share_done() const {
  return total_work_ > 0 ? std::min(1.0, done_work_ / total_work_) : share_of(done_, total_);
}

void Progress::say(Clock::time_point now) {
  const Progress* nobody = nullptr;
  if (!shown.compare_exchange_strong(nobody, this) && nobody != this) return;
  said_ = now;
  const double share = share_done();
  double left = share > 0 ? std::chrono::duration<double>(now - start_).count() * (1 - share) / share : 0;
  if (deadline_) left = std::clamp(std::chrono::duration<double>(*deadline_ - now).count(), 0.0, left);
  const long seconds = static_cast<long>(left + 0.5);
  if (on_terminal())
    std::fprintf(stderr, "\r\033[K%s", progress_line(label_, done_, total_, seconds, columns_to_use() - 1).c_str());
  else
    std::fprintf(stderr, "%s  %ld/%ld  %ld:%02ld left\n", label_.c_str(), done_, total_, seconds / 60, seconds % 60);
  std::fflush(stderr);
}

}  // namespace percal
