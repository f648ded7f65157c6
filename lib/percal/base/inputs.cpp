#include "percal/base/inputs.hpp"

#include <sys/stat.h>

#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "percal/base/error.hpp"

namespace percal {
namespace {

using FileNumber = std::pair<dev_t, ino_t>;

struct Inputs {
  std::mutex mutex;
  bool are_kept = false;
  std::map<FileNumber, std::string> paths;
};

Inputs& inputs() {
  static Inputs all;
  return all;
}

// Of a regular file.
std::optional<FileNumber> number_of(const std::string& path) {
  struct stat file;
  if (::stat(path.c_str(), &file) != 0 || !S_ISREG(file.st_mode)) return std::nullopt;
  return FileNumber(file.st_dev, file.st_ino);
}

}  // namespace

InputsAreKept::InputsAreKept() {
  const std::lock_guard lock(inputs().mutex);
  inputs().are_kept = true;
}

InputsAreKept::~InputsAreKept() {
  const std::lock_guard lock(inputs().mutex);
  inputs().are_kept = false;
  inputs().paths.clear();
}

void remember_input(const std::string& path) {
  const std::lock_guard lock(inputs().mutex);
  if (!inputs().are_kept) return;
  if (const auto number = number_of(path)) inputs().paths[*number] = path;
}

// The number of a file that is gone may be another one's by now.
void refuse_to_replace_input(const std::string& path) {
  const auto number = number_of(path);
  if (!number) return;
  const std::lock_guard lock(inputs().mutex);
  const auto input = inputs().paths.find(*number);
  if (input != inputs().paths.end() && number_of(input->second) == number)
    throw BadInput({path, 0, ""}, "a file that this command reads, to be written to",
                   "another name: what was read would be lost");
}

}  // namespace percal
