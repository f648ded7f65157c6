// Lanes: the compiler's vector types used as if they were one number, so that a formula is written once for scalars and
// vectors. This header is compiled once for each instruction level and once without (PERCAL_LEVEL, see kernel_level.cpp);
// the level's namespace keeps the versions apart, and nothing of the standard library is instantiated here.
#pragma once

#ifndef PERCAL_LEVEL
#define PERCAL_LEVEL scalar
#endif

#if defined(__AVX512F__) || defined(__AVX2__) || defined(__SSE4_2__)
#include <immintrin.h>
#endif

namespace percal::PERCAL_LEVEL {

// Vectors of this level: 64, 32 or 16 bytes.
#if defined(__AVX512F__)
inline constexpr int vector_bytes = 64;
#elif defined(__AVX2__)
inline constexpr int vector_bytes = 32;
#else
inline constexpr int vector_bytes = 16;
#endif

// For V = a vector or a scalar: its scalar type, the signed integers of the same size, and how many lanes it has.
template <class V>
struct Lane;
template <class Scalar, class Integer, int bytes>
struct VectorLane {
  using Real = Scalar;
  typedef Scalar Vector __attribute__((vector_size(bytes)));
  typedef Integer Bits __attribute__((vector_size(bytes)));
  static constexpr int count = bytes / static_cast<int>(sizeof(Scalar));
};
using FloatLanes = VectorLane<float, int, vector_bytes>;
using DoubleLanes = VectorLane<double, long, vector_bytes>;
template <>
struct Lane<FloatLanes::Vector> : FloatLanes {};
template <>
struct Lane<DoubleLanes::Vector> : DoubleLanes {};
template <>
struct Lane<float> {
  using Real = float;
  using Bits = int;
  static constexpr int count = 1;
};
template <>
struct Lane<double> {
  using Real = double;
  using Bits = long;
  static constexpr int count = 1;
};

template <class V>
using RealOf = typename Lane<V>::Real;
template <class V>
using BitsOf = typename Lane<V>::Bits;

#define PERCAL_INLINE inline __attribute__((always_inline))

// Two vectors side by side are no vector: pair.hpp.
template <class T>
struct Pair;
template <class T>
inline constexpr bool is_pair = false;
template <class T>
inline constexpr bool is_pair<Pair<T>> = true;
template <class T>
concept Number = !is_pair<T>;

template <Number V>
PERCAL_INLINE V load(const RealOf<V>* from) {
  V v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
template <class V>
PERCAL_INLINE void store(RealOf<V>* to, V v) {
  __builtin_memcpy(to, &v, sizeof v);
}
template <class To, class From>
PERCAL_INLINE To same_bits(From from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  __builtin_memcpy(&to, &from, sizeof to);
  return to;
}
template <class V>
PERCAL_INLINE V broadcast(RealOf<V> x) {
  return V{} + x;
}

// x in the first lane, 0 in the others.
template <class V>
PERCAL_INLINE V first_lane(RealOf<V> x) {
  V v{};
  v[0] = x;
  return v;
}

// take_first ? a : b, lane by lane; take_first is what a comparison of V returns.
template <class M, class V>
PERCAL_INLINE V select(M take_first, V a, V b) {
  return take_first ? a : b;
}
// The larger and the smaller of two, b where one of them is not a number: one instruction where the level has it.
template <class V>
PERCAL_INLINE V larger(V a, V b) {
  return a > b ? a : b;
}
template <class V>
PERCAL_INLINE V smaller(V a, V b) {
  return a < b ? a : b;
}
#if defined(__AVX512F__)
PERCAL_INLINE FloatLanes::Vector larger(FloatLanes::Vector a, FloatLanes::Vector b) {
  return (FloatLanes::Vector)_mm512_max_ps((__m512)a, (__m512)b);
}
PERCAL_INLINE FloatLanes::Vector smaller(FloatLanes::Vector a, FloatLanes::Vector b) {
  return (FloatLanes::Vector)_mm512_min_ps((__m512)a, (__m512)b);
}
#elif defined(__AVX2__)
PERCAL_INLINE FloatLanes::Vector larger(FloatLanes::Vector a, FloatLanes::Vector b) {
  return (FloatLanes::Vector)_mm256_max_ps((__m256)a, (__m256)b);
}
PERCAL_INLINE FloatLanes::Vector smaller(FloatLanes::Vector a, FloatLanes::Vector b) {
  return (FloatLanes::Vector)_mm256_min_ps((__m256)a, (__m256)b);
}
#elif defined(__SSE4_2__)
PERCAL_INLINE FloatLanes::Vector larger(FloatLanes::Vector a, FloatLanes::Vector b) {
  return (FloatLanes::Vector)_mm_max_ps((__m128)a, (__m128)b);
}
PERCAL_INLINE FloatLanes::Vector smaller(FloatLanes::Vector a, FloatLanes::Vector b) {
  return (FloatLanes::Vector)_mm_min_ps((__m128)a, (__m128)b);
}
#endif

PERCAL_INLINE float square_root(float x) { return __builtin_sqrtf(x); }
PERCAL_INLINE double square_root(double x) { return __builtin_sqrt(x); }
#if defined(__AVX512F__)
PERCAL_INLINE FloatLanes::Vector square_root(FloatLanes::Vector x) {
  return (FloatLanes::Vector)_mm512_sqrt_ps((__m512)x);
}
PERCAL_INLINE DoubleLanes::Vector square_root(DoubleLanes::Vector x) {
  return (DoubleLanes::Vector)_mm512_sqrt_pd((__m512d)x);
}
#elif defined(__AVX2__)
PERCAL_INLINE FloatLanes::Vector square_root(FloatLanes::Vector x) {
  return (FloatLanes::Vector)_mm256_sqrt_ps((__m256)x);
}
PERCAL_INLINE DoubleLanes::Vector square_root(DoubleLanes::Vector x) {
  return (DoubleLanes::Vector)_mm256_sqrt_pd((__m256d)x);
}
#elif defined(__SSE4_2__)
PERCAL_INLINE FloatLanes::Vector square_root(FloatLanes::Vector x) {
  return (FloatLanes::Vector)_mm_sqrt_ps((__m128)x);
}
PERCAL_INLINE DoubleLanes::Vector square_root(DoubleLanes::Vector x) {
  return (DoubleLanes::Vector)_mm_sqrt_pd((__m128d)x);
}
#else
template <class V>
PERCAL_INLINE V square_root(V x) {
  for (int l = 0; l < Lane<V>::count; ++l) x[l] = square_root(x[l]);
  return x;
}
#endif

// Whether a mask, as comparisons return it, is set in some lane.
template <class M>
PERCAL_INLINE bool any(M mask) {
#if defined(__AVX512F__)
  if constexpr (sizeof(mask[0]) == 4)
    return _mm512_test_epi32_mask((__m512i)mask, (__m512i)mask) != 0;
  else
    return _mm512_test_epi64_mask((__m512i)mask, (__m512i)mask) != 0;
#elif defined(__AVX2__)
  if constexpr (sizeof(mask[0]) == 4)
    return _mm256_movemask_ps((__m256)mask) != 0;
  else
    return _mm256_movemask_pd((__m256d)mask) != 0;
#elif defined(__SSE4_2__)
  if constexpr (sizeof(mask[0]) == 4)
    return _mm_movemask_ps((__m128)mask) != 0;
  else
    return _mm_movemask_pd((__m128d)mask) != 0;
#else
  for (unsigned l = 0; l < sizeof(M) / sizeof(mask[0]); ++l)
    if (mask[l]) return true;
  return false;
#endif
}

// Lane l takes what lane l + by has.
template <int by, class V>
PERCAL_INLINE V rotated(V v) {
  constexpr int count = Lane<V>::count;
#if defined(__clang__)
  V turned{};
  for (int l = 0; l < count; ++l) turned[l] = v[(l + by) % count];
  return turned;
#else
  BitsOf<V> from{};
#pragma GCC unroll 16
  for (int l = 0; l < count; ++l) from[l] = (l + by) % count;
  return __builtin_shuffle(v, from);
#endif
}

// The sum and the extremes over the lanes: one half with the other, then the halves of that.
template <class V, class Take, int apart = Lane<V>::count / 2>
PERCAL_INLINE RealOf<V> over_lanes(V v, Take take) {
  if constexpr (apart == 0)
    return v[0];
  else
    return over_lanes<V, Take, apart / 2>(take(v, rotated<apart>(v)), take);
}
template <class V>
PERCAL_INLINE double lane_sum(V v) {
  return static_cast<double>(over_lanes(v, [](V a, V b) { return a + b; }));
}
template <class V>
PERCAL_INLINE RealOf<V> lane_largest(V v) {
  return over_lanes(v, [](V a, V b) { return larger(a, b); });
}
template <class V>
PERCAL_INLINE RealOf<V> lane_smallest(V v) {
  return over_lanes(v, [](V a, V b) { return smaller(a, b); });
}

// `now` moved up by one lane, the last lane of `before` moving in: what element j-1 gives to node j.
template <class V>
PERCAL_INLINE V shifted(V now, V before) {
  constexpr int count = Lane<V>::count;
#if defined(__clang__)
  V up{};
  for (int l = 0; l < count; ++l) up[l] = l == 0 ? before[count - 1] : now[l - 1];
  return up;
#else
  BitsOf<V> from{};
#pragma GCC unroll 16
  for (int l = 0; l < count; ++l) from[l] = count - 1 + l;
  return __builtin_shuffle(before, now, from);
#endif
}

// --- log2 and exp2 --------------------------------------------------------------------------------------------------
// Own versions: libm has no lanes, and these give every lane the same bits whatever the width. Ranges: normal numbers in,
// |x| clamped to 126 (float) or 1022 (double) for exp2. Errors are held in tests/math.
template <class Real>
struct FloatFormat;
template <>
struct FloatFormat<float> {
  static constexpr int mantissa_bits = 23, bias = 127, largest_power = 126, log_terms = 5, exp_terms = 7;
  static constexpr int root_half = 0x3f3504f3;   // the bits of sqrt(1/2)
  static constexpr float rounder = 12582912.0f;  // 1.5 2^23: adding it rounds to an integer
};
template <>
struct FloatFormat<double> {
  static constexpr int mantissa_bits = 52, bias = 1023, largest_power = 1022, log_terms = 11, exp_terms = 13;
  static constexpr long root_half = 0x3fe6a09e667f3bcdL;
  static constexpr double rounder = 6755399441055744.0;  // 1.5 2^52
};

// (2/ln 2)/(2k + 1): the series of log2((1 + s)/(1 - s)) in odd powers of s.
template <class Real>
constexpr Real log_coefficient(int k) {
  return static_cast<Real>(2.8853900817779268147 / (2 * k + 1));
}
// ln(2)^k / k!: the series of 2^x.
template <class Real>
constexpr Real exp_coefficient(int k) {
  double c = 1;
  for (int i = 1; i <= k; ++i) c *= 0.69314718055994530942 / i;
  return static_cast<Real>(c);
}

template <class V>
PERCAL_INLINE V log2_of(V x) {
  using Real = RealOf<V>;
  using Bits = BitsOf<V>;
  using Format = FloatFormat<Real>;
  const Bits bits = same_bits<Bits>(x);
  const Bits power = (bits - Format::root_half) >> Format::mantissa_bits;
  const V m = same_bits<V>(Bits(bits - (power << Format::mantissa_bits)));  // in [sqrt(1/2), sqrt 2)
  // power is below 2^11: placing it in the low bits of `rounder` makes it a number without a conversion instruction.
  const V exponent = same_bits<V>(Bits(same_bits<Bits>(broadcast<V>(Format::rounder)) + power)) - Format::rounder;
  const V s = (m - Real(1)) / (m + Real(1)), z = s * s;
  V series = broadcast<V>(log_coefficient<Real>(Format::log_terms - 1));
#pragma GCC unroll 16
  for (int k = Format::log_terms - 2; k >= 0; --k) series = series * z + log_coefficient<Real>(k);
  return series * s + exponent;
}

template <class V>
PERCAL_INLINE V exp2_of(V x) {
  using Real = RealOf<V>;
  using Bits = BitsOf<V>;
  using Format = FloatFormat<Real>;
  const Real limit = Format::largest_power;
  x = smaller(larger(x, broadcast<V>(-limit)), broadcast<V>(limit));
  const V shifted_up = x + Format::rounder;
  const V f = x - (shifted_up - Format::rounder);  // in [-1/2, 1/2]
  V series = broadcast<V>(exp_coefficient<Real>(Format::exp_terms));
#pragma GCC unroll 16
  for (int k = Format::exp_terms - 1; k >= 0; --k) series = series * f + exp_coefficient<Real>(k);
  // The low bits of shifted_up hold the integer: moved to the exponent field and added there, they multiply by 2^n.
  const Bits n = same_bits<Bits>(shifted_up) << Format::mantissa_bits;
  return same_bits<V>(Bits(same_bits<Bits>(series) + n));
}

}  // namespace percal::PERCAL_LEVEL
