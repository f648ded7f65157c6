#include "percal/store/claims.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace percal {
namespace {

// FNV-1a, cut to what a file's offset may be. Two keys of one byte only wait for each other.
long byte_of(const std::string& key) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : key) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return static_cast<long>(hash >> 2);
}

// Of the open file, not of the process: another store object of this process is another holder, and closing one takes no other's locks.
bool set_lock(int descriptor, short kind, long byte, long length) {
  struct flock lock {};
  lock.l_type = kind;
  lock.l_whence = SEEK_SET;
  lock.l_start = byte;
  lock.l_len = length;
  int result = 0;
  do result = fcntl(descriptor, F_OFD_SETLK, &lock);
  while (result == -1 && errno == EINTR);
  return result == 0;
}

bool is_held_by_another() { return errno == EAGAIN || errno == EACCES; }

constexpr long whole_file = 0;  // as a length

}  // namespace

// Who has the whole file has it alone, and takes it away.
Claims::~Claims() {
  if (descriptor_ < 0) return;
  if (set_lock(descriptor_, F_WRLCK, 0, whole_file) && is_still_named()) unlink(file_.c_str());
  close(descriptor_);
}

// Somebody may have taken the file away between its opening and the lock.
bool Claims::is_still_named() const {
  struct stat open_file {
  }, named{};
  return fstat(descriptor_, &open_file) == 0 && stat(file_.c_str(), &named) == 0 && open_file.st_ino == named.st_ino &&
         open_file.st_dev == named.st_dev;
}

// False where another process has it.
bool Claims::lock_byte(long byte) {
  for (;;) {
    if (descriptor_ < 0) descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) return true;
    if (!set_lock(descriptor_, F_WRLCK, byte, 1)) return !is_held_by_another();
    if (!taken_.empty() || is_still_named()) return true;
    close(descriptor_);
    descriptor_ = -1;
  }
}

std::optional<Claims::Claim> Claims::claim(const std::string& key) {
  const long byte = byte_of(key);
  const std::lock_guard lock(mutex_);
  if (taken_.contains(byte) || !lock_byte(byte)) return std::nullopt;
  taken_.insert(byte);
  return std::optional<Claim>(std::in_place, *this, byte);
}

void Claims::Claim::give_back() {
  if (!claims_) return;
  const std::lock_guard lock(claims_->mutex_);
  claims_->taken_.erase(byte_);
  if (claims_->descriptor_ >= 0) set_lock(claims_->descriptor_, F_UNLCK, byte_, 1);
}

}  // namespace percal
