// The last state of a run as one picture: elements coloured by their largest stretch, the particle, both sides of the axis.
#pragma once
#include <string>

#include "percal/impact/frame.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

enum class PictureFormat { png, svg, pdf };

// By the end of the file's name. Throws BadInput, which names `key`.
PictureFormat picture_format(const std::string& file, const std::string& key);

// For gnuplot (plot/gnuplot.hpp). Eroded elements are left out, and what is far from the crater. Lengths in um, mm or cm.
std::string picture_script(const Frame& frame, const Problem& problem, const Scales& scales, PictureFormat format,
                           const std::string& title);

}  // namespace percal
