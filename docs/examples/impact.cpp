// A ball shot into a layer: depth with its scatter, and where the energy went.               impact SCENE.toml
#include <cstdio>
#include <exception>
#include <percal/campaign.hpp>
#include <percal/problem.hpp>
#include <percal/scene.hpp>

int main(int argc, char** argv) try {
  if (argc != 2) return std::fprintf(stderr, "usage: impact SCENE.toml\n"), 2;

  percal::Scene scene = percal::read_scene(argv[1]);
  scene.mesh.elements_per_radius = 5;  // coarse: for a look

  // The same impact without dimensions, and what the run does without.
  const percal::Reduction reduction = percal::reduce(scene);
  for (const percal::LeftOut& omission : reduction.left_out)
    std::printf("left out: %s (%s)\n", omission.what.c_str(), omission.why.c_str());

  // The mean of three runs over the mesh phase, at speeds 0.1 % apart: one run of an eroding impact is a noisy sample. No store:
  // nothing is kept.
  percal::Campaign campaign(nullptr, 1);
  const auto runs = campaign.replicate({reduction.problem}, 3, nullptr).front();
  const percal::Penetration found = percal::summarise(runs, reduction.problem, reduction.scales);

  // The outcome is a value that the caller must look at: a depth is there only where every run stopped.
  if (found.depth)
    std::printf("stopped at %.4g m, spread of a run %.2g m\n", *found.depth, *found.spread);
  else
    std::printf("%s\n", percal::word(found.outcome).c_str());
  for (const percal::EnergyTerm& term : percal::energy_terms)
    std::printf("%-18s %6.3f of the impact energy\n", term.key, found.energy.*term.share);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
