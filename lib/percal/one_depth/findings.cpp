#include "percal/one_depth/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/scene/erosion_length.hpp"

namespace percal {
namespace {

constexpr double steep_enough = 0.1;  // |d ln depth/d ln value|: below it a depth says next to nothing

std::string element_words(const InvertRequest& request) {
  return fmt::format("elements of 1/{:.4g} radius ({})", request.elements_per_radius,
                     page::length(request.shot.radius / request.elements_per_radius, 3));
}

// What elements leave in a depth that is judged over a length, as a share of the number.
std::string bias_words(const OneDepth& found) {
  const Scene scene = scene_of(found.request, found.own().material);
  Penetration at_root;
  at_root.depth = found.request.depth;
  const DepthError error = depth_error(scene, reduce(scene), at_root);
  if (!error.bias || !error.bias->half_width) return "";
  const double of_depth = *error.bias->half_width / found.request.depth;
  return fmt::format(
      "Erosion is judged over a length: {} leave up to {} in the depth, {} in the {}, which the "
      "interval does not hold.",
      element_words(found.request), page::rough_percent(of_depth),
      page::rough_percent(of_depth / std::abs(found.own().search.slope)), name_of(found.request.sought));
}

// Runs of the line's range that passed through: those that went deepest are not in it.
long passed_beside_line(const Inversion& search) {
  double softest = INFINITY;
  for (const InversionPoint& point : search.points)
    if (point.in_line) softest = std::min(softest, point.log_modulus);
  return std::ranges::count_if(search.points, [&](const InversionPoint& point) {
    return point.answer.censored && point.log_modulus >= softest;
  });
}

}  // namespace

void add_findings(OneDepth& found) {
  const InvertRequest& request = found.request;
  const PairOfDepth& own = found.own();
  const std::string sought = name_of(request.sought), given = name_of(other(request.sought));
  if (!own.found()) return;  // the pair says why
  if (std::abs(own.search.slope) < steep_enough)
    found.warnings.push_back(
        fmt::format("The depth hardly changes with the {}: it says next to nothing of it.", sought));
  if (!request.depth_error)
    found.warnings.push_back("No error of the depth was given (--depth-error): the interval takes it as exact.");
  if (const long passed = passed_beside_line(own.search))
    found.warnings.push_back(
        fmt::format("{} near the answer passed through the layer and {} not in the line: the {} may "
                    "be too low.",
                    page::counted(passed, "run"), passed == 1 ? "is" : "are", sought));
  for (const ValueErrorPart& part : own.errors)
    if (!part.of_value)
      found.warnings.push_back(fmt::format("The interval leaves out the error by {}: {}.", part.source, part.how));
  for (const std::string& warning : reduce(scene_of(request, own.material)).warnings)
    found.warnings.push_back(warning + ".");
  if (found.ridge_exponent)
    found.findings.push_back(
        fmt::format("One depth tells one number: every pair of the ridge gives it, along which the modulus goes as the "
                    "erosion strain to the power {:.2g}. The {} has no error here.",
                    *found.ridge_exponent, given));
  found.findings.push_back(
      request.material.erosion_length
          ? bias_words(found)
          : fmt::format(
                "Each element erodes by its own strain: the pair belongs to {}, in meshes of other elements the "
                "erosion strain is another one (percal card write --element-size).",
                element_words(request)));
}

}  // namespace percal
