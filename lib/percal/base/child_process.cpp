#include "percal/base/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

namespace percal {
namespace {

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

// The text as a file without a name, of any length; -1 where there is no room.
int file_with(const std::string& text) {
  const int file = memfd_create("input", MFD_CLOEXEC);
  for (std::size_t done = 0; file >= 0 && done < text.size();) {
    const ssize_t written = write(file, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      close(file);
      return -1;
    }
    done += static_cast<std::size_t>(written);
  }
  if (file >= 0) lseek(file, 0, SEEK_SET);
  return file;
}

constexpr std::size_t largest_answer = 32 << 20;  // bytes
constexpr int longest_silence = 60'000;           // ms

// Everything that is written to the pipe; nothing where that is too much or does not come.
std::optional<std::string> take_all(Pipe& pipe) {
  pipe.close_end(1);
  std::string text;
  std::array<char, 65536> buffer;
  while (text.size() <= largest_answer) {
    pollfd waiting{pipe.end(0), POLLIN, 0};
    const int ready = poll(&waiting, 1, longest_silence);
    if (ready == 0) return std::nullopt;
    const ssize_t got = ready < 0 ? -1 : read(pipe.end(0), buffer.data(), buffer.size());
    if (got == 0) return text;
    if (got < 0 && errno != EINTR) return std::nullopt;
    if (got > 0) text.append(buffer.data(), static_cast<std::size_t>(got));
  }
  return std::nullopt;
}

}  // namespace

std::optional<pid_t> start_program(char* const words[], const posix_spawn_file_actions_t* actions) {
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, words[0], actions, &attributes, words, environ);
  posix_spawnattr_destroy(&attributes);
  return failure == 0 ? std::optional(child) : std::nullopt;
}

bool ends_well(pid_t child) {
  int status = 0;
  pid_t ended = 0;
  do ended = waitpid(child, &status, 0);
  while (ended < 0 && errno == EINTR);
  return ended == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

Answer answer_of(const std::vector<std::string>& words, const std::string& input, Complaints complaints) {
  Pipe out;
  const int text = out.is_open() ? file_with(input) : -1;
  if (text < 0) return {};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, text, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.end(1), STDOUT_FILENO);
  if (complaints == Complaints::dropped)
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  else
    posix_spawn_file_actions_adddup2(&actions, out.end(1), STDERR_FILENO);
  std::vector<std::string> copies = words;
  std::vector<char*> pointers;
  for (std::string& word : copies) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const auto child = start_program(pointers.data(), &actions);
  posix_spawn_file_actions_destroy(&actions);
  close(text);
  if (!child) return {};
  auto said = take_all(out);
  if (!said) kill(*child, SIGKILL);
  const bool done = ends_well(*child) && said;
  return {done, std::move(said).value_or("")};
}

}  // namespace percal
