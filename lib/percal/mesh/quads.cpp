#include "percal/mesh/quads.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>

namespace percal {
namespace {

constexpr double core_share = 0.6;   // of the elements on a radius of a disc that its core takes
constexpr double core_width = 0.55;  // half width of the core, of the radius
constexpr double core_bulge = 0.45;  // 0: the core is a square, 1: a circle

// The point of the unit circle that belongs to point (i, j) of the core, its angle in proportion along each side.
Point on_circle(int i, int j) {
  const int reach = std::max(std::abs(i), std::abs(j));
  if (reach == 0) return {0, 0};
  const double quarter = std::numbers::pi / 4;
  if (std::abs(i) == reach) {
    const double angle = quarter * j / reach;
    return {std::copysign(std::cos(angle), i), std::sin(angle)};
  }
  const double angle = quarter * i / reach;
  return {std::sin(angle), std::copysign(std::cos(angle), j)};
}

// Point (i, j) of the core, |i| and |j| up to `core`: between a square and a circle.
Point in_core(int core, int i, int j) {
  const Point circle = on_circle(i, j);
  const double reach = std::max(std::abs(i), std::abs(j));
  return {core_width / core * ((1 - core_bulge) * i + core_bulge * reach * circle[0]),
          core_width / core * ((1 - core_bulge) * j + core_bulge * reach * circle[1])};
}

// The core is a square of quads, rounded; around its boundary lie rings, each nearer to the circle.
class DiscMaker {
 public:
  DiscMaker(int elements_per_radius, bool half) : half_(half) {
    assert(elements_per_radius >= 2);
    core_ = std::clamp(static_cast<int>(std::lround(core_share * elements_per_radius)), 1, elements_per_radius - 1);
    rings_ = elements_per_radius - core_;
  }

  Disc make() {
    const int m = core_;
    for (int j = -m; j < m; ++j)
      for (int i = half_ ? 0 : -m; i < m; ++i)
        add({core_node(i, j), core_node(i + 1, j), core_node(i + 1, j + 1), core_node(i, j + 1)});
    const auto around = core_boundary();
    const std::size_t gaps = around.size() - (half_ ? 1 : 0);
    for (int ring = 0; ring < rings_; ++ring)
      for (std::size_t k = 0; k < gaps; ++k) {
        const auto& here = around[k];
        const auto& next = around[(k + 1) % around.size()];
        add({ring_node(here, ring), ring_node(here, ring + 1), ring_node(next, ring + 1), ring_node(next, ring)});
      }
    for (const auto& on_core : around) disc_.boundary.push_back(ring_node(on_core, rings_));
    return disc_;
  }

 private:
  using CoreNode = std::array<int, 2>;  // i, j of in_core

  // Counter-clockwise; the half starts at the bottom of the axis, the whole at the lower left corner.
  std::vector<CoreNode> core_boundary() const {
    const int m = core_;
    std::vector<CoreNode> around;
    for (int i = half_ ? 0 : -m; i < m; ++i) around.push_back({i, -m});
    for (int j = -m; j < m; ++j) around.push_back({m, j});
    for (int i = m; i > (half_ ? 0 : -m); --i) around.push_back({i, m});
    if (half_)
      around.push_back({0, m});
    else
      for (int j = m; j > -m; --j) around.push_back({-m, j});
    return around;
  }

  int core_node(int i, int j) { return node({i, j, 0}, in_core(core_, i, j)); }

  int ring_node(const CoreNode& on_core, int ring) {
    const Point inside = in_core(core_, on_core[0], on_core[1]), circle = on_circle(on_core[0], on_core[1]);
    const double share = static_cast<double>(ring) / rings_;
    return node({on_core[0], on_core[1], ring},
                {(1 - share) * inside[0] + share * circle[0], (1 - share) * inside[1] + share * circle[1]});
  }

  int node(const std::array<int, 3>& key, const Point& at) {
    const auto [entry, fresh] = numbers_.try_emplace(key, static_cast<int>(disc_.mesh.nodes.size()));
    if (fresh) disc_.mesh.nodes.push_back(at);
    return entry->second;
  }

  void add(const std::array<int, 4>& corners) { disc_.mesh.elements.push_back(corners); }

  bool half_;
  int core_ = 0, rings_ = 0;  // elements on a radius within the core and around it
  Disc disc_;
  std::map<std::array<int, 3>, int> numbers_;
};

}  // namespace

Disc half_disc(int elements_per_radius) { return DiscMaker(elements_per_radius, true).make(); }
Disc disc(int elements_per_radius) { return DiscMaker(elements_per_radius, false).make(); }

double worst_corner(const QuadMesh& mesh) {
  double worst = 1;
  for (const auto& element : mesh.elements)
    for (int a = 0; a < 4; ++a) {
      const Point &before = mesh.nodes[element[(a + 3) % 4]], &here = mesh.nodes[element[a]],
                  &after = mesh.nodes[element[(a + 1) % 4]];
      const double ax = after[0] - here[0], ay = after[1] - here[1], bx = before[0] - here[0], by = before[1] - here[1];
      worst = std::min(worst, (ax * by - ay * bx) / (std::hypot(ax, ay) * std::hypot(bx, by)));
    }
  return worst;
}

}  // namespace percal
