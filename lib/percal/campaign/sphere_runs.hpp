// Finished runs of rigid spheres as an emulator takes them, whatever system they came from.     docs/theory/emulator.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/impact/result.hpp"
#include "percal/invert/emulator.hpp"
#include "percal/problem/problem.hpp"
#include "percal/store/store.hpp"

namespace percal {

// A rigid sphere in one layer, or in one with covers, that erodes by strain; axisymmetric, without relaxation, fibres, stretch or friction.
bool is_for_an_emulator(const Problem& problem);

struct StoredSphere {
  Problem problem;
  std::string key;
  std::string outcome;          // word(Outcome)
  std::optional<double> reach;  // reach_of()
  double cpu_seconds = 0;
};

// Every evaluation of the store that this solver version made at this machine's instruction level and that is_for_an_emulator(); in the
// order of the keys. Throws IoFailure.
std::vector<StoredSphere> stored_spheres(const Store& store);
// What their keys begin with.
std::string stored_spheres_prefix();

// Radii: over which erosion is judged; nothing where each element is judged by itself.
std::optional<double> erosion_length(const Problem& problem);

// The emulator's input for it: ln(l/a), 0 where there is none.
double log_erosion_length(const std::optional<double>& radii);

// The side of an element over that length, over the radius where there is none, over the smaller of half width and half thickness of a
// prism or polyhedron: TrainingRun::h.
double element_size(const Problem& problem);

// Of a problem with StrainErosion. The strain is the engineering one, whatever the problem's measure: a limit is a critical stretch. A
// replicate's speed f v is the speed: pi4 f^2. Of several layers the lowest is the one that the others cover, each as thick as its rows of elements.
SphereInputs inputs_of(const Problem& problem);

// Whatever else decides the depth, but the sizes of the elements and of an erosion length: two problems with the same text belong to one emulator. Contact,
// wall and bottom, viscosities, arithmetic, the solver's version, ... Of a problem with StrainErosion; its measure is not in it.
std::string setting_of(const Problem& problem);

// The run of a sphere in one layer in this setting, by this version of the solver; log_depth is not looked at. Throws BadInput for a text that
// is no setting.
Problem problem_of(const std::string& setting, const TrainingRun& run);

// In radii (invert/reach.hpp): the depth of a run that stopped; of one that went on past the lower face (RunUntil::passage or rest) what its
// speed left says, or the layer's depth where the sphere was held there. Nothing of other ends, and of one that lost less than a
// tenth of its energy.
std::optional<double> reach_of(const Problem& problem, const ImpactResult& result);

// Of a sphere with this reach.
TrainingRun training_run(const Problem& problem, double reach);

}  // namespace percal
