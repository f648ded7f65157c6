// Numbers of the march that no scene sets: what each is, when to change it, what goes wrong if it is.
#pragma once

namespace percal {

// --- the time step ---------------------------------------------------------------------------------------------------

// The step may grow by this factor from one to the next. Smaller: after a stiff element has gone, a run crawls on with
// its step for longer. Larger: central differences, of second order only where the step changes slowly, make or lose
// energy.
inline constexpr double step_growth = 1.05;

// The particle, as fast as at impact, passes at most this share of a row in a long step. Larger: on coarse meshes of soft
// targets it outruns the target, and turns elements inside out before they push it.
inline constexpr double largest_travel = 0.5;

// A run whose step falls below this share of the first is called off. Larger: stiff cases that would end well are given
// up. Smaller: a hopeless one takes hours to say so.
inline constexpr double collapsed_step = 1e-4;

// A run that has not ended after so many long steps is called off.
inline constexpr long most_steps = 50'000'000;

// Where the impact is faster than the target's waves: least viscosities, linear and quadratic, and largest time-step
// factor. With less viscosity the shock rings and turns elements inside out; with more the front is smeared over more
// rows, and the step that the viscosity allows shrinks.
inline constexpr double supersonic_linear = 0.2;
inline constexpr double supersonic_quadratic = 2;
inline constexpr double supersonic_step = 0.5;

// --- two rates: a short step near the particle, a long one far from it (docs/decisions/0006-two-rates.md) -------------

// Elements take the short step from this many radii above the tip, in undeformed depth, to the first whole group of
// rows below it. Less: strongly deformed elements are left to the long step until one is seen to be too stiff for it.
// More: time.
inline constexpr double near_behind = 2;

// The long step may be this share of the stable step of the undeformed element. Nearer to 1: more elements are too
// stiff for it and join the short one.
inline constexpr double longest_far_step = 0.9;

// Long steps between two choices of who takes the short one. More: an element grows too stiff for its step before
// anybody looks. Fewer: time.
inline constexpr int near_interval = 8;

// --- elements that are taken out, or end a run ---

// An eroding scene takes out an element compressed below this J, or whose stable step falls below this share of the
// first: it is past its criterion in all but name. Smaller: a few crushed elements dictate the step. Larger: the depth
// depends on it.
inline constexpr double distorted_jacobian = 0.05;
inline constexpr double distorted_step = 0.016;

// Where erosion is judged by an average, that may exceed its limit by this times the element over the length, for an element goes
// whole where its centre is past the limit (docs/theory/impact.md, "Erosion judged over a length"). Without it coarse meshes go
// deeper, by 6 % at h/l = 1/3 in setting S; with twice as much they stay too shallow.
inline constexpr double averaging_allowance = 0.8;

// Below this J an element counts as turned inside out, which ends a run that does not erode. At 1e-3 element.hpp bounds
// J.
inline constexpr double inverted_jacobian = 1e-3;

// A run that makes or loses a larger share of the impact energy is unstable.
inline constexpr double tolerated_energy_error = 0.05;

// --- work that is left out ---

// Rows whose nodes are all slower, over the impact speed, are at rest and not advanced; they join in groups of
// `front_rows`, and every `front_interval` steps somebody looks: a wave crosses a row a step at most, so the interval
// must stay below the group.
inline constexpr double rest_speed = 1e-6;
inline constexpr int front_rows = 32;
inline constexpr int front_interval = 8;

// Steps between two searches for the highest row that contact can reach. More: a wider margin, so more rows are looked
// at.
inline constexpr int search_interval = 32;

// Columns that start further out, in radii, never meet the particle. Less: those that a deep crater draws in are
// missed.
inline constexpr double search_radius = 2.2;

// A node with as little way out as this, squared, between two sides that face each other is left where it is.
inline constexpr double flattest_way_out = 1e-3;

// --- past the deepest point (docs/theory/field_measures.md) ------------------------------------------

// A tip that has kept within this share of its deepest position over the last half of a run's time is at rest. Smaller: swings that walls
// send back and nothing damps never end. Larger: a particle that still creeps out of its channel is taken for one at rest.
inline constexpr double rest_swing = 0.05;

// In radii at impact speed: of looks for that, and of what is kept of the path.
inline constexpr double rest_interval = 0.25;

// Over the impact speed: a particle outside the target whose speed has changed by no more over its own height is touched by nothing any
// more. Smaller: the rounding of an elastic particle's momentum is taken for a touch. Larger: so is a slow push from behind.
inline constexpr double free_speed_change = 1e-4;

// --- an elastic particle (docs/theory/elastic_particle.md) ---

// On its radius, however coarse the target. Fewer: its lowest frequencies, and with them what it stores, are wrong.
inline constexpr int fewest_particle_elements = 6;

// Share of its stable step that it takes. Nearer to 1: its energy closes less well.
inline constexpr double particle_step_factor = 0.8;

// Moves between two looks at its stable step, which cost as much as several steps; after a look that found 1/dt^2
// changed by more than `particle_step_change` the next is at once. More: it deforms past a step that has become too
// long.
inline constexpr int particle_step_interval = 8;
inline constexpr double particle_step_change = 0.02;

// Of an overlap that the sphere's own deformation has left, the share that a step's impulses take back. Larger: they push energy into
// a soft sphere. Smaller: overlaps stay.
inline constexpr double overlap_taken_back = 0.2;

// A gap is believed to have opened this many times as fast as node and outline close: where a soft sphere's outline folds, a node near it
// is suddenly deep inside, and what takes it back at once is a blow. More than one, since the outline is curved.
inline constexpr double most_over_closing = 2;

// Its own steps in one of the march's; one that needs more is not run, for a rigid one will do.
inline constexpr int most_particle_steps = 200;

}  // namespace percal
