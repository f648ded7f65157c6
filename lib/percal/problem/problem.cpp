#include "percal/problem/problem.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>

#include "percal/base/version.hpp"

namespace percal {

double mach_number(const Problem& problem) { return std::sqrt(problem.pi4 / (problem.bulk_ratio + 4.0 / 3)); }

double subsonic_bulk_ratio(double pi4) { return 1.01 * pi4 / (recommended_mach * recommended_mach) - 4.0 / 3; }

double replicate_speed_factor(int replicate) {
  const int step = (replicate + 1) / 2;
  return 1 + (replicate % 2 == 1 ? 0.001 : -0.001) * step;
}

double round_to_12_digits(double x) { return std::strtod(fmt::format("{:.11e}", x).c_str(), nullptr); }

std::string evaluation_key(const Problem& p, const std::string& instruction_level) {
  std::string erosion = "none";
  if (const auto* strain = std::get_if<StrainErosion>(&p.erosion))
    erosion = fmt::format("{}:{:.12g}", word(strain->measure), strain->limit);
  return fmt::format(
      "sphere solver={} level={} arithmetic={} pi4={:.12g} density_ratio={:.12g} alpha={:.12g} bulk_ratio={:.12g} "
      "depth={:.12g} width={:.12g} bottom={} erosion={} mesh={},{:.12g},{} contact={:.12g} hourglass={:.12g} "
      "viscosity={:.12g},{:.12g} step={:.12g} end={:.12g} speed={:.12g}",
      solver_version, instruction_level, p.arithmetic == Arithmetic::single_precision ? "single" : "double", p.pi4,
      p.density_ratio, p.alpha, p.bulk_ratio, p.depth, p.width, p.bottom == Bottom::free ? "free" : "fixed", erosion,
      p.elements_per_radius, p.fine_width, p.graded_columns, p.contact_stiffness, p.hourglass, p.linear_viscosity,
      p.quadratic_viscosity, p.time_step_factor, p.end_time, p.speed_factor);
}

}  // namespace percal
