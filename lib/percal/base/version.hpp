#pragma once
#include <string>

namespace percal {

// "0.1.0": written into every result.
std::string version();

// Raised whenever the same problem would give other bits; part of every stored evaluation's key.
inline constexpr int solver_version = 5;

// The same of the solver in three dimensions.
inline constexpr int solid_version = 1;

// Raised whenever a result file's keys change meaning.
inline constexpr int result_schema = 2;

}  // namespace percal
