#include "percal/observe/penetration.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/math/distributions.hpp"
#include "percal/math/statistics.hpp"

namespace percal {

EnergyLedger mean_energy(const std::vector<EnergyLedger>& energies) {
  EnergyLedger mean;
  for (const EnergyTerm& term : energy_terms)
    for (const EnergyLedger& energy : energies)
      mean.*term.share += energy.*term.share / static_cast<double>(energies.size());
  return mean;
}

MeanOfRuns mean_of_runs(const std::vector<double>& values) {
  if (values.empty()) return {};
  if (values.size() < 2) return {.mean = values.front()};
  const double spread = sample_deviation(values);
  return {mean(values), spread, spread / std::sqrt(static_cast<double>(values.size()))};
}

Penetration summarise(const std::vector<Evaluation>& replicates, const Problem& problem, const Scales& scales) {
  Penetration p;
  p.outcome = replicates.front().result.outcome;
  for (const auto& run : replicates) {
    p.outcomes.push_back(run.result.outcome);
    p.depths.push_back(run.result.depth * scales.radius);
    p.mixed |= run.result.outcome != p.outcomes.front();
    if (p.outcome == Outcome::stopped) p.outcome = run.result.outcome;
    if (run.result.outcome == Outcome::passed_through) p.at_least = problem.whole_depth() * scales.radius;
    if (run.result.steps > 0) p.worst_closure = std::max(p.worst_closure, std::abs(run.result.energy.closure()));
  }
  std::vector<EnergyLedger> energies;
  for (const auto& run : replicates) energies.push_back(run.result.energy);
  p.energy = mean_energy(energies);
  if (p.outcome != Outcome::stopped) return p;
  const auto [mean, spread, standard_error] = mean_of_runs(p.depths);
  p.depth = mean;
  p.spread = spread;
  p.standard_error = standard_error;
  return p;
}

namespace {

const double normal95 = normal_quantile(0.975);

}  // namespace

double AtlasDepth::low() const { return depth * std::exp(-normal95 * std::hypot(deviation, noise)); }
double AtlasDepth::high() const { return depth * std::exp(normal95 * std::hypot(deviation, noise)); }

double joined_error(const AtlasDepth& atlas, int runs) {
  return 1 / std::sqrt(1 / (atlas.deviation * atlas.deviation) + runs / (atlas.noise * atlas.noise));
}

Penetration joined(const Penetration& of_runs, const AtlasDepth& atlas) {
  const auto runs = static_cast<int>(of_runs.depths.size());
  const double error = joined_error(atlas, runs), share_of_runs = error * error * runs / (atlas.noise * atlas.noise);
  Penetration both = of_runs;
  both.is_joined = true;
  both.depth = atlas.depth * std::pow(*of_runs.depth / atlas.depth, share_of_runs);
  both.standard_error = *both.depth * error;
  if (!both.spread) both.spread = *both.depth * atlas.noise;
  return both;
}

double allowed_apart(const AtlasDepth& atlas, int runs) {
  return normal95 * (atlas.deviation + atlas.noise / std::sqrt(runs));
}

std::vector<std::string> warnings(const Penetration& penetration, const std::vector<Evaluation>& replicates) {
  std::vector<std::string> lines;
  if (penetration.mixed) {
    std::string list;
    for (const Outcome outcome : penetration.outcomes) list += (list.empty() ? "" : ", ") + word(outcome);
    lines.push_back("the replicates ended differently (" + list + "): their depths are not averaged");
  }
  if (penetration.outcome != Outcome::unstable && penetration.energy.numerical_loss() > tolerated_numerical_loss)
    lines.push_back(fmt::format(
        "collisions of nodes with the particle ({:.0f} %) and bulk viscosity ({:.0f} %) take more than half of "
        "the impact energy: the depth hangs on how the mesh takes shocks",
        100 * penetration.energy.collisions, 100 * penetration.energy.viscosity));
  for (const auto& run : replicates) {
    if (!run.result.reason.empty()) lines.push_back(word(run.result.outcome) + ": " + run.result.reason);
    if (run.result.distorted > 0)
      lines.push_back(fmt::format("{} elements were taken out because they were distorted, not by their strain",
                                  run.result.distorted));
  }
  return lines;
}

}  // namespace percal
