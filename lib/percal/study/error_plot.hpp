// The plot of error against processor time.
#pragma once
#include <string>

#include "percal/study/error_vs_time.hpp"

namespace percal {

// A script for gnuplot that draws an SVG on its standard output: both axes logarithmic, a series for each replicate count with
// its interval, its noise floor dashed. Needs a study that is fitted.
std::string error_plot_script(const Ladder& ladder, const ErrorVsTime& study, const std::string& title);

}  // namespace percal
