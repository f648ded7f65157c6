#include "percal/base/ending.hpp"

#include <unistd.h>

namespace percal {
namespace {

// Never destroyed: a signal may come while the program's statics are.
std::shared_mutex& writing() {
  static auto* mutex = new std::shared_mutex;
  return *mutex;
}

}  // namespace

EndLater::EndLater() : lock_(writing()) {}

void end_process(int code, const std::string& last_words) {
  writing().lock();  // and never given back: nobody begins to write any more
  [[maybe_unused]] const auto written = write(STDERR_FILENO, last_words.data(), last_words.size());
  _exit(code);
}

}  // namespace percal
