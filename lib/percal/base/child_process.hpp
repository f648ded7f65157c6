// Other programs that this one starts.
#pragma once
#include <spawn.h>
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace percal {

// Starts the program words[0], found on PATH; `words` ends with null. Signals reach it, though this program may block them. Nothing
// where it cannot be started. `actions` may be null.
std::optional<pid_t> start_program(char* const words[], const posix_spawn_file_actions_t* actions = nullptr);

// Waits for its end: whether that was with exit code 0.
bool ends_well(pid_t child);

// What a program writes to its standard output.
struct Answer {
  bool ended_well = false;  // with exit code 0, having said no more than can be taken and not been silent for a minute
  std::string text;
};

enum class Complaints { dropped, in_answer };  // its standard error

// Runs a program with this text as its standard input, to its end. A program that cannot be started has not ended well.
Answer answer_of(const std::vector<std::string>& words, const std::string& input,
                 Complaints complaints = Complaints::dropped);

}  // namespace percal
