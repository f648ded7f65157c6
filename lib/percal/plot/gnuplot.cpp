#include "percal/plot/gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

extern char** environ;

namespace percal {
namespace {

constexpr std::size_t largest_script = 60000;  // a pipe holds 64 KiB: it takes the whole script before anybody reads

class Pipe {
 public:
  Pipe() { is_open_ = pipe2(ends_.data(), O_CLOEXEC) == 0; }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  bool is_open() const { return is_open_; }
  int end(int which) const { return ends_[which]; }
  void close_end(int which) {
    if (ends_[which] >= 0) close(ends_[which]);
    ends_[which] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};  // to read from, to write to
  bool is_open_ = false;
};

bool put(Pipe& pipe, const std::string& text) {
  const bool done = write(pipe.end(1), text.data(), text.size()) == static_cast<ssize_t>(text.size());
  pipe.close_end(1);
  return done;
}

std::string take_all(Pipe& pipe) {
  pipe.close_end(1);
  std::string text;
  std::array<char, 4096> buffer;
  for (ssize_t got; (got = read(pipe.end(0), buffer.data(), buffer.size())) != 0;) {
    if (got < 0 && errno != EINTR) break;
    if (got > 0) text.append(buffer.data(), static_cast<std::size_t>(got));
  }
  return text;
}

}  // namespace

std::optional<std::string> gnuplot(const std::string& script) {
  Pipe in, out;
  if (!in.is_open() || !out.is_open() || script.size() > largest_script || !put(in, script)) return std::nullopt;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.end(0), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.end(1), STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  char name[] = "gnuplot";
  char* const words[] = {name, nullptr};
  pid_t child = 0;
  const int result = posix_spawnp(&child, name, &actions, nullptr, words, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (result != 0) return std::nullopt;
  const std::string text = take_all(out);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const bool done = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !text.empty();
  return done ? std::optional(text) : std::nullopt;
}

}  // namespace percal
