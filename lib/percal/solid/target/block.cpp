#include "percal/solid/target/block.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

#include "percal/impact/target/size.hpp"
#include "percal/problem/domain.hpp"
#include "percal/solid/target/solid_of.hpp"

namespace percal {
namespace {

// Half the widths beside each plane of nodes: the lumped mass of a node is the product of three. density_of: of the cell behind plane i.
template <class Density>
std::vector<double> shares_of(const std::vector<double>& planes, const Density& density_of) {
  std::vector<double> shares(planes.size(), 0);
  for (std::size_t i = 0; i + 1 < planes.size(); ++i)
    for (const std::size_t side : {i, i + 1}) shares[side] += 0.5 * density_of(i) * (planes[i + 1] - planes[i]);
  return shares;
}
double of_one(std::size_t) { return 1; }

}  // namespace

template <class Real>
void SolidBlock<Real>::Free::operator()(void* memory) const {
  std::free(memory);
}

template <class Real>
SolidBlock<Real>::SolidBlock(const Problem& problem, int lanes)
    : grid_(box_grid(box_options(problem))),
      layers_(layers_of_block(problem, grid_.z)),
      share_x_(shares_of(grid_.x, of_one)),
      share_y_(shares_of(grid_.y, of_one)),
      share_z_(shares_of(grid_.z, [this](std::size_t row) {
        const auto own = [row](const LayerRows& layer) { return static_cast<int>(row) < layer.end; };
        return std::ranges::find_if(layers_, own)->density;
      })) {
  allocate(lanes);
  fill(problem);
}

// Columns end with room for one group of lanes beyond the last node, and their stride is no multiple of a page.
template <class Real>
void SolidBlock<Real>::allocate(int lanes) {
  constexpr int line = 64 / static_cast<int>(sizeof(Real));
  const int whole_groups = (grid_.rows() + 1 + lanes - 1) / lanes * lanes + lanes;
  int stride = (whole_groups + line - 1) / line * line;
  if (stride * sizeof(Real) % 4096 == 0) stride += line;
  entries_ = static_cast<std::size_t>(grid_.columns_x() + 1) * (grid_.columns_y() + 1) * stride;
  const std::size_t numbers = (entries_ + 2 * line) * fields_per_brick + 4 * (stride + line),
                    bytes = numbers * sizeof(Real);
  memory_.reset(std::aligned_alloc(64, (bytes + 63) / 64 * 64));
  if (!memory_) throw std::bad_alloc();
  std::memset(memory_.get(), 0, bytes);
  auto* next = static_cast<Real*>(memory_.get());
  const auto take = [&next](std::size_t count) { return std::exchange(next, next + count); };
  const auto field = [&] { return take(entries_ + 2 * line); };
  for (auto* vector : {&fields_.u, &fields_.v, &fields_.f})
    for (Real*& component : *vector) component = field();
  for (Real** scalar :
       {&fields_.inverse_mass, &fields_.jacobian, &fields_.viscous_pressure, &fields_.erosion_measure, &fields_.alive})
    *scalar = field();
  fields_.stride = stride;
  look_ = {{fields_.u[0], fields_.u[1], fields_.u[2]},
           {fields_.v[0], fields_.v[1], fields_.v[2]},
           {fields_.f[0], fields_.f[1], fields_.f[2]},
           fields_.inverse_mass,
           fields_.jacobian,
           fields_.viscous_pressure,
           fields_.erosion_measure,
           fields_.alive,
           stride};
  const auto of_row = [&] { return take(stride + line); };
  Real *height = of_row(), *per_height = of_row(), *root3 = of_row();
  below_ = of_row();
  for (int k = 0; k < stride; ++k) {
    const double h = k < grid_.rows() ? grid_.z[k + 1] - grid_.z[k] : 1;
    height[k] = static_cast<Real>(h);
    per_height[k] = static_cast<Real>(1 / h);
    root3[k] = static_cast<Real>(std::cbrt(h));
    below_[k] = k <= grid_.rows() ? static_cast<Real>(grid_.z[k] - grid_.z[k / lanes * lanes]) : Real(0);
  }
  heights_ = {height, per_height, root3};
}

template <class Real>
void SolidBlock<Real>::fill(const Problem& problem) {
  std::fill_n(fields_.jacobian, entries_, Real(1));
  live_elements_.assign(entries_, 0);
  const int end_x = grid_.columns_x(), end_y = grid_.columns_y(), end_z = grid_.rows();
  for (int i = 0; i < end_x; ++i)
    for (int j = 0; j < end_y; ++j)
      for (int k = 0; k < end_z; ++k) {
        fields_.alive[at(i, j, k)] = 1;
        for (const long first : nodes_of(i, j))
          for (const int row : {k, k + 1}) ++live_elements_[first + row];
      }
  const int last_moving_row = problem.bottom == Bottom::fixed ? end_z - 1 : end_z;
  for (int i = 0; i <= end_x; ++i)
    for (int j = 0; j <= end_y; ++j) {
      const bool at_wall =
          i == end_x || j == end_y || (problem.whole && i == 0) || (problem.block.whole_across && j == 0);
      for (int k = 0; k <= last_moving_row && !at_wall; ++k)
        fields_.inverse_mass[at(i, j, k)] = static_cast<Real>(1 / mass(i, j, k));
    }
}

template <class Real>
std::vector<Real> SolidBlock<Real>::motion() const {
  std::vector<Real> motion;
  motion.reserve(6 * entries_);
  for (const auto* vector : {&fields_.u, &fields_.v})
    for (const Real* component : *vector) motion.insert(motion.end(), component, component + entries_);
  return motion;
}

template <class Real>
void SolidBlock<Real>::put_back(const std::vector<Real>& motion) {
  auto from = motion.begin();
  for (auto* vector : {&fields_.u, &fields_.v})
    for (Real* component : *vector) {
      std::copy_n(from, entries_, component);
      from += static_cast<std::ptrdiff_t>(entries_);
    }
}

template <class Real>
void SolidBlock<Real>::take_out(int i, int j, int k) {
  fields_.alive[at(i, j, k)] = 0;
  for (const long first : nodes_of(i, j))
    for (const int row : {k, k + 1}) --live_elements_[first + row];
}

template class SolidBlock<float>;
template class SolidBlock<double>;

}  // namespace percal
