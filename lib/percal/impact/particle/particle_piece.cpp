// What an observer sees of each particle. Rigid ones are drawn in their first position and moved.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "percal/impact/particle/elastic_sphere.hpp"
#include "percal/impact/settings.hpp"
#include "percal/impact/target/contents.hpp"

namespace percal {
namespace {

void add_cells(FramePiece& piece, const QuadMesh& mesh) {
  for (const auto& corners : mesh.elements) {
    piece.corners.insert(piece.corners.end(), corners.begin(), corners.end());
    piece.ends.push_back(static_cast<int>(piece.corners.size()));
  }
}

}  // namespace

std::vector<Point> right_half(const std::vector<Point>& polygon) {
  std::vector<Point> half;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
    if (from[0] >= 0) half.push_back(from);
    if (from[0] * to[0] < 0) half.push_back({0, from[1] + (to[1] - from[1]) * from[0] / (from[0] - to[0])});
  }
  const auto lowest_on_axis = std::min_element(half.begin(), half.end(), [](const Point& a, const Point& b) {
    return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1];
  });
  std::rotate(half.begin(), lowest_on_axis, half.end());
  return half;
}

ParticlePiece SphereRun::piece(const Problem& problem) const {
  const int elements = elements_on_particle_radius(problem);
  const Disc round = whole_ ? disc(elements) : half_disc(elements);
  ParticlePiece piece;
  for (const Point& node : round.mesh.nodes) piece.position.push_back({node[0], node[1] - centre()});
  piece.displacement.assign(piece.position.size(), {0, -tip_});
  piece.velocity.assign(piece.position.size(), {0, -speed_});
  add_cells(piece, round.mesh);
  piece.outline = round.boundary;
  return piece;
}

ParticlePiece moved_piece(const std::vector<Point>& outline, double lowest, const BodyPlace& place,
                          const std::function<PointVelocity(double x, double z)>& velocity_at) {
  const double cosine = std::cos(place.angle), sine = std::sin(place.angle);
  ParticlePiece piece;
  for (const auto& [x, y] : outline) {
    const Point now{place.x + cosine * x - sine * y, -place.z + sine * x + cosine * y};
    const PointVelocity velocity = velocity_at(now[0], -now[1]);
    piece.position.push_back(now);
    piece.displacement.push_back({now[0] - x, now[1] - (y - lowest)});
    piece.velocity.push_back({velocity.x, -velocity.z});
  }
  piece.outline.resize(outline.size());
  std::iota(piece.outline.begin(), piece.outline.end(), 0);
  piece.corners = piece.outline;
  piece.ends = {static_cast<int>(outline.size())};
  return piece;
}

ParticlePiece PolygonRun::piece(const Problem&) const {
  double lowest = 0;
  for (const Point& vertex : profile_.vertices) lowest = std::min(lowest, vertex[1]);
  return moved_piece(whole_ ? profile_.vertices : right_half(profile_.vertices), lowest,
                     {here_.x, here_.z, here_.angle}, [this](double x, double z) { return velocity_at(x, z); });
}

ParticlePiece ElasticSphereRun::piece(const Problem&) const {
  ParticlePiece piece;
  for (int n = 0; n < body_.nodes(); ++n) {
    piece.position.push_back(body_.position(n));
    piece.displacement.push_back(body_.displacement(n));
    piece.velocity.push_back(body_.velocity(n));
  }
  add_cells(piece, body_.mesh());
  for (int e = 0; e < body_.elements(); ++e)
    piece.states.push_back(cell_state(body_.gradient(e), body_.first_piola(e), body_.energy_density(e)));
  piece.outline = boundary_;
  return piece;
}

}  // namespace percal
