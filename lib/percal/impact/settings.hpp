// Numbers of the march that no scene sets, each in its one home.
#pragma once

namespace percal {

inline constexpr double step_growth = 1.05;         // the step may grow by this much from one to the next
inline constexpr double reference_bulk_ratio = 50;  // dt_ref, which contact stiffness is tied to, is taken at this K/mu
inline constexpr double distorted_jacobian = 0.05;  // an eroding scene takes out an element compressed below it
inline constexpr double inverted_jacobian = 1e-3;   // below it an element counts as turned inside out
inline constexpr double distorted_step =
    0.016;  // an eroding scene takes out an element whose step falls below this share of the first
inline constexpr double largest_travel =
    0.5;  // the particle, as fast as at impact, passes this share of a row in a step at most
inline constexpr double collapsed_step = 1e-5;  // a run whose step falls below this share of the first is unstable
inline constexpr double rest_speed = 1e-6;      // rows whose nodes are all slower (over impact speed) are at rest
inline constexpr double near_behind = 2;  // the short step is taken from this many radii above the tip, in undeformed
                                          // depth, to the first whole group of rows below it
inline constexpr double longest_far_step =
    0.9;                                 // the long step may be this share of the undeformed element's stable one
inline constexpr int near_interval = 8;  // long steps between two choices of who takes the short one
inline constexpr double supersonic_quadratic =
    2;  // least viscosities and largest time-step factor where the impact is faster
inline constexpr double supersonic_linear = 0.2;  // than the target's waves
inline constexpr double supersonic_step = 0.5;
inline constexpr int front_rows = 32;       // rows are set in motion in groups of this many
inline constexpr int front_interval = 8;    // steps between two looks at the front: a wave crosses a row a step at most
inline constexpr int search_interval = 32;  // steps between two searches for the highest row that contact can reach
inline constexpr double search_radius = 2.2;  // columns that start further out never meet the sphere
inline constexpr double lost_contact = 0.5;   // a run with a node further inside the particle, in radii, is unstable
inline constexpr double tolerated_energy_error = 0.05;  // a run that makes or loses more energy is unstable
inline constexpr int fewest_particle_elements = 6;      // on an elastic particle's radius
inline constexpr double particle_step_factor = 0.8;     // share of its stable step that an elastic particle takes
inline constexpr int particle_step_interval = 8;      // moves of an elastic particle between two looks at its step, and
inline constexpr double particle_step_change = 0.02;  // 1 where 1/dt^2 last changed by more than this share
inline constexpr double particle_spring_margin = 4;   // on the springs of an elastic particle's nodes, in the step
inline constexpr int most_particle_steps = 200;       // of an elastic particle in one of the march's: beyond, not run
inline constexpr long most_steps = 50'000'000;

}  // namespace percal
