// The kernel for one instruction level: compiled once for each, with PERCAL_LEVEL naming it (cmake/PercalKernel.cmake).
#include "percal/impact/element.hpp"
#include "percal/impact/kernel.hpp"

namespace percal::PERCAL_LEVEL {
namespace {

template <class Real>
struct VectorOf;
template <>
struct VectorOf<float> {
  using type = FloatLanes::Vector;
};
template <>
struct VectorOf<double> {
  using type = DoubleLanes::Vector;
};

template <class Real>
void clear(Real* column, int count) {
  __builtin_memset(column, 0, sizeof(Real) * static_cast<unsigned>(count));
}

// Forces on the corners of a column of elements: inner upper (node i, j), outer upper (i+1, j), outer lower (i+1, j+1), inner
// lower (i, j+1).
template <class Real>
void internal_forces(const FieldsView<Real>& fields, int column, int row_end, const ColumnShape& shape,
                     const MaterialConstants& material, double previous_step, int* doomed, ColumnReport& report) {
  using V = typename VectorOf<Real>::type;
  constexpr int lanes = Lane<V>::count;
  const long inner = static_cast<long>(column) * fields.stride, outer = inner + fields.stride;
  const Real *ur0 = fields.u_r + inner, *ur1 = fields.u_r + outer, *uz0 = fields.u_z + inner, *uz1 = fields.u_z + outer;
  Real *fr0 = fields.f_r + inner, *fr1 = fields.f_r + outer, *fz0 = fields.f_z + inner, *fz1 = fields.f_z + outer;
  Real *jacobian = fields.jacobian + inner, *viscous = fields.viscous_pressure + inner;
  const Real* alive = fields.alive + inner;
  const int padded_end = (row_end + lanes - 1) / lanes * lanes;
  if (column == 0) {
    clear(fr0, padded_end + 1);
    clear(fz0, padded_end + 1);
  }
  clear(fr1, padded_end + 1);
  clear(fz1, padded_end + 1);

  const double area = shape.width * shape.height, volume = shape.mean_radius * area;
  const Real half_per_width = Real(0.5 / shape.width), half_per_height = Real(0.5 / shape.height);
  const Real quarter_per_radius = Real(0.25 / shape.mean_radius);
  const Real to_r = Real(volume * 0.5 / shape.width), to_z = Real(volume * 0.5 / shape.height),
             to_hoop = Real(0.25 * area);
  const Real hourglass = Real(material.hourglass * material.mu / 12 *
                              (shape.height / shape.width + shape.width / shape.height) * shape.mean_radius);
  const Real mu = Real(material.mu), bulk = Real(material.bulk), alpha = Real(material.alpha);
  const Real two_mu_over_alpha = Real(2 * material.mu / material.alpha), half_bulk = Real(material.bulk / 2);
  const Real per_width2 = Real(1 / (shape.width * shape.width)), per_height2 = Real(1 / (shape.height * shape.height));
  const Real per_hoop2 = Real((shape.at_axis ? axis_hoop_share : 1) / (4 * shape.mean_radius * shape.mean_radius));
  const Real length = Real(__builtin_sqrt(area));
  const Real linear = Real(material.linear_viscosity), quadratic = Real(material.quadratic_viscosity);
  const Real per_step = previous_step > 0 ? Real(1 / previous_step) : Real(0);
  const double largest = 1e30;
  const Real stretch2 =
      Real(material.erosion_stretch < 1e15 ? material.erosion_stretch * material.erosion_stretch : largest);
  const Real smallest_jacobian = Real(material.smallest_jacobian);
  const Real inverse_step_limit =
      Real(material.largest_inverse_step < largest ? material.largest_inverse_step : largest);

  const V zero{};
  V lower_r0 = zero, lower_z0 = zero, lower_r1 = zero,
    lower_z1 = zero;  // what the rows before gave to their lower corners
  V work = zero, steepest = zero, tightest = broadcast<V>(Real(1e30));
  int count = 0;

  for (int j = 0; j < padded_end; j += lanes) {
    auto live = load<V>(alive + j) > Real(0);
    if (!any(live)) {
      fr0[j] += lower_r0[lanes - 1];
      fz0[j] += lower_z0[lanes - 1];
      fr1[j] += lower_r1[lanes - 1];
      fz1[j] += lower_z1[lanes - 1];
      lower_r0 = lower_z0 = lower_r1 = lower_z1 = zero;
      continue;
    }
    // Gather. Sums and differences over the diagonals give gradient and hourglass mode with few operations.
    const V ra = load<V>(ur0 + j), rb = load<V>(ur1 + j), rc = load<V>(ur1 + j + 1), rd = load<V>(ur0 + j + 1);
    const V za = load<V>(uz0 + j), zb = load<V>(uz1 + j), zc = load<V>(uz1 + j + 1), zd = load<V>(uz0 + j + 1);
    const V r_ac = rc - ra, r_bd = rb - rd, z_ac = zc - za, z_bd = zb - zd;
    Gradient<V> F;
    F.rr = (r_ac + r_bd) * half_per_width + Real(1);
    F.rz = (r_ac - r_bd) * half_per_height;
    F.zr = (z_ac + z_bd) * half_per_width;
    F.zz = (z_ac - z_bd) * half_per_height + Real(1);
    F.hoop = larger(((ra + rc) + (rb + rd)) * quarter_per_radius + Real(1), broadcast<V>(Real(1e-3)));
    const V hourglass_r = ((ra - rb) + (rc - rd)) * hourglass, hourglass_z = ((za - zb) + (zc - zd)) * hourglass;

    // Compute.
    const Stretches<V> s = stretches(F);
    const IsochoricPowers<V> g = isochoric_powers(F, s, alpha);
    const PrincipalStress<V> t = isochoric_stress(g, two_mu_over_alpha);
    const V old_jacobian = load<V>(jacobian + j), old_viscous = load<V>(viscous + j);
    const V closing = larger((old_jacobian - s.jacobian) * per_step * s.inverse_jacobian, zero);  // -tr D
    const V current_length = length * square_root(s.in_plane_jacobian);
    const V damping = current_length * (linear + quadratic * current_length * closing);
    V q = damping * closing;
    const V volumetric = half_bulk * (s.jacobian * s.jacobian - Real(1)) - q * s.jacobian;
    const Piola<V> P = first_piola(F, s, t, volumetric);

    const StepBound<V> bound = step_bound(s, g, t, mu, bulk, per_width2, per_height2, per_hoop2);
    const V drag = damping * s.jacobian * bound.over_stretch;
    const V inverse_step = square_root(larger(bound.stiffness, zero) + drag * drag) + drag;

    // Erode.
    const V largest_stretch2 = larger(s.first2, F.hoop * F.hoop);
    auto gone = live & ((largest_stretch2 > stretch2) | (s.unbounded_jacobian < smallest_jacobian) |
                        (inverse_step > inverse_step_limit));
    if (__builtin_expect(any(gone), 0)) {
      for (int l = 0; l < lanes; ++l)
        if (gone[l]) doomed[count++] = j + l;
      live = live & ~gone;
    }
    steepest = larger(steepest, select(live, inverse_step, zero));
    tightest = smaller(tightest, select(live, s.unbounded_jacobian, tightest));
    work += select(load<V>(alive + j) > Real(0),
                   Real(0.5) * (old_viscous + select(live, q, zero)) * (old_jacobian - s.jacobian), zero);
    store(jacobian + j, s.jacobian);
    store(viscous + j, select(live, q, zero));

    // Scatter.
    const V rr = P.rr * to_r, rz = P.rz * to_z, zr = P.zr * to_r, zz = P.zz * to_z, hoop = P.hoop * to_hoop;
    const V sum_r = rr + rz, difference_r = rr - rz, sum_z = zr + zz, difference_z = zr - zz;
    const V upper_r0 = select(live, sum_r - hoop - hourglass_r, zero),
            upper_r1 = select(live, hourglass_r - hoop - difference_r, zero);
    const V below_r1 = select(live, -sum_r - hoop - hourglass_r, zero),
            below_r0 = select(live, difference_r - hoop + hourglass_r, zero);
    const V upper_z0 = select(live, sum_z - hourglass_z, zero),
            upper_z1 = select(live, hourglass_z - difference_z, zero);
    const V below_z1 = select(live, -sum_z - hourglass_z, zero),
            below_z0 = select(live, difference_z + hourglass_z, zero);
    store(fr0 + j, load<V>(fr0 + j) + (upper_r0 + shifted(below_r0, lower_r0)));
    store(fz0 + j, load<V>(fz0 + j) + (upper_z0 + shifted(below_z0, lower_z0)));
    store(fr1 + j, upper_r1 + shifted(below_r1, lower_r1));
    store(fz1 + j, upper_z1 + shifted(below_z1, lower_z1));
    lower_r0 = below_r0;
    lower_z0 = below_z0;
    lower_r1 = below_r1;
    lower_z1 = below_z1;
  }
  fr0[padded_end] += lower_r0[lanes - 1];
  fz0[padded_end] += lower_z0[lanes - 1];
  fr1[padded_end] += lower_r1[lanes - 1];
  fz1[padded_end] += lower_z1[lanes - 1];

  report.viscous_work += volume * lane_sum(work);
  const double inverse_step = static_cast<double>(lane_largest(steepest)),
               least = static_cast<double>(lane_smallest(tightest));
  if (inverse_step > report.largest_inverse_step) report.largest_inverse_step = inverse_step;
  if (least < report.smallest_jacobian) report.smallest_jacobian = least;
  report.doomed = count;
}

// Frictionless penalty: a node inside the sphere by `gap` is pushed out along the radius with force stiffness gap.
template <class Real>
void sphere_contact(const FieldsView<Real>& fields, int column, double radius, double row_height, int row_begin,
                    int row_end, double centre, SphereReport& report) {
  using V = typename VectorOf<Real>::type;
  constexpr int lanes = Lane<V>::count;
  const long start = static_cast<long>(column) * fields.stride;
  const Real *ur = fields.u_r + start, *uz = fields.u_z + start, *stiffness = fields.contact_stiffness + start;
  Real *fr = fields.f_r + start, *fz = fields.f_z + start;
  V below_first;
  for (int l = 0; l < lanes; ++l) below_first[l] = static_cast<Real>(l * row_height);
  const V zero{};
  for (int j = row_begin / lanes * lanes; j < row_end; j += lanes) {
    const V k = load<V>(stiffness + j);
    if (!any(k > Real(0))) continue;
    const V r = load<V>(ur + j) + static_cast<Real>(radius);
    const V z =
        load<V>(uz + j) + (below_first + static_cast<Real>(j * row_height - centre));  // from the centre downwards
    const V distance2 = r * r + z * z;
    const auto touching = (distance2 < Real(1)) & (k > Real(0));
    if (!any(touching)) continue;
    const V distance = square_root(distance2 + Real(1e-20));
    const V gap = select(touching, Real(1) - distance, zero);
    const V push = k * gap / distance;
    const V push_z = push * z;
    store(fr + j, load<V>(fr + j) + push * r);
    store(fz + j, load<V>(fz + j) + push_z);
    report.force += lane_sum(push_z);
    report.spring_energy += 0.5 * lane_sum(k * gap * gap);
    const double deepest = static_cast<double>(lane_largest(gap));
    if (deepest > report.largest_gap) report.largest_gap = deepest;
  }
}

template <class Real>
void kick_and_drift(const FieldsView<Real>& fields, int column, int row_end, double kick, double drift) {
  using V = typename VectorOf<Real>::type;
  constexpr int lanes = Lane<V>::count;
  const long start = static_cast<long>(column) * fields.stride;
  Real *ur = fields.u_r + start, *uz = fields.u_z + start, *vr = fields.v_r + start, *vz = fields.v_z + start;
  const Real *fr = fields.f_r + start, *fz = fields.f_z + start, *inverse_mass = fields.inverse_mass + start;
  const Real kick_r = column == 0 ? Real(0) : Real(kick), kick_z = Real(kick), dt = Real(drift);
  for (int j = 0; j <= row_end; j += lanes) {
    const V per_mass = load<V>(inverse_mass + j);
    const V r = load<V>(vr + j) + (load<V>(fr + j) * per_mass) * kick_r;
    const V z = load<V>(vz + j) + (load<V>(fz + j) * per_mass) * kick_z;
    store(vr + j, r);
    store(vz + j, z);
    store(ur + j, load<V>(ur + j) + r * dt);
    store(uz + j, load<V>(uz + j) + z * dt);
  }
}

}  // namespace

extern const Kernel<float> single_kernel;
extern const Kernel<double> double_kernel;
const Kernel<float> single_kernel{internal_forces<float>, sphere_contact<float>, kick_and_drift<float>,
                                  FloatLanes::count};
const Kernel<double> double_kernel{internal_forces<double>, sphere_contact<double>, kick_and_drift<double>,
                                   DoubleLanes::count};

}  // namespace percal::PERCAL_LEVEL
