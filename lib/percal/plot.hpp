// plot: charts drawn by gnuplot.
//
// A chart is data: axes and series. It is kept as CSV and drawn as SVG or PNG where gnuplot is there.
//
//     const percal::Plot plot = percal::plot_of("depth", chart);
//     const auto svg = percal::draw_svg(plot);  // nothing without gnuplot
#pragma once
#include "percal/plot/chart.hpp"
#include "percal/plot/gnuplot.hpp"
#include "percal/plot/quoted.hpp"
