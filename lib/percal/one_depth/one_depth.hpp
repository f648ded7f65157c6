// The number of a layer that one depth asks for, and the ridge that the depth leaves: pairs of modulus and erosion strain.
//                                                                                               docs/theory/prediction.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/campaign/campaign.hpp"
#include "percal/one_depth/request.hpp"
#include "percal/one_depth/value_error.hpp"
#include "percal/page/result.hpp"
#include "percal/predict/shot_model.hpp"

namespace percal {

// What the search at one value of the given number came to.
struct PairOfDepth {
  LayerMaterial material;                   // with the number that was found
  Inversion search;                         // in its ln
  std::string why_not = {};                 // in words, where nothing was found
  std::vector<ValueErrorPart> errors = {};  // the solver's first; none where nothing was found
  std::optional<Between> interval = {};
  bool found() const { return why_not.empty(); }
};

struct OneDepth {
  InvertRequest request;
  std::vector<PairOfDepth> ridge;             // one a factor
  std::optional<double> ridge_exponent = {};  // d ln mu / d ln erosion strain along it; of two pairs or more
  std::vector<std::string> warnings = {}, findings = {};
  page::Cost cost = {};
  const PairOfDepth& own() const { return ridge[own_factor]; }  // at the number that was given
};

OneDepth find_at_depth(const InvertRequest& request, Campaign& campaign);

}  // namespace percal
