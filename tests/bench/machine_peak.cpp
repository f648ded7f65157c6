// Compiled for the machine that builds it (tests/bench/CMakeLists.txt).
#include "bench/machine_peak.hpp"

#include <algorithm>
#include <ctime>
#include <vector>

namespace percal::bench {
namespace {

#if defined(__AVX512F__)
constexpr int vector_bytes = 64;
#elif defined(__AVX__)
constexpr int vector_bytes = 32;
#else
constexpr int vector_bytes = 16;
#endif
typedef float Vector __attribute__((vector_size(vector_bytes)));

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double best_seconds(int tries, Work work) {
  double best = 1e30;
  for (int k = 0; k < tries; ++k) {
    const double start = cpu_seconds();
    work();
    best = std::min(best, cpu_seconds() - start);
  }
  return best;
}

template <class Value>
void keep(Value& value) {
  asm volatile("" : "+m"(value) : : "memory");
}

}  // namespace

double multiply_add_flops() {
  constexpr int chains = 12, rounds = 2'000'000;
  constexpr int lanes = vector_bytes / static_cast<int>(sizeof(float));
  float factor = 0.999f, offset = 0.001f;
  keep(factor);
  keep(offset);
  const Vector f = Vector{} + factor, o = Vector{} + offset;
  Vector x[chains] = {};
  const double seconds = best_seconds(9, [&] {
    Vector y[chains];
    for (int c = 0; c < chains; ++c) y[c] = x[c];
    for (int k = 0; k < rounds; ++k)
#pragma GCC unroll 12
      for (int c = 0; c < chains; ++c) y[c] = y[c] * f + o;
    for (int c = 0; c < chains; ++c) x[c] = y[c];
    keep(x);
  });
  return 2.0 * lanes * chains * rounds / seconds;
}

double triad_bytes_per_second(std::size_t bytes) {
  const std::size_t n = bytes / (3 * sizeof(float));
  const int rounds = static_cast<int>(std::max<std::size_t>(1, 60'000'000 / n));
  std::vector<float> a(n, 0), b(n, 1), c(n, 2);
  const double seconds = best_seconds(7, [&] {
    for (int k = 0; k < rounds; ++k) {
      float *to = a.data(), s = 0.5f;
      const float *first = b.data(), *second = c.data();
      keep(s);
#pragma GCC ivdep
      for (std::size_t i = 0; i < n; ++i) to[i] = first[i] + s * second[i];
      keep(to);
    }
  });
  return 3.0 * sizeof(float) * static_cast<double>(n) * rounds / seconds;
}

}  // namespace percal::bench
