// Two vectors side by side, used as if they were one number. An element is one long chain of operations, each of which waits for the one
// before; two chains in turn fill each other's waits.                                   docs/decisions/0018-pairs-of-groups.md
#pragma once
#include "percal/math/lanes.hpp"

namespace percal::PERCAL_LEVEL {

template <class T>
struct Pair {
  T a, b;
  PERCAL_INLINE auto operator[](int lane) const {
    constexpr int half = static_cast<int>(sizeof(T) / sizeof(a[0]));
    return lane < half ? a[lane] : b[lane - half];
  }
};
template <class T>
struct Lane<Pair<T>> {
  using Real = RealOf<T>;
  using Bits = Pair<BitsOf<T>>;
  static constexpr int count = 2 * Lane<T>::count;
};

template <class T>
Pair(T, T) -> Pair<T>;

// By halves: as one piece of memory they would take the way through it.
template <class V>
  requires is_pair<V>
PERCAL_INLINE V load(const RealOf<V>* from) {
  using T = decltype(V::a);
  return {load<T>(from), load<T>(from + Lane<T>::count)};
}
template <class T>
PERCAL_INLINE void store(RealOf<T>* to, Pair<T> x) {
  store(to, x.a);
  store(to + Lane<T>::count, x.b);
}

// x OP y of pairs, and of a pair with one number.
#define PERCAL_OF_PAIRS(op)                                              \
  template <class T>                                                     \
  PERCAL_INLINE auto operator op(const Pair<T>& x, const Pair<T>& y) {   \
    return Pair{x.a op y.a, x.b op y.b};                                 \
  }                                                                      \
  template <class T, Number R>                                           \
  PERCAL_INLINE auto operator op(const Pair<T>& x, R y) {                \
    return Pair{x.a op y, x.b op y};                                     \
  }                                                                      \
  template <class T, Number R>                                           \
  PERCAL_INLINE auto operator op(R x, const Pair<T>& y) {                \
    return Pair{x op y.a, x op y.b};                                     \
  }
PERCAL_OF_PAIRS(+)
PERCAL_OF_PAIRS(-)
PERCAL_OF_PAIRS(*)
PERCAL_OF_PAIRS(/)
PERCAL_OF_PAIRS(>)
PERCAL_OF_PAIRS(<)
PERCAL_OF_PAIRS(&)
PERCAL_OF_PAIRS(|)
PERCAL_OF_PAIRS(<<)
PERCAL_OF_PAIRS(>>)
#undef PERCAL_OF_PAIRS

template <class T>
PERCAL_INLINE Pair<T> operator-(const Pair<T>& x) {
  return {-x.a, -x.b};
}
template <class T>
PERCAL_INLINE Pair<T> operator~(const Pair<T>& x) {
  return {~x.a, ~x.b};
}
template <class M, class T>
PERCAL_INLINE Pair<T> select(Pair<M> take_first, Pair<T> x, Pair<T> y) {
  return {select(take_first.a, x.a, y.a), select(take_first.b, x.b, y.b)};
}
template <class T>
PERCAL_INLINE Pair<T> larger(Pair<T> x, Pair<T> y) {
  return {larger(x.a, y.a), larger(x.b, y.b)};
}
template <class T>
PERCAL_INLINE Pair<T> smaller(Pair<T> x, Pair<T> y) {
  return {smaller(x.a, y.a), smaller(x.b, y.b)};
}
template <class T>
PERCAL_INLINE Pair<T> square_root(Pair<T> x) {
  return {square_root(x.a), square_root(x.b)};
}
template <class M>
PERCAL_INLINE bool any(Pair<M> mask) {
  return any(mask.a | mask.b);
}

// Rows of a column go on from vector to vector: `before` is the vector above the group at hand.
template <class T>
PERCAL_INLINE Pair<T> shifted(Pair<T> now, T before) {
  return {shifted(now.a, before), shifted(now.b, now.a)};
}
template <class T>
PERCAL_INLINE T last_vector(Pair<T> x) {
  return x.b;
}
template <Number T>
PERCAL_INLINE T last_vector(T x) {
  return x;
}

template <class T>
PERCAL_INLINE double lane_sum(Pair<T> x) {
  return lane_sum(x.a) + lane_sum(x.b);
}

// What a vector gathers from group to group.
template <class T>
PERCAL_INLINE void add(T& sum, T x) {
  sum += x;
}
template <class T>
PERCAL_INLINE void add(T& sum, Pair<T> x) {
  sum += x.a + x.b;
}
template <class T>
PERCAL_INLINE T largest(T so_far, T x) {
  return larger(so_far, x);
}
template <class T>
PERCAL_INLINE T largest(T so_far, Pair<T> x) {
  return larger(so_far, larger(x.a, x.b));
}
template <class T>
PERCAL_INLINE T smallest(T so_far, T x) {
  return smaller(so_far, x);
}
template <class T>
PERCAL_INLINE T smallest(T so_far, Pair<T> x) {
  return smaller(so_far, smaller(x.a, x.b));
}

}  // namespace percal::PERCAL_LEVEL
