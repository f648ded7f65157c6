// Who is at work on what: processes that share a store do not do the same run twice.     docs/decisions/0020-claims.md
#pragma once
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace percal {

// Claims on the keys of a store, each a lock of the kernel on one byte of the file STORE-claims: the kernel gives it back when the
// process that has it ends, however it ends. The file is made with the first claim and goes with the last process that has it open. Where a file
// system has no locks, or gives no file, everybody gets every claim: work is then done twice, never wrongly. Safe to use from several
// threads; they exclude each other, too.
class Claims {
 public:
  explicit Claims(std::string store_file) : file_(std::move(store_file) + "-claims") {}
  ~Claims();
  Claims(const Claims&) = delete;
  Claims& operator=(const Claims&) = delete;

  // Given back at the latest with the object.
  class Claim {
   public:
    Claim(Claims& claims, long byte) : claims_(&claims), byte_(byte) {}
    ~Claim() { give_back(); }
    Claim(Claim&& other) noexcept : claims_(std::exchange(other.claims_, nullptr)), byte_(other.byte_) {}
    Claim& operator=(Claim&&) = delete;

   private:
    void give_back();
    Claims* claims_;
    long byte_;
  };

  // Nothing where another thread or process has it.
  std::optional<Claim> claim(const std::string& key);

 private:
  bool is_still_named() const;
  bool lock_byte(long byte);

  const std::string file_;
  std::mutex mutex_;
  std::set<long> taken_;  // here
  int descriptor_ = -1;
};

}  // namespace percal
