// The result of `percal campaign` and its page.                                                   docs/formats/campaign.md
#pragma once
#include <string>
#include <vector>

#include "percal/page/page.hpp"
#include "percal/page/result.hpp"
#include "percal/sweep/estimate.hpp"
#include "percal/sweep/scene_at.hpp"

namespace percal {

struct SweepFindings {
  const Plan& plan;
  const std::vector<SweepPoint>& points;
  std::vector<std::vector<Evaluation>> runs = {};  // of each point
  page::Cost cost = {};
};

page::Json sweep_to_json(const SweepFindings& findings);

// points.csv: a row a point.
std::string sweep_to_csv(const page::Json& result);

// Whether every point stopped or passed through.
bool all_points_ended_well(const SweepFindings& findings);

page::Page sweep_page(const page::Json& result);

// --- the estimate, which makes no result ------------------------------------------------------------------------------

page::Json estimate_to_json(const CostEstimate& estimate);
std::string in_words(const CostEstimate& estimate);

// --- shared by the sections ---------------------------------------------------------------------------------------

page::Section sweep_figures(const page::Json& result);
std::vector<std::string> swept_values(const page::Json& point);  // as words, in the units of the axes

}  // namespace percal
