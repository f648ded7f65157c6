// sweep: the plans of percal campaign.
//
// A scene, and what is changed in it from point to point: keys of the scene or dimensionless groups, on a grid, by Sobol's sequence or
// from a list. Every point is a scene that the reader of scenes has read.
//
//     const percal::Plan plan = percal::read_plan("plan.toml");
//     const auto points = percal::points_to_run(plan);
//     const auto runs = percal::run_points(points, campaign, &store, progress);
//
// See docs/formats/campaign.md.
#pragma once
#include "percal/sweep/estimate.hpp"
#include "percal/sweep/page/page.hpp"
#include "percal/sweep/plan.hpp"
#include "percal/sweep/scene_at.hpp"
#include "percal/sweep/sweep_runs.hpp"
