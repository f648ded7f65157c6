// What one run of the impact solver ends with. Dimensionless: lengths in radii, energies over the impact energy where said.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace percal {

// How a run ended: a value that the caller must look at.
//   stopped         the sphere came to rest: depth is its deepest tip position
//   passed_through  the tip reached the bottom of the layer: depth is at least the layer's
//   time_up         the end time came first, or the step collapsed: depth is the deepest so far
//   unstable        an element turned inside out, energy was not conserved or a number was not finite
enum class Outcome { stopped, passed_through, time_up, unstable };
std::string word(Outcome outcome);
Outcome outcome_from(const std::string& word);  // throws std::invalid_argument

// Where the impact energy went, each as a share of it. Shares of a perfect solver sum to 1.
struct EnergyLedger {
  double particle = 0;          // kinetic, of the particle
  double particle_elastic = 0;  // stored in an elastic particle
  double live_kinetic = 0;      // of nodes that have an element left
  double freed_mass = 0;        // kinetic, of nodes whose elements are all gone
  double elastic = 0;           // stored in live elements
  double hourglass = 0;         // stored in their hourglass springs
  double viscosity = 0;         // taken by the bulk viscosity
  double relaxation = 0;        // work of the stresses that relax: lost, or not yet; `elastic` is then what lasts
  double eroded = 0;            // stored in elements when they were taken out
  double collisions = 0;        // lost where nodes of the target met the particle
  double friction = 0;          // taken by friction between the two

  double sum() const;
  double closure() const { return sum() - 1; }                      // the solver's own energy error
  double numerical_loss() const { return viscosity + collisions; }  // no part of the physics asked for
};

// Every term of the ledger with its key in results and its words on pages, in the order in which sum() adds them.
struct EnergyTerm {
  const char* key;
  double EnergyLedger::*share;
  const char* words;
};
inline constexpr EnergyTerm energy_terms[] = {
    {"particle", &EnergyLedger::particle, "particle, kinetic"},
    {"particle_elastic", &EnergyLedger::particle_elastic, "particle, elastic"},
    {"live_kinetic", &EnergyLedger::live_kinetic, "nodes with elements, kinetic"},
    {"freed_mass", &EnergyLedger::freed_mass, "freed mass, kinetic"},
    {"elastic", &EnergyLedger::elastic, "elastic"},
    {"hourglass", &EnergyLedger::hourglass, "hourglass springs"},
    {"viscosity", &EnergyLedger::viscosity, "bulk viscosity"},
    {"relaxation", &EnergyLedger::relaxation, "relaxation"},
    {"eroded", &EnergyLedger::eroded, "eroded elements"},
    {"collisions", &EnergyLedger::collisions, "collisions of nodes with the particle"},
    {"friction", &EnergyLedger::friction, "friction along the particle"}};

// Elements by the criterion that took them out, where there are several. Those taken out for their distortion are in none.
struct ErodedBy {
  long strain = 0, stress = 0, energy = 0;
  bool operator==(const ErodedBy&) const = default;
};

struct HistoryPoint {
  double time;               // radii over impact speed
  double tip;                // depth of the tip, radii
  double speed;              // over impact speed, half a step behind
  double force;              // on the sphere, upwards, over rho_t v^2 a^2 per radian
  EnergyLedger energy = {};  // at this time, velocities too
};

// How a run ends that goes on past its deepest point, or past the target's lower face (RunUntil::rest): a value that the caller
// must look at. docs/theory/field_measures.md.
//   rests           the tip moves no more, but for `half_width`
//   left_upwards    the particle flies back out, touched by nothing
//   ricochets       the same of one that came aslant
//   passed_through  the same below the target; where its bottom is held, the tip has reached it
//   time_up         the end time came first, or the step collapsed
//   unstable        as Outcome::unstable, after the deepest point
enum class Ending { rests, left_upwards, ricochets, passed_through, time_up, unstable };
std::string word(Ending ending);
Ending ending_from(const std::string& word);  // throws std::invalid_argument

struct Aftermath {
  Ending ending = Ending::unstable;
  std::string reason;  // as ImpactResult::reason
  double depth =
      0;  // of the tip, radii: the middle of where it was in the last half of the run's time; where it left, at the end
  double half_width = 0;  // radii: half of that swing; 0 where it left
  double time = 0;        // radii over impact speed
  double speed = 0;       // downwards, over the scene's impact speed
  long eroded = 0;
  EnergyLedger energy;
};

// Where the channel's radius is taken: shares of a run's deepest tip position, in undeformed depth.
inline constexpr std::array<double, 10> channel_shares{0.05, 0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95};

// Half the distance of the walls that erosion has left, radii, at channel_shares; 0 where a row is whole. Empty unless asked for.
struct Channel {
  std::vector<double> largest;  // over the run
  std::vector<double> end;      // when it ended
};

// What turns about all axes and moves along y, too: a polyhedron in a whole block. x to the right, y away, z upwards.
struct SpacePath {
  double across = 0;  // how far the centre of mass went along y, radii
  std::array<double, 3> axis{0, 0,
                             0};  // about which it has turned by ImpactResult::turn, anticlockwise seen against it
};

struct ImpactResult {
  Outcome outcome = Outcome::unstable;
  std::string reason;  // of unstable, and of a time that is up because the step collapsed, in words; else empty
  double depth = 0;    // deepest tip position, radii
  double end_time = 0;
  double end_speed = 0;
  double sideways = 0;  // how far a free particle's centre of mass went to the right, radii
  double turn = 0;      // how far it turned anticlockwise, rad
  std::optional<SpacePath> in_space;
  double target_momentum = 0;  // downwards, of the target's nodes, over particle mass times the scene's impact speed
  long elements = 0;
  long steps = 0;            // of the longer kind
  double element_steps = 0;  // elements of the rows that were advanced, live and dead, times their steps
  long eroded = 0;
  long distorted = 0;  // of these: taken out because J or the step became too small, not by their strain
  ErodedBy eroded_by;  // all 0 where one criterion decides
  double smallest_jacobian = 1;
  double smallest_step = 0;  // over the first
  EnergyLedger energy;
  double helper_cpu_seconds = 0;      // processor time of threads besides the calling one
  std::vector<HistoryPoint> history;  // empty unless asked for
  // Downwards, over the scene's impact speed, when the tip crossed the undeformed lower face of each layer that it crossed.
  std::vector<double> speeds_behind;
  // Of the tip, radii, when half of the speed at impact was left; 0 where more of it was left, and of a block.
  double half_speed_depth = 0;
  Channel channel;
  // What came then. The rest is of the moment at which a run without it ends, but for steps and element_steps, the history and the
  // channel.
  std::optional<Aftermath> aftermath;
};

}  // namespace percal
