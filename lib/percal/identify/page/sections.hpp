// Sections of an identification's page, by the file that has them. For the .cpp files of this folder.
#pragma once
#include <limits>

#include "percal/page/sections.hpp"

namespace percal::page_of_identify {

using namespace page;

inline constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

std::string sphere_words(const Json& sphere);  // "gold of radius 1 um at 651 m/s"

// search.cpp: what was searched, and on which mesh.
Section law_section(const Json& result);
Section alpha_section(const Json& result);
Table ridge_table(const Json& result);
Section ridge_section(const Json& result);
Section mesh_section(const Json& result);

// depths.cpp: measured depths, the reference's and percal's against the impact parameter rho_p v a.
Section depths_section(const Json& result);

// model.cpp: the model material's shots in other scales, and carried over to the tissue.
Section model_section(const Json& result);
Section scaled_section(const Json& result);
Section trends_section(const Json& result);

// One shot of a result, and those of one set, in SI.
struct PageShot {
  std::string particle;
  double particle_density = 0, radius = 0, speed = 0;
  double target_density = 0, mu = 0;                          // mu true
  double measured = 0, reference = 0, depth = 0, spread = 0;  // NaN where there is none

  double impact_parameter() const { return particle_density * speed * radius; }
};
struct PageSet {
  std::string system, material;
  std::vector<PageShot> shots;
};
// The result's sets of predictions, one for each system and target density.
std::vector<PageSet> prediction_sets(const Json& result);

// Shots of one kind of ball: material and size.
struct BallGroup {
  std::string name;
  std::vector<PageShot> shots;
};
std::vector<BallGroup> by_ball(const std::vector<PageShot>& shots);

}  // namespace percal::page_of_identify
