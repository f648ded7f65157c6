// When a process may end on a signal: not while a file is half written or a temporary one is there.
#pragma once
#include <shared_mutex>
#include <string>

namespace percal {

// Holds back the end while it lives, on whatever thread the signal is taken. Short-lived; several may be alive at once.
class EndLater {
 public:
  EndLater();
  EndLater(const EndLater&) = delete;
  EndLater& operator=(const EndLater&) = delete;

 private:
  std::shared_lock<std::shared_mutex> lock_;
};

// Ends the process with this exit code and these words on standard error as soon as nobody holds the end back: no destructors, no
// buffers.
[[noreturn]] void end_process(int code, const std::string& last_words);

}  // namespace percal
