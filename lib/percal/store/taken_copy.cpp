#include "percal/store/taken_copy.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <utility>

#include "percal/base/error.hpp"

namespace percal {
namespace {

namespace fs = std::filesystem;

// What of a file tells that it was written to; all zero where it is not there.
std::array<long long, 4> state_of(const std::string& path) {
  struct stat file;
  if (::stat(path.c_str(), &file) != 0) return {};
  return {static_cast<long long>(file.st_ino), file.st_size, file.st_mtim.tv_sec, file.st_mtim.tv_nsec};
}

}  // namespace

TakenCopy::TakenCopy(const std::string& store) {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "percal-store-XXXXXX").string();
  if (error || !mkdtemp(name.data())) throw IoFailure("no folder for a copy of " + store + ": set TMPDIR to one");
  folder_ = name;
  try {
    take(store);
  } catch (...) {
    fs::remove_all(folder_, error);
    throw;
  }
}

TakenCopy::~TakenCopy() {
  std::error_code no_matter;
  fs::remove_all(folder_, no_matter);
}

// A writer may move rows from the log into the file between the two copies: their states tell.
void TakenCopy::take(const std::string& store) const {
  constexpr int most_attempts = 5;
  const std::string log = store + "-wal", copied_log = file() + "-wal";
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    const auto before = std::pair(state_of(store), state_of(log));
    std::error_code error;
    for (const auto& earlier : {file(), copied_log}) fs::remove(earlier, error);
    fs::copy_file(store, file(), error);
    if (error) throw IoFailure(store + ": cannot be copied: " + error.message());
    if (before.second[1] > 0) fs::copy_file(log, copied_log, error);
    if (!error && before == std::pair(state_of(store), state_of(log))) {
      fs::permissions(file(), fs::perms::owner_read | fs::perms::owner_write, error);
      fs::permissions(copied_log, fs::perms::owner_read | fs::perms::owner_write, error);
      return;
    }
  }
  throw IoFailure(store + ": is being written to; merge it when its runs are done");
}

}  // namespace percal
