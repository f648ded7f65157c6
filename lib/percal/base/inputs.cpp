#include "percal/base/inputs.hpp"

#include <mutex>
#include <set>
#include <utility>

#include "percal/base/error.hpp"

namespace percal {
namespace {

struct Inputs {
  std::mutex mutex;
  bool are_kept = false;
  std::set<std::pair<dev_t, ino_t>> files;
};

Inputs& inputs() {
  static Inputs all;
  return all;
}

}  // namespace

InputsAreKept::InputsAreKept() {
  const std::lock_guard lock(inputs().mutex);
  inputs().are_kept = true;
}

InputsAreKept::~InputsAreKept() {
  const std::lock_guard lock(inputs().mutex);
  inputs().are_kept = false;
  inputs().files.clear();
}

void remember_input(const struct stat& file) {
  const std::lock_guard lock(inputs().mutex);
  if (inputs().are_kept && S_ISREG(file.st_mode)) inputs().files.emplace(file.st_dev, file.st_ino);
}

void remember_input(const std::string& path) {
  struct stat file;
  if (::stat(path.c_str(), &file) == 0) remember_input(file);
}

void refuse_to_replace_input(const std::string& path) {
  struct stat file;
  if (::stat(path.c_str(), &file) != 0) return;
  const std::lock_guard lock(inputs().mutex);
  if (inputs().files.contains({file.st_dev, file.st_ino}))
    throw BadInput({path, 0, ""}, "a file that this command reads, to be written to",
                   "another name: what was read would be lost");
}

}  // namespace percal
