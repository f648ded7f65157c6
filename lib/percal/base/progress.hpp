// A progress bar on a terminal; nothing in a pipe or a file.
#pragma once
#include <chrono>
#include <mutex>
#include <string>

namespace percal {

// Counts finished pieces of work, from several threads, and draws "label  12/30  ####....  0:08 left" on standard error.
// Where several are alive at once, the first is shown until it is done; the others count silently until then.
class Progress {
 public:
  Progress() = default;  // silent
  Progress(std::string label, long total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void add(long finished = 1);
  void expect(long more);  // the total grows: searches don't know beforehand how many runs they need

  // Whether bars are drawn at all: off until a program turns it on, and then only where standard error is a terminal.
  static void enable(bool wanted);

 private:
  void draw();
  std::mutex mutex_;
  std::string label_;
  long total_ = 0, done_ = 0;
  bool visible_ = false;
  std::chrono::steady_clock::time_point start_, drawn_;
};

}  // namespace percal
