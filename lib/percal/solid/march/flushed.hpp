// While it lives, numbers too small for their exponent count as 0 on this thread: quiet parts of a block are full of them, and each costs
// as much as a hundred others.     docs/theory/solid.md, "Speed"
#pragma once
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace percal {

class Flushed {
 public:
#if defined(__SSE2__)
  Flushed() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_results | flush_operands); }
  ~Flushed() { _mm_setcsr(before_); }
#else
  Flushed() = default;
#endif
  Flushed(const Flushed&) = delete;
  Flushed& operator=(const Flushed&) = delete;

 private:
#if defined(__SSE2__)
  static constexpr unsigned flush_results = 0x8000, flush_operands = 0x0040;
  unsigned before_;
#endif
};

}  // namespace percal
