// The scene of a point of a plan: the plan's, with the point's values where the file has others, read by the reader of scenes.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "percal/problem/problem.hpp"
#include "percal/sweep/plan.hpp"

namespace percal {

// Throws BadInput with the point and the key that the reader does not take.
Scene scene_at(const Plan& plan, std::size_t point);

// "particle.speed = 83 m/s, target.bottom = fixed".
std::string in_words(const Plan& plan, const PlanPoint& point);

// A point as it is run.
struct SweepPoint {
  Scene scene;
  Reduction reduction;
};

// Of every point. Throws BadInput where one cannot be run, with the point and the key.
std::vector<SweepPoint> points_to_run(const Plan& plan);

}  // namespace percal
