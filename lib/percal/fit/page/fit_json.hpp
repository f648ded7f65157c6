// Curve fits as they stand in result.json; page.hpp reads them.                                 docs/formats/fit.md
#pragma once
#include <chrono>
#include <ctime>

#include "percal/fit/interval/rate_factor.hpp"
#include "percal/fit/read/read_curves.hpp"
#include "percal/fit/relaxation/fit_relaxation.hpp"
#include "percal/fit/search/compare_models.hpp"
#include "percal/material/stability.hpp"
#include "percal/page/result.hpp"

namespace percal {

// What was asked.
struct FitRequest {
  std::vector<std::string> files;
  CurveColumns columns = {};
  CurveOptions options = {};
  StretchRange stretches = {};                                         // over which stability is looked at
  std::optional<UncertaintyOptions> intervals = UncertaintyOptions{};  // none: no intervals
  bool compare = false;                                                // all models
  std::optional<std::string> rate_column = {};      // of a rate factor: empty for a file of each rate; none: a fit
  std::optional<RelaxationChoice> relaxation = {};  // of whole stress histories; none: a solid that knows no time
};

// What came out.
struct FinishedFit {
  CurveData data;
  CurveFit fit;
  std::optional<Uncertainty> uncertainty = {};
  std::optional<std::vector<ComparedModel>> comparison = {};
  std::optional<RelaxationFit> relaxation = {};  // beside it `fit` is the one that knows no time
};

// Two curves of one solid.
struct RatePair {
  CurveData slow, fast;
};

// [[low, high], ...], as results have the pieces of a region.
page::Json region_to_json(const Region& region);

// An interval with its value, and where it was asked for its bootstrap.
page::Json parameter_to_json(const ParameterUncertainty& parameter);

// The block `relaxation` of a result; and what is its `scene`: [target] of a scene with mu, alpha and its [[target.relaxation]], empty
// where a scene has no such solid.
page::Json relaxation_to_json(const CurveData& data, const RelaxationFit& fit);
std::string target_of_scene(const RelaxingSolid& solid);

// Schema, version, command, input and sources: before anything is fitted.
page::Json read_to_json(const FitRequest& request, const std::vector<CurveSource>& sources);

// Every key is there, null where there is nothing; no number is infinite or NaN; units are in the names.
page::Json fit_to_json(const FitRequest& request, const FinishedFit& found, const page::Cost& cost);
page::Json rate_factor_to_json(const FitRequest& request, const RatePair& pair, const RateFactor& found,
                               const page::Cost& cost);

// Runs from where it is made.
struct Stopwatch {
  std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
  std::clock_t processor = std::clock();
  page::Cost cost() const;
};

}  // namespace percal
