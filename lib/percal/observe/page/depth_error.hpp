// The error of a depth, by source: as JSON under `depth_error` and `extrapolation`, and in words.        docs/formats/impact.md
#pragma once
#include <optional>
#include <string>

#include "percal/observe/depth_error.hpp"
#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal {

page::Json depth_error_to_json(const DepthError& error);
page::Json extrapolation_to_json(const std::optional<Extrapolation>& extrapolation);

namespace page {

// "27.1 um ± 0.5 um (95 %: mesh phase 0.4, wall 0.2, step 0.1, K 0.1; belongs to elements of 1/10 radius)". Of an extrapolated
// depth that one, "extrapolated from 10 and 20 elements per radius". The depth alone where nothing of the error is known.
std::string depth_words(const Json& result);

// What elements leave in a depth that is judged over a length and not extrapolated; empty where there is no such depth.
std::string bias_words(const Json& result);

// The phase means that an extrapolated depth comes from; empty without one.
std::string mesh_depths(const Json& result);

// Some source goes by a rule that `--measure-errors` would replace.
bool rules_are_in(const Json& result);

// A row a source with its half width and where it comes from.
Section depth_error_section(const Json& result);

}  // namespace page
}  // namespace percal
