// Other programs that this one starts.
#pragma once
#include <spawn.h>
#include <sys/types.h>

#include <optional>

namespace percal {

// Starts the program words[0], found on PATH; `words` ends with null. Signals reach it, though this program may block them. Nothing
// where it cannot be started. `actions` may be null.
std::optional<pid_t> start_program(char* const words[], const posix_spawn_file_actions_t* actions = nullptr);

// Waits for its end: whether that was with exit code 0.
bool ends_well(pid_t child);

}  // namespace percal
