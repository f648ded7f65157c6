#include "percal/text/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <random>
#include <set>
#include <utility>

#include "percal/base/ending.hpp"
#include "percal/base/error.hpp"
#include "percal/base/inputs.hpp"

namespace percal {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& what, int error) {
  throw IoFailure(path + ": " + what + ": " + std::strerror(error));
}

// A file descriptor that is closed whatever happens.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  int number() const { return number_; }
  int close() { return ::close(std::exchange(number_, -1)); }

 private:
  int number_;
};

// Files of this form are nobody's but those of a process that writes, and holds a lock on them.
constexpr std::string_view temporary_prefix = ".percal-", temporary_suffix = ".tmp";

bool is_temporary_name(const std::string& name) {
  return name.starts_with(temporary_prefix) && name.ends_with(temporary_suffix);
}

// Removes what killed processes have left in the folder. Looked for once in each folder.
void tidy(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<std::string> tidied;
  {
    const std::lock_guard lock(mutex);
    if (!tidied.insert(folder.string()).second) return;
  }
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const fs::path& path = entry->path();
    if (!is_temporary_name(path.filename().string())) continue;
    const Descriptor file(::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (file.number() >= 0 && ::flock(file.number(), LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
  }
}

// A new file under a name of its own, locked, and removed again unless it was renamed. The process does not end on a signal
// meanwhile; where it is killed, the lock goes with it and the next one that writes here tidies up.
class TemporaryFile {
 public:
  // `path`: for messages.
  TemporaryFile(const fs::path& folder, const std::string& path) : file_(-1) {
    tidy(folder);
    constexpr int most_attempts = 100;
    std::random_device random;
    for (int attempt = 0; file_.number() < 0; ++attempt) {
      name_ =
          (folder / fmt::format("{}{:08x}{:08x}{}", temporary_prefix, random(), random(), temporary_suffix)).string();
      Descriptor file(::open(name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
      if (file.number() < 0 && (errno != EEXIST || attempt == most_attempts)) {
        const int reason = errno;
        name_.clear();
        fail(path, "cannot create a file in its folder", reason);
      }
      if (file.number() < 0) continue;
      ::flock(file.number(), LOCK_EX);  // a file system without locks has nobody who tidies either
      struct stat status;
      if (::fstat(file.number(), &status) == 0 && status.st_nlink == 0) continue;  // tidied away before the lock
      file_ = std::move(file);
    }
  }
  ~TemporaryFile() {
    if (!name_.empty()) ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  int number() const { return file_.number(); }

  // In place of `target`; the lock is kept until then. Returns false with errno where it cannot be.
  bool rename_to(const fs::path& target) {
    if (::rename(name_.c_str(), target.c_str()) != 0) return false;
    name_.clear();
    return true;
  }

 private:
  EndLater end_later_;  // gone after the name is
  Descriptor file_;
  std::string name_;
};

void write_all(int file, const std::string& content, const std::string& path) {
  for (std::size_t written = 0; written < content.size();) {
    const ssize_t count = ::write(file, content.data() + written, content.size() - written);
    if (count < 0 && errno != EINTR) fail(path, "cannot write", errno);
    if (count > 0) written += static_cast<std::size_t>(count);
  }
}

// Pipes and devices cannot be synced, and need not be.
void sync(int file, const std::string& path) {
  while (::fsync(file) != 0) {
    if (errno == EINVAL || errno == EROFS || errno == ENOTSUP) return;
    if (errno != EINTR) fail(path, "cannot write to the disk", errno);
  }
}

void create_folders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail(folder.string(), "cannot create the folder", error.value());
  if (!fs::is_directory(folder, error)) fail(folder.string(), "cannot be used as a folder", ENOTDIR);
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

// What is neither a file nor a folder (/dev/stdout, a pipe) is written to as it stands: renaming over it would replace
// it.
void write_in_place(const std::string& path, const std::string& content) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.number() < 0) fail(path, "cannot write", errno);
  write_all(file.number(), content, path);
  sync(file.number(), path);
  if (file.close() != 0) fail(path, "cannot write", errno);
}

// Writes `content` under a temporary name beside `target`, then renames. `path` is the name for messages.
void replace(const fs::path& target, const std::string& content, const std::string& path) {
  const fs::path folder = folder_of(target);
  TemporaryFile file(folder, path);
  struct stat before;
  if (::stat(target.c_str(), &before) == 0) {
    if (::fchmod(file.number(), before.st_mode & 07777) != 0) fail(path, "cannot keep its permissions", errno);
  }
  write_all(file.number(), content, path);
  sync(file.number(), path);
  if (!file.rename_to(target)) fail(path, "cannot put the finished file in place", errno);
  // The new name itself must survive a power cut too; a file system that cannot do so has still got the file.
  const Descriptor names(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (names.number() >= 0) ::fsync(names.number());
}

// What `path` is, followed where it is a link. Throws where it cannot be a file's name, or is a folder's.
fs::file_status status_of(const std::string& path) {
  if (path.empty() || path.find('\0') != std::string::npos)
    throw IoFailure("a file name may not be empty or hold a zero byte");
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) throw IoFailure(path + ": is a folder, not a file");
  return status;
}

bool is_pipe_or_device(const fs::file_status& status) { return fs::exists(status) && !fs::is_regular_file(status); }

}  // namespace

void write_file(const std::string& path, const std::string& content) {
  const fs::file_status status = status_of(path);
  if (is_pipe_or_device(status)) return write_in_place(path, content);
  refuse_to_replace_input(path);
  // A link stays a link: what it points to is replaced.
  std::error_code error;
  const fs::path target = fs::is_regular_file(status) ? fs::canonical(path, error) : fs::path(path);
  if (error) fail(path, "cannot follow the link", error.value());
  create_folders(folder_of(target));
  replace(target, content, path);
}

std::string read_output(const std::string& path) {
  constexpr std::size_t largest = std::size_t{1} << 30;  // bytes; no input of this program is near it
  if (path.empty() || path.find('\0') != std::string::npos)
    throw BadInput("a file name may not be empty or hold a zero byte");
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) {
    if (errno == ENOENT || errno == ENOTDIR || errno == ELOOP || errno == ENAMETOOLONG) throw NoSuchFile(path);
    fail(path, "cannot read", errno);
  }
  struct stat status;
  if (::fstat(file.number(), &status) != 0) fail(path, "cannot read", errno);
  if (S_ISDIR(status.st_mode)) throw BadInput(path + ": is a folder, not a file");
  std::string content;
  if (S_ISREG(status.st_mode)) {
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size > largest) throw BadInput(path + ": is larger than 1 GiB");
    try {
      content.reserve(size);
    } catch (const std::bad_alloc&) {
      throw NoMemory(path, static_cast<double>(size));
    }
  }
  char block[1 << 16];
  for (;;) {
    const ssize_t count = ::read(file.number(), block, sizeof block);
    if (count == 0) return content;
    if (count < 0 && errno != EINTR) fail(path, "cannot read", errno);
    if (count > 0) content.append(block, static_cast<std::size_t>(count));
    if (content.size() > largest) throw BadInput(path + ": is larger than 1 GiB");
  }
}

std::string read_file(const std::string& path) {
  std::string content = read_output(path);
  remember_input(path);
  return content;
}

void ensure_writable_folder(const std::string& folder) {
  if (folder.empty()) throw IoFailure("the name of the folder for results is empty");
  create_folders(folder);
  TemporaryFile probe(folder, folder);
  write_all(probe.number(), std::string(4096, '\n'), folder);  // one disk block, so that a full disk shows
  sync(probe.number(), folder);
}

void ensure_writable_file(const std::string& path) {
  if (is_pipe_or_device(status_of(path))) return;
  refuse_to_replace_input(path);
  ensure_writable_folder(folder_of(path).string());
}

}  // namespace percal
