// Numbers of the march that no scene sets, each in its one home.
#pragma once

namespace percal {

inline constexpr double step_growth = 1.05;         // the step may grow by this much from one to the next
inline constexpr double reference_bulk_ratio = 50;  // dt_ref, which contact stiffness is tied to, is taken at this K/mu
inline constexpr double distorted_jacobian = 0.05;  // an eroding scene takes out an element compressed below it
inline constexpr double inverted_jacobian = 1e-3;   // below it an element counts as turned inside out
inline constexpr double distorted_step =
    0.016;  // an eroding scene takes out an element whose step falls below this share of the first
inline constexpr double rounding_of_stretch =
    1e-4;  // the kernel's stretch, in single precision, against the ledger's in double
inline constexpr double collapsed_step = 1e-5;  // a run whose step falls below this share of the first is unstable
inline constexpr double rest_speed = 1e-6;      // rows whose nodes are all slower (over impact speed) are at rest
inline constexpr int front_rows = 32;           // rows are set in motion in groups of this many
inline constexpr int front_interval = 8;    // steps between two looks at the front: a wave crosses a row a step at most
inline constexpr int search_interval = 32;  // steps between two searches for the highest row that contact can reach
inline constexpr double search_radius = 2.2;            // columns that start further out never meet the sphere
inline constexpr double tolerated_energy_error = 0.25;  // a run that makes or loses more energy is unstable
inline constexpr long most_steps = 50'000'000;

}  // namespace percal
