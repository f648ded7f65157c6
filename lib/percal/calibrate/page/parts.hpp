// Sections of a calibration's page. For the .cpp files of this folder.
#pragma once
#include "percal/page/sections.hpp"

namespace percal::page {

// hypothesis.cpp: what one hypothesis found.
Section hypothesis_section(const Json& result, const Json& hypothesis, int number);

// curves.cpp: a hypothesis's curves over the data, and what is left.
std::vector<Figure> curve_figures(const Json& result, const Json& hypothesis, int number);

// depths.cpp: depths measured against model's, and against the impact parameter.
Figure depths_figure(const Json& result, const Json& hypothesis, int number);
Section impact_parameter_section(const Json& result);

// all.cpp: what concerns all hypotheses.
Section ridges_section(const Json& result);
Section predictions_section(const Json& result);
Section emulators_section(const Json& result);

}  // namespace percal::page
