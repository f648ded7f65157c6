// What one core of this machine reaches in two tiny loops, for a roofline.
#pragma once
#include <array>
#include <cstddef>

namespace percal::bench {

// Single-precision additions and multiplications a second, in multiply-adds that do not wait for each other. Best of some tries.
double multiply_add_flops();

// a[i] = b[i] + s c[i]: bytes read and written a second (12 for each i), the three arrays together taking `bytes`. Best of some tries.
double triad_bytes_per_second(std::size_t bytes);

struct MemorySize {
  const char* name;
  std::size_t bytes;
};
inline constexpr std::array<MemorySize, 3> memory_sizes{
    {{"second-level cache", 400'000}, {"third-level cache", 12'000'000}, {"memory", 300'000'000}}};

}  // namespace percal::bench
