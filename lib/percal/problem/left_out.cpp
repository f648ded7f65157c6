#include <fmt/core.h>

#include <algorithm>

#include "percal/problem/particle.hpp"

namespace percal {
namespace {

std::string why_the_particle_is_rigid(const Scene& scene) {
  const auto ratio = stress_over_particle_stiffness(scene);
  if (!ratio) return "the scene gives no Young's modulus: the particle is rigid";
  const auto figure = fmt::format("(rho_t v^2 + 10 mu)/E = {:.2g}", *ratio);
  if (scene.particle.elasticity == Elasticity::rigid) return "the scene wants a rigid particle; " + figure;
  if (*ratio < rigid_below) return figure + fmt::format(" is below {}: rigid", rigid_below);
  return figure + "; only a sphere in an axisymmetric scene can be elastic";
}

// What the planes of symmetry of a block spare.
LeftOut part_of_a_block(const Problem& problem) {
  if (problem.whole)
    return {"second half", "the scene is its own mirror image in the plane of flight: one side is computed"};
  if (problem.block.whole_across)
    return {"second half", "the scene is its own mirror image in the plane across x: one side is computed"};
  return {"three quarters", "the scene is its own mirror image in two planes: one quarter is computed"};
}

struct WhyItDoesNotTurn {
  std::string operator()(const RigidSphere&) const {
    return "contact does not turn a round particle that goes straight down";
  }
  std::string operator()(const ElasticSphere&) const { return (*this)(RigidSphere{}); }
  std::string operator()(const RigidPolygon& profile) const {
    return profile.free_rotation ? "" : "the scene holds the particle as it stands";
  }
  std::string operator()(const RigidPolyhedron& body) const {
    return body.free_rotation ? "" : "the scene holds the particle as it stands";
  }
};

}  // namespace

std::vector<LeftOut> list_what_is_left_out(const Scene& scene, const Problem& problem) {
  std::vector<LeftOut> list;
  if (!std::holds_alternative<ElasticSphere>(problem.particle))
    list.push_back({"elastic particle", why_the_particle_is_rigid(scene)});
  if (const std::string why = std::visit(WhyItDoesNotTurn{}, problem.particle); !why.empty())
    list.push_back({"rotation", why});
  if (friction_coefficient(problem) == 0) list.push_back({"friction", "the scene gives none"});
  if (problem.geometry == Geometry::plane_strain && !problem.whole)
    list.push_back({"second half", "the scene is its own mirror image: one side is computed"});
  if (problem.geometry == Geometry::block && computed_share(problem) < 1) list.push_back(part_of_a_block(problem));
  if (std::holds_alternative<NoErosion>(problem.erosion)) list.push_back({"erosion", "the scene gives no limit"});
  if (problem.history_samples == 0) list.push_back({"history", "nobody asked for it"});
  if (!problem.channel) list.push_back({"radius of the channel", "nobody asked for it"});
  if (problem.until != RunUntil::rest)
    list.push_back({"what follows the deepest point", "the scene wants the deepest point"});
  if (std::holds_alternative<NoRelaxation>(problem.relaxation))
    list.push_back({"rate dependence", "the scene gives none"});
  const auto is_stretched = [](const auto& layer) { return layer.stretch != 1 || layer.stretch_across; };
  const auto has_fibres = [](const auto& layer) { return !std::holds_alternative<NoFibres>(layer.fibres); };
  if (!is_stretched(problem) && std::ranges::none_of(problem.below, is_stretched))
    list.push_back({"initial stretch", "the scene gives none"});
  if (!has_fibres(problem) && std::ranges::none_of(problem.below, has_fibres))
    list.push_back({"fibres", "the scene gives none"});
  if (problem.below.empty()) list.push_back({"further layers", "the scene has one"});
  list.push_back({"rows at rest", "rows that the wave has not reached are not advanced"});
  list.push_back({"contact away from the particle", "only nodes within reach of the particle are searched"});
  if (problem.arithmetic == Arithmetic::single_precision)
    list.push_back({"double precision", "its depths differ by less than the scatter of replicates"});
  return list;
}

}  // namespace percal
