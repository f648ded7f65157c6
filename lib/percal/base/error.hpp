// The failures that end a command: input that cannot be used, a disk that cannot be written, memory that is not to be had.
// A numerical outcome (passed through, unstable) is never an exception: it is a value, see observe/.
#pragma once
#include <stdexcept>
#include <string>

namespace percal {

// Where in the user's input something stands. `line` is 1-based, 0 where there is none; `key` may be empty.
struct Place {
  std::string file;
  int line = 0;
  std::string key;
};

// Input that cannot be used. Exit code 2. The message reads
//   scene.toml:12: target.nu: found 0.5; accepted: a number between -1 and 0.5
class BadInput : public std::runtime_error {
 public:
  BadInput(const Place& place, const std::string& found, const std::string& accepted);
  // For input whose faults are several (every bad line of a CSV): the lines of the message, ready made.
  explicit BadInput(const std::string& message);
};

// A file that the input names and that is not there.
class NoSuchFile : public BadInput {
 public:
  explicit NoSuchFile(const std::string& path) : BadInput(path + ": there is no such file") {}
};

// A file that cannot be read or written although the input is right: full disk, unwritable folder. Exit code 4.
class IoFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Memory that is not to be had although the input is right. Exit code 4. The message reads
//   out of memory: big.csv wants 812 MB
class NoMemory : public std::runtime_error {
 public:
  NoMemory(const std::string& what, double bytes);
};

// The program's exit codes.
enum class Exit : int {
  done = 0,
  check_failed = 1,
  bad_input = 2,
  outcome_not_reached = 3,
  io_failure = 4,  // of the machine: files, memory
  internal_error = 70,
  interrupted = 130,
};

}  // namespace percal
