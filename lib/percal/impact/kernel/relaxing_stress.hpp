// Stress that relaxes: finite linear viscoelasticity (J. C. Simo, Comput. Methods Appl. Mech. Eng. 60, 1987, 153), on
// the isochoric second Piola stress of the instantaneous solid. docs/theory/target.md (6) to (9).
#pragma once
#include "percal/impact/kernel/uniform_solid.hpp"

namespace percal::PERCAL_LEVEL {

template <class V>
struct Symmetric {
  V rr, rz, zz, hoop;
};
template <class V>
PERCAL_INLINE Symmetric<V> operator+(const Symmetric<V>& a, const Symmetric<V>& b) {
  return {a.rr + b.rr, a.rz + b.rz, a.zz + b.zz, a.hoop + b.hoop};
}
template <class V>
PERCAL_INLINE Symmetric<V> operator-(const Symmetric<V>& a, const Symmetric<V>& b) {
  return {a.rr - b.rr, a.rz - b.rz, a.zz - b.zz, a.hoop - b.hoop};
}
template <class V>
PERCAL_INLINE Symmetric<V> operator*(RealOf<V> x, const Symmetric<V>& a) {
  return {x * a.rr, x * a.rz, x * a.zz, x * a.hoop};
}
template <class V>
PERCAL_INLINE V contracted(const Symmetric<V>& a, const Symmetric<V>& b) {
  return a.rr * b.rr + a.zz * b.zz + RealOf<V>(2) * (a.rz * b.rz) + a.hoop * b.hoop;
}
template <class V>
PERCAL_INLINE Symmetric<V> load_tensor(const TensorField<RealOf<V>>& field, long n) {
  return {load<V>(field.rr + n), load<V>(field.rz + n), load<V>(field.zz + n), load<V>(field.hoop + n)};
}
template <class V>
PERCAL_INLINE void store_tensor(const TensorField<RealOf<V>>& field, long n, const Symmetric<V>& a) {
  store(field.rr + n, a.rr);
  store(field.rz + n, a.rz);
  store(field.zz + n, a.zz);
  store(field.hoop + n, a.hoop);
}

// C - 1.
template <class V>
PERCAL_INLINE Symmetric<V> squared_stretch_less_one(const Gradient<V>& F) {
  using Real = RealOf<V>;
  return {F.rr * F.rr + F.zr * F.zr - Real(1), F.rr * F.rz + F.zr * F.zz, F.rz * F.rz + F.zz * F.zz - Real(1),
          F.hoop * F.hoop - Real(1)};
}

// The principal t_i/lambda_i^2 turned into place, as in first_piola.
template <class V>
PERCAL_INLINE Symmetric<V> second_piola(const Stretches<V>& s, const PrincipalStress<V>& t) {
  using Real = RealOf<V>;
  const V S1 = t.first * s.inverse_first2, S2 = t.second * s.inverse_second2;
  const V mean = Real(0.5) * (S1 + S2), part = Real(0.5) * (S1 - S2) * s.inverse_split;
  return {mean + part * s.half_difference, part * s.shear, mean - part * s.half_difference,
          t.hoop * s.inverse_hoop * s.inverse_hoop};
}

// F S, S a second Piola stress.
template <class V>
PERCAL_INLINE Piola<V> pushed(const Gradient<V>& F, const Symmetric<V>& S) {
  return {F.rr * S.rr + F.rz * S.rz, F.rr * S.rz + F.rz * S.zz, F.zr * S.rr + F.zz * S.rz, F.zr * S.rz + F.zz * S.zz,
          F.hoop * S.hoop};
}

// Kirchhoff stress P F^T.
template <class V>
PERCAL_INLINE Symmetric<V> kirchhoff(const Gradient<V>& F, const Piola<V>& P) {
  return {P.rr * F.rr + P.rz * F.rz, P.rr * F.zr + P.rz * F.zz, P.zr * F.zr + P.zz * F.zz, P.hoop * F.hoop};
}
template <class V>
PERCAL_INLINE V largest_principal(const Symmetric<V>& a) {
  using Real = RealOf<V>;
  const V half = Real(0.5) * (a.rr - a.zz);
  return larger(Real(0.5) * (a.rr + a.zz) + square_root(half * half + a.rz * a.rz), a.hoop);
}

// The series of one column of elements. Factors of decay are kept while the step stays the same.
template <class Real>
class RelaxingStress {
 public:
  using V = typename VectorOf<Real>::type;

  RelaxingStress(const RelaxationView<Real>& view, int column, long start, double time)
      : view_(view),
        looked_at_(view.looked_at + static_cast<long>(column) * view.groups_per_column),
        start_(start),
        time_(time) {
    double sum = 0;
    for (int k = 0; k < view.terms; ++k) sum += view.term[k].share;
    relaxing_share_ = Real(sum);
  }

  // What relaxation has made of a second Piola stress: sum H_k - (sum g_k) S, and the work of the H_k since the last
  // look, all of it and what is left of it when they vanish at its end (per undeformed volume).
  struct Change {
    Symmetric<V> stress;
    V work, work_if_gone;
  };
  PERCAL_INLINE Change advance(int j, const Gradient<V>& F, const Symmetric<V>& isochoric) {
    const long n = start_ + j;
    set_decay(j / Lane<V>::count);
    const Symmetric<V> strain = squared_stretch_less_one(F);
    const Symmetric<V> stretched = strain - load_tensor<V>(view_.strain, n);
    const Symmetric<V> loaded = isochoric - load_tensor<V>(view_.isochoric, n);
    Symmetric<V> before{}, after{};
    for (int k = 0; k < view_.terms; ++k) {
      const Symmetric<V> old = load_tensor<V>(view_.overstress[k], n);
      const Symmetric<V> overstress = decay_[k] * old + half_decay_[k] * loaded;
      store_tensor(view_.overstress[k], n, overstress);
      before = before + old;
      after = after + overstress;
    }
    store_tensor(view_.strain, n, strain);
    store_tensor(view_.isochoric, n, isochoric);
    // The trapezoidal rule over the strain (C - 1)/2.
    const V first_half = Real(0.25) * contracted(before, stretched);
    return {after - relaxing_share_ * isochoric, first_half + Real(0.25) * contracted(after, stretched), first_half};
  }

 private:
  void set_decay(int group) {
    const double step = time_ - looked_at_[group];
    looked_at_[group] = time_;
    if (step == step_) return;
    step_ = step;
    for (int k = 0; k < view_.terms; ++k) {
      const double half = __builtin_exp(-0.5 * step / view_.term[k].time);
      decay_[k] = Real(half * half);
      half_decay_[k] = Real(view_.term[k].share * half);
    }
  }

  const RelaxationView<Real>& view_;
  double* looked_at_;
  const long start_;
  const double time_;
  double step_ = -1;
  Real relaxing_share_;
  Real decay_[most_relaxing_terms] = {}, half_decay_[most_relaxing_terms] = {};
};

}  // namespace percal::PERCAL_LEVEL
