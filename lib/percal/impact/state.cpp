#include "percal/impact/state.hpp"

#include <cstdlib>
#include <cstring>
#include <new>

namespace percal {

template <class Real>
void Block<Real>::Free::operator()(void* memory) const {
  std::free(memory);
}

template <class Real>
Block<Real>::Block(const Problem& problem, const GradedMesh& mesh, double contact_stiffness_per_mass, int lanes)
    : mesh_(mesh) {
  const int columns = mesh.columns(), rows = mesh.rows;
  // Room for one group of lanes beyond the last node, and a stride that is no multiple of a page, where columns would fight
  // for the same cache lines.
  constexpr int line = 64 / static_cast<int>(sizeof(Real));
  int stride = (rows + 2 * lanes + 1 + line - 1) / line * line;
  if (stride * sizeof(Real) % 4096 == 0) stride += line;
  const std::size_t entries = static_cast<std::size_t>(columns + 1) * stride + 2 * line;
  constexpr int fields = 11;
  const std::size_t bytes = (entries + line) / line * line * sizeof(Real);
  memory_.reset(std::aligned_alloc(64, bytes * fields));
  if (!memory_) throw std::bad_alloc();
  std::memset(memory_.get(), 0, bytes * fields);
  int next = 0;
  const auto field = [&] { return reinterpret_cast<Real*>(static_cast<char*>(memory_.get()) + bytes * next++); };
  view_ = {.u_r = field(),
           .u_z = field(),
           .v_r = field(),
           .v_z = field(),
           .f_r = field(),
           .f_z = field(),
           .inverse_mass = field(),
           .contact_stiffness = field(),
           .jacobian = field(),
           .viscous_pressure = field(),
           .alive = field(),
           .stride = stride};
  for (std::size_t n = 0; n < entries; ++n) view_.jacobian[n] = 1;

  column_mass_.assign(columns + 1, 0);
  live_elements_.assign(entries, 0);
  for (int i = 0; i < columns; ++i) {
    const double width = mesh.radius[i + 1] - mesh.radius[i], middle = (mesh.radius[i + 1] + mesh.radius[i]) / 2;
    shapes_.push_back({.width = width, .height = mesh.row_height, .mean_radius = middle, .at_axis = i == 0});
    const double corner_mass = middle * width * mesh.row_height / 4;
    column_mass_[i] += 2 * corner_mass;
    column_mass_[i + 1] += 2 * corner_mass;
    for (int j = 0; j < rows; ++j) {
      view_.alive[at(i, j)] = 1;
      for (int p = i; p <= i + 1; ++p)
        for (int q = j; q <= j + 1; ++q) ++live_elements_[at(p, q)];
    }
  }
  const int last_moving_row = problem.bottom == Bottom::fixed ? rows - 1 : rows;
  for (int i = 0; i <= columns; ++i)
    for (int j = 0; j <= rows; ++j) {
      const double m = mass(i, j);
      const bool at_wall = i == columns;
      view_.inverse_mass[at(i, j)] = at_wall || j > last_moving_row ? Real(0) : static_cast<Real>(1 / m);
      view_.contact_stiffness[at(i, j)] = static_cast<Real>(contact_stiffness_per_mass * m);
    }
}

template class Block<float>;
template class Block<double>;

}  // namespace percal
