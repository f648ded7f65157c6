#include "percal/campaign/strain_at_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/impact/target/size.hpp"
#include "percal/math/distributions.hpp"
#include "percal/math/statistics.hpp"
#include "percal/problem/domain.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/scene/erosion_size.hpp"
#include "percal/units/quantity.hpp"

namespace percal {
namespace {

constexpr int trials_wanted = 5, fewest_replicates = 5;
constexpr int own_walks = 2;  // replicates on the own mesh over those of a trial: all trials lean on that one depth
constexpr double least_step = 0.1, most_step = 0.5;  // of ln strain between the first two trials
constexpr double spread = 0.1;                       // of ln strain about the root: the line wants a base
constexpr double farthest = 0.15;                    // of ln strain beyond the trials: no further by the line
constexpr double level = 0.95;

int replicates_for(const Scene& scene) { return std::max(scene.replicates, fewest_replicates); }

Scene with(const Scene& scene, double elements_per_radius, double strain) {
  Scene other = on_mesh(scene, elements_per_radius);
  other.output = {};
  other.target.erosion = StrainErosion{strain, std::get<StrainErosion>(scene.target.erosion).measure};
  other.target.erosion_by_size = AnySize{};
  return other;
}

double own_strain(const Scene& scene) { return std::get<StrainErosion>(erosion_in_force(scene)).limit; }

// ln depth over ln strain.
struct Trials {
  std::vector<double> strains, depths;
  double wanted;  // ln depth
  Line line() const { return linear_trend(strains, depths); }
  double root() const {
    const Line fit = line();
    return (wanted - fit.intercept) / fit.slope;
  }
  // The next strain to try. Depth falls about as the inverse of the strain, until two trials say better.
  double next() const {
    if (strains.empty()) return NAN;
    if (strains.size() == 1) {
      const double step = std::clamp(depths[0] - wanted, -most_step, most_step);
      return strains[0] + (std::abs(step) < least_step ? std::copysign(least_step, step) : step);
    }
    if (!(line().slope < 0)) return strains[0] + (strains.size() % 2 == 0 ? -2 : 2) * least_step;
    const double low = std::ranges::min(strains) - most_step, high = std::ranges::max(strains) + most_step;
    return std::clamp(root() + (strains.size() % 2 == 0 ? -spread : spread), low, high);
  }
};

// Half width of ln strain: Student's t for the line, and for the mean on the scene's own mesh.
double half_width_of(const Trials& trials, const Penetration& own) {
  const Line line = trials.line();
  const auto t = [](double degrees_of_freedom) { return student_quantile(0.5 + level / 2, degrees_of_freedom); };
  const double by_line = t(line.points - 2) * line.error_at(trials.root()).value();
  const double by_own = t(static_cast<double>(own.depths.size()) - 1) * *own.standard_error / *own.depth;
  return std::hypot(by_line, by_own) / std::abs(line.slope);
}

std::string fault_of(const Trials& trials) {
  if (!(trials.line().slope < 0)) return "the depth does not fall with the erosion strain within its scatter";
  const double root = trials.root();
  if (root < std::ranges::min(trials.strains) - farthest || root > std::ranges::max(trials.strains) + farthest)
    return fmt::format("no strain from {:.3g} to {:.3g} gives this depth", std::exp(std::ranges::min(trials.strains)),
                       std::exp(std::ranges::max(trials.strains)));
  return "";
}

}  // namespace

void need_element_size(const Scene& scene, double element, const Place& place) {
  if (!std::holds_alternative<StrainErosion>(scene.target.erosion))
    throw BadInput(place, "a shot that does not erode by strain", "a shot with target.erosion.strain");
  const double radius = scene.particle.radius;
  constexpr double rounding = 1e-9;
  if (!(element >= smallest_element * radius * (1 - rounding) && element <= largest_element * radius * (1 + rounding)))
    throw BadInput(place, format_quantity(element, dimension::length),
                   fmt::format("1/{:.0f} to 1/{:.0f} of the particle's radius: {} to {}", 1 / smallest_element,
                               1 / largest_element, format_quantity(smallest_element * radius, dimension::length),
                               format_quantity(largest_element * radius, dimension::length)));
  const Scene other = with(scene, radius / element, own_strain(scene));
  need_elements_in_erosion_length(other, place);
  refuse_what_is_too_large(reduce(other).problem, place.file);
}

long strain_runs(const Scene& scene) { return (trials_wanted + static_cast<long>(own_walks)) * replicates_for(scene); }

StrainAtSize strain_at_size(const Scene& scene, double element, Campaign& campaign, Progress* progress) {
  const double strain = own_strain(scene), radius = scene.particle.radius;
  StrainAtSize found{.own_strain = strain,
                     .element = element,
                     .own_element = radius / scene.mesh.elements_per_radius,
                     .radius = radius};
  const auto shoot = [&](double elements_per_radius, double at, int walks) {
    const Reduction reduction = reduce(with(scene, elements_per_radius, at));
    return summarise(campaign.replicate({reduction.problem}, walks * replicates_for(scene), progress).front(),
                     reduction.problem, reduction.scales);
  };
  found.own = shoot(scene.mesh.elements_per_radius, strain, own_walks);
  if (!found.own.depth) {
    found.why_not = "on its own mesh the shot ends as: " + word(found.own.outcome);
    return found;
  }
  Trials trials{.strains = {}, .depths = {}, .wanted = std::log(*found.own.depth)};
  while (static_cast<int>(found.trials.size()) < trials_wanted) {
    const double at = found.trials.empty() ? strain : std::exp(trials.next());
    found.trials.push_back({at, shoot(radius / element, at, 1)});
    if (!found.trials.back().penetration.depth) {
      found.why_not = fmt::format("with erosion strain {:.3g} the shot ends as: {}", at,
                                  word(found.trials.back().penetration.outcome));
      return found;
    }
    trials.strains.push_back(std::log(at));
    trials.depths.push_back(std::log(*found.trials.back().penetration.depth));
  }
  found.why_not = fault_of(trials);
  if (!found.why_not.empty()) return found;
  found.strain = std::exp(trials.root());
  found.half_width = found.strain * half_width_of(trials, found.own);
  return found;
}

}  // namespace percal
