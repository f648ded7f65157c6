#include "percal/plot/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

#include "percal/base/child_process.hpp"
#include "percal/plot/svg.hpp"

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

// The script as a file without a name, of any length; -1 where there is no room.
int file_with(const std::string& script) {
  const int file = memfd_create("script", MFD_CLOEXEC);
  for (std::size_t done = 0; file >= 0 && done < script.size();) {
    const ssize_t written = write(file, script.data() + done, script.size() - done);
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

// A drawing is some hundred kilobytes and takes a second.
constexpr std::size_t largest_drawing = 32 << 20;  // bytes
constexpr int longest_silence = 60'000;            // ms

// Everything that is written to the pipe; nothing where that is too much or does not come.
std::optional<std::string> take_all(Pipe& pipe) {
  pipe.close_end(1);
  std::string text;
  std::array<char, 65536> buffer;
  while (text.size() <= largest_drawing) {
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

std::optional<std::string> gnuplot(const std::string& script) {
  Pipe out;
  const int input = out.is_open() ? file_with(script) : -1;
  if (input < 0) return std::nullopt;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.end(1), STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  char name[] = "gnuplot";
  char* const words[] = {name, nullptr};
  const auto child = start_program(words, &actions);
  posix_spawn_file_actions_destroy(&actions);
  close(input);
  if (!child) return std::nullopt;
  const auto text = take_all(out);
  if (!text) kill(*child, SIGKILL);
  const bool done = ends_well(*child) && text && !text->empty();
  return done ? text : std::nullopt;
}

std::optional<std::string> draw_svg(const Plot& plot, const Canvas& canvas, const std::string& prefix) {
  if (plot.script.empty()) return std::nullopt;
  const auto svg = gnuplot(fmt::format("set terminal svg size {},{} dynamic font \"sans,{}\"\n", canvas.width,
                                       canvas.height, canvas.font_size) +
                           plot.script);
  return svg ? std::optional(tidy_svg(*svg, prefix)) : std::nullopt;
}

std::optional<std::string> draw_svg(const Plot& plot) { return draw_svg(plot, wide_canvas, plot.name); }

std::optional<std::string> draw_png(const Plot& plot) {
  if (plot.script.empty()) return std::nullopt;
  return gnuplot(
      "set terminal pngcairo size 1080,660 pointscale 1.4 linewidth 1.2 font \"sans,13\" background rgb \"white\"\n" +
      plot.script);
}

}  // namespace percal
