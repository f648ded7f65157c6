// Sections of an identification's page. For the .cpp files of this folder.
#pragma once
#include "percal/page/sections.hpp"

namespace percal::page {

// identify_page_search.cpp: what was searched, and on which mesh.
Section law_section(const Json& result);
Section alpha_section(const Json& result);
Section ridge_section(const Json& result);
Section mesh_section(const Json& result);

// identify_page_depths.cpp: measured depths, the reference's and percal's against the impact parameter rho_p v a.
Section depths_section(const Json& result);

// identify_page_model.cpp: the model material's shots in other scales, and carried over to the tissue.
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

}  // namespace percal::page
