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

}  // namespace

void add_findings(OneDepth& found) {
  const InvertRequest& request = found.request;
  const PairOfDepth& own = found.own();
  const std::string sought = name_of(request.sought), given = name_of(other(request.sought));
  if (!own.found()) {
    found.warnings.push_back(fmt::format("No {} was found: {}.", sought, own.why_not));
    return;
  }
  if (std::abs(own.search.slope) < steep_enough)
    found.warnings.push_back(
        fmt::format("The depth hardly changes with the {}: it says next to nothing of it.", sought));
  if (!request.depth_error)
    found.warnings.push_back("No error of the depth was given (--depth-error): the interval takes it as exact.");
  if (request.speed_error && !own.errors[request.depth_error ? 2 : 1].of_value)
    found.warnings.push_back("What the speed's error does is not known without a ridge: the interval leaves it out.");
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
