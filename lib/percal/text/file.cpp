#include "percal/text/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>

#include "percal/base/error.hpp"

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
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  int close() { return ::close(std::exchange(number_, -1)); }

 private:
  int number_;
};

// Holds back, on this thread, the signals that ask the program to end.
class EndLater {
 public:
  EndLater() {
    sigset_t ends;
    sigemptyset(&ends);
    sigaddset(&ends, SIGINT);
    sigaddset(&ends, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &ends, &before_);
  }
  ~EndLater() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  EndLater(const EndLater&) = delete;
  EndLater& operator=(const EndLater&) = delete;

 private:
  sigset_t before_;
};

// A name that is removed again unless it was renamed, also where somebody interrupts the program meanwhile.
class TemporaryName {
 public:
  explicit TemporaryName(const fs::path& folder) {
    static std::atomic<unsigned> counter{0};
    name_ = (folder / (".percal-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp")).string();
  }
  ~TemporaryName() {
    if (!name_.empty()) ::unlink(name_.c_str());
  }
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  const char* text() const { return name_.c_str(); }
  void renamed() { name_.clear(); }

 private:
  EndLater end_later_;  // gone after the name is
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
  TemporaryName temporary(folder);
  Descriptor file(::open(temporary.text(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.number() < 0) fail(path, "cannot create a file in its folder", errno);
  struct stat before;
  if (::stat(target.c_str(), &before) == 0) {
    if (::fchmod(file.number(), before.st_mode & 07777) != 0) fail(path, "cannot keep its permissions", errno);
  }
  write_all(file.number(), content, path);
  sync(file.number(), path);
  if (file.close() != 0) fail(path, "cannot write", errno);
  if (::rename(temporary.text(), target.c_str()) != 0) fail(path, "cannot put the finished file in place", errno);
  temporary.renamed();
  // The new name itself must survive a power cut too; a file system that cannot do so has still got the file.
  const Descriptor names(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (names.number() >= 0) ::fsync(names.number());
}

}  // namespace

void write_file(const std::string& path, const std::string& content) {
  if (path.empty() || path.find('\0') != std::string::npos)
    throw IoFailure("a file name may not be empty or hold a zero byte");
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) fail(path, "cannot write", EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_in_place(path, content);
  // A link stays a link: what it points to is replaced.
  const fs::path target = fs::is_regular_file(status) ? fs::canonical(path, error) : fs::path(path);
  if (error && fs::is_regular_file(status)) fail(path, "cannot follow the link", error.value());
  create_folders(folder_of(target));
  replace(target, content, path);
}

std::string read_file(const std::string& path) {
  constexpr std::size_t largest = std::size_t{1} << 30;  // bytes; no input of this program is near it
  if (path.empty() || path.find('\0') != std::string::npos)
    throw BadInput("a file name may not be empty or hold a zero byte");
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) {
    if (errno == ENOENT || errno == ENOTDIR || errno == ELOOP || errno == ENAMETOOLONG)
      throw BadInput(path + ": there is no such file");
    fail(path, "cannot read", errno);
  }
  struct stat status;
  if (::fstat(file.number(), &status) == 0 && S_ISDIR(status.st_mode))
    throw BadInput(path + ": is a folder, not a file");
  std::string content;
  char block[1 << 16];
  for (;;) {
    const ssize_t count = ::read(file.number(), block, sizeof block);
    if (count == 0) return content;
    if (count < 0 && errno != EINTR) fail(path, "cannot read", errno);
    if (count > 0) content.append(block, static_cast<std::size_t>(count));
    if (content.size() > largest) throw BadInput(path + ": is larger than 1 GiB");
  }
}

void ensure_writable_folder(const std::string& folder) {
  if (folder.empty()) throw IoFailure("the name of the folder for results is empty");
  create_folders(folder);
  const TemporaryName probe(folder);
  Descriptor file(::open(probe.text(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.number() < 0) fail(folder, "cannot create files in this folder", errno);
  write_all(file.number(), std::string(4096, '\n'), folder);  // one disk block, so that a full disk shows
  sync(file.number(), folder);
  if (file.close() != 0) fail(folder, "cannot write files in this folder", errno);
}

}  // namespace percal
