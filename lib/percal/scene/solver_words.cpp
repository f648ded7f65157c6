#include "percal/scene/solver_words.hpp"

#include <fmt/core.h>

namespace percal {

std::string in_words(const SolverScene& solver) {
  const bool stiffness = solver.hourglass_form == HourglassForm::stiffness;
  return fmt::format("bulk viscosity {:g} (linear) and {:g} (quadratic), hourglass {} of {:g} {}",
                     solver.linear_viscosity, solver.quadratic_viscosity, stiffness ? "stiffness" : "viscosity",
                     solver.hourglass, stiffness ? "mu" : "of the wave impedance");
}

}  // namespace percal
