// The program on a terminal of its own.
#pragma once
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <utility>
#include <vector>

#include "support/program.hpp"

namespace percal::test {

using Environment = std::vector<std::pair<std::string, std::string>>;

class Terminal : public Program {
 protected:
  void SetUp() override {
    int master = -1, slave = -1;
    if (openpty(&master, &slave, nullptr, nullptr, nullptr) != 0) GTEST_SKIP() << "no pseudo-terminal (/dev/pts) here";
    close(master);
    close(slave);
  }

  // Everything that the program writes to a terminal so many columns wide, standard error among it.
  std::string on_terminal(const std::vector<std::string>& arguments, const Environment& environment = {},
                          unsigned short columns = 200) const {
    std::vector<char*> words{const_cast<char*>(PERCAL_PROGRAM)};
    for (const auto& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    winsize size{};
    size.ws_row = 50;
    size.ws_col = columns;
    int master = -1;
    const pid_t child = forkpty(&master, nullptr, nullptr, &size);
    if (child == 0) {
      if (chdir(folder.c_str()) != 0) _exit(126);
      setenv("XDG_CACHE_HOME", path("cache").c_str(), 1);
      setenv("TERM", "xterm", 1);
      unsetenv("NO_COLOR");
      for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
      execv(words[0], words.data());
      _exit(127);
    }
    std::string output;
    char buffer[4096];
    for (ssize_t count;
         (count = ::read(master, buffer, sizeof buffer)) > 0;)  // ends with EIO when the program has ended
      output.append(buffer, static_cast<std::size_t>(count));
    close(master);
    int status = 0;
    waitpid(child, &status, 0);
    return output;
  }
};

}  // namespace percal::test
