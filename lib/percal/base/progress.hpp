// How far a long piece of work is: a bar on a terminal, never wider than it; in a pipe or a file one line a minute.
#pragma once
#include <chrono>
#include <mutex>
#include <optional>
#include <string>

namespace percal {

// Counts finished pieces of work, from several threads, and says "label  12/30  ####....  0:08 left" on standard error.
// Where several are alive at once, the first is shown until it is done; the others count silently until then.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  Progress() = default;  // silent
  // No more time is said to be left than there is until `deadline`.
  Progress(std::string label, long total, std::optional<Clock::time_point> deadline = {});
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `work`: of a weighed total, what the piece took of it.
  void add(long finished = 1, double work = 0);
  void expect(long more);  // the total grows: searches don't know beforehand how many runs they need
  // Pieces are unlike: the time left goes by the work that they say, out of this much, and not by their number.
  void weigh(double total_work);

  // Whether anything is said at all: off until a program turns it on.
  static void enable(bool wanted);

 private:
  void say(Clock::time_point now);
  double share_done() const;
  std::mutex mutex_;
  std::string label_;
  long total_ = 0, done_ = 0;
  double total_work_ = 0, done_work_ = 0;  // of pieces that are weighed
  bool visible_ = false;
  std::optional<Clock::time_point> deadline_;
  Clock::time_point start_, said_;
};

// "label  12/30  ####....  0:08 left" in so many columns: without the bar where that is too long, and the label cut where it still is.
// `left`: seconds.
std::string progress_line(const std::string& label, long done, long total, long left, int columns);

}  // namespace percal
