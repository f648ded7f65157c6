// How far what a field measures may be from what finer settings would give.     docs/theory/errors.md, The error of field measures
#pragma once
#include <optional>
#include <vector>

#include "percal/observe/depth_error.hpp"
#include "percal/observe/field_measures.hpp"

namespace percal {

// Half widths at depth_error_level: of a single replicate nothing, for it shows no phase. Of a mesh of elements of this size, as the depth's error is.
struct FieldErrors {
  std::vector<std::optional<double>> speeds_behind;  // m/s, one a layer
  std::optional<double> exit_speed;                  // m/s
  std::optional<double> final_depth, final_speed;    // m, m/s
  std::vector<std::optional<double>> largest, end;   // m, of the channel's radii
};

FieldErrors field_errors(const FieldMeasures& measures, const Scene& scene, const Reduction& reduction,
                         const Penetration& penetration);

// Half width of a speed left when the energy that was lost is known to this share of itself: what is left of v is sqrt(v^2 - lost).
double speed_half_width(double speed, double impact_speed, double share);

}  // namespace percal
