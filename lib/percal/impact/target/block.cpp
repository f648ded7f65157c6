#include "percal/impact/target/block.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>

#include "percal/impact/target/constants.hpp"

namespace percal {
namespace {

// Layers take whole rows; the last one takes what is left.
std::vector<LayerRows> layers_of(const Problem& problem, const GradedMesh& mesh) {
  std::vector<LayerRows> layers;
  double bottom = problem.depth;
  int begin = 0;
  const auto end_at = [&](double depth) {
    return std::clamp(static_cast<int>(std::lround(depth / mesh.row_height)), begin, mesh.rows);
  };
  layers.push_back({begin, problem.below.empty() ? mesh.rows : end_at(bottom), 1});
  for (const LowerLayer& layer : problem.below) {
    begin = layers.back().end;
    bottom += layer.depth;
    layers.push_back(
        {begin, &layer == &problem.below.back() ? mesh.rows : end_at(bottom), layer.density});
  }
  return layers;
}

int relaxing_terms_of(const Problem& problem) {
  const auto* series = std::get_if<PronySeries>(&problem.relaxation);
  return series ? std::min(static_cast<int>(series->terms.size()), most_relaxing_terms) : 0;
}

}  // namespace

int fields_per_element(const Problem& problem) {
  const int terms = relaxing_terms_of(problem);
  const bool averaged = erosion_kind_of(problem) == ErosionKind::averaged_energy;
  return 12 + (averaged ? 1 : 0) + (rates_of(problem) == 2 ? 2 : 0) +
         (problem.hourglass_form == HourglassForm::viscosity ? 2 : 0) + (terms > 0 ? 4 * (terms + 2) : 0);
}

template <class Real>
void Block<Real>::Free::operator()(void* memory) const {
  std::free(memory);
}

template <class Real>
Block<Real>::Block(const Problem& problem, const GradedMesh& mesh, int lanes)
    : mesh_(mesh), layers_(layers_of(problem, mesh)) {
  const bool plane = problem.geometry == Geometry::plane_strain;
  for (int i = 0; i < mesh.columns(); ++i) {
    const double width = mesh.radius[i + 1] - mesh.radius[i], middle = (mesh.radius[i + 1] + mesh.radius[i]) / 2;
    shapes_.push_back({.width = width,
                       .height = mesh.row_height,
                       .thickness = plane ? 1 : middle,
                       .per_radius = plane ? 0 : 1 / middle,
                       .at_axis = !plane && i == 0});
  }
  allocate(lanes, problem);
  fill(problem);
}

template <class Real>
void Block<Real>::allocate(int lanes, const Problem& problem) {
  // Room for one group of lanes beyond the last node, and a stride that is no multiple of a page, where columns would
  // fight for the same cache lines.
  constexpr int line = 64 / static_cast<int>(sizeof(Real));
  int stride = (mesh_.rows + 2 * lanes + 1 + line - 1) / line * line;
  if (stride * sizeof(Real) % 4096 == 0) stride += line;
  entries_ = static_cast<std::size_t>(mesh_.columns() + 1) * stride + 2 * line;
  const std::size_t bytes = (entries_ + line) / line * line * sizeof(Real);
  const bool with_near_forces = rates_of(problem) == 2;
  const bool averaged = erosion_kind_of(problem) == ErosionKind::averaged_energy;
  const bool viscous_hourglass = problem.hourglass_form == HourglassForm::viscosity;
  const int terms = relaxing_terms_of(problem);
  const int fields = fields_per_element(problem);
  bytes_ = bytes * fields + entries_;
  memory_.reset(std::aligned_alloc(64, bytes * fields));
  if (!memory_) throw std::bad_alloc();
  std::memset(memory_.get(), 0, bytes * fields);
  int next = 0;
  const auto field = [&] { return reinterpret_cast<Real*>(static_cast<char*>(memory_.get()) + bytes * next++); };
  view_ = {.u_r = field(),
           .u_z = field(),
           .v_r = field(),
           .v_z = field(),
           .inverse_mass = field(),
           .touchable = field(),
           .jacobian = field(),
           .viscous_pressure = field(),
           .erosion_measure = field(),
           .foreseen_measure = averaged ? field() : nullptr,
           .alive = field(),
           .stride = stride};
  look_ = {view_.u_r,
           view_.u_z,
           view_.v_r,
           view_.v_z,
           view_.inverse_mass,
           view_.touchable,
           view_.jacobian,
           view_.viscous_pressure,
           view_.erosion_measure,
           view_.foreseen_measure,
           view_.alive,
           stride};
  far_ = {field(), field()};
  near_ = with_near_forces ? NodeForces<Real>{field(), field()} : far_;
  if (viscous_hourglass) hourglass_velocity_ = {field(), field()};
  if (terms > 0) {
    const auto tensor = [&] { return TensorField<Real>{field(), field(), field(), field()}; };
    for (int k = 0; k < terms; ++k) relaxation_.overstress[k] = tensor();
    relaxation_.isochoric = tensor();
    relaxation_.strain = tensor();
    relaxation_.groups_per_column = stride / lanes + 1;
    looked_at_.assign(static_cast<std::size_t>(mesh_.columns()) * relaxation_.groups_per_column, 0);
    relaxation_.looked_at = looked_at_.data();
    relaxation_.terms = terms;
    bytes_ += looked_at_.size() * sizeof(double);
  }
  live_elements_.assign(entries_, 0);
}

template <class Real>
void Block<Real>::fill(const Problem& problem) {
  const int columns = mesh_.columns(), rows = mesh_.rows;
  std::fill_n(view_.jacobian, entries_, Real(1));
  std::fill_n(view_.erosion_measure, entries_, Real(erosion_kind_of(problem) == ErosionKind::stretch ? 1 : 0));
  column_mass_.assign(columns + 1, 0);
  row_density_.assign(view_.stride, 0);
  for (const LayerRows& layer : layers_)
    for (int j = layer.begin; j < layer.end; ++j)
      for (int q = j; q <= j + 1; ++q) row_density_[q] += 0.5 * layer.density;
  for (int i = 0; i < columns; ++i) {
    const double corner_mass = shapes_[i].thickness * shapes_[i].width * mesh_.row_height / 4;
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
      const bool at_wall = i == columns || (problem.whole && i == 0);
      const bool is_free = !at_wall && j <= last_moving_row;
      view_.inverse_mass[at(i, j)] = is_free ? static_cast<Real>(1 / m) : Real(0);
      view_.touchable[at(i, j)] = is_free ? Real(1) : Real(0);
    }
}

template <class Real>
std::vector<Real> Block<Real>::motion() const {
  std::vector<Real> motion;
  motion.reserve(4 * entries_);
  for (const Real* field : {view_.u_r, view_.u_z, view_.v_r, view_.v_z})
    motion.insert(motion.end(), field, field + entries_);
  return motion;
}

template <class Real>
void Block<Real>::put_back(const std::vector<Real>& motion) {
  auto from = motion.begin();
  for (Real* field : {view_.u_r, view_.u_z, view_.v_r, view_.v_z}) {
    std::copy_n(from, entries_, field);
    from += static_cast<std::ptrdiff_t>(entries_);
  }
}

template class Block<float>;
template class Block<double>;

}  // namespace percal
