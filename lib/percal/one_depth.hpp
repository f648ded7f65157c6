// one_depth: the number of a layer that one depth asks for, and the ridge of pairs that the depth leaves.
//
//     const percal::InvertRequest request = percal::understood(percal::InvertWords{.depth = "85 mm", ...});
//     const percal::OneDepth found = percal::find_at_depth(request, campaign);
//     if (found.own().found()) std::cout << found.own().material.mu_true;
//
// See docs/theory/prediction.md.
#pragma once
#include "percal/one_depth/one_depth.hpp"
#include "percal/one_depth/page/page.hpp"
#include "percal/one_depth/request.hpp"
#include "percal/one_depth/value_error.hpp"
