// Blocks and sections that the pages of several commands share.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal::page {

// --- series, grown point by point -------------------------------------------------------------------------------
Series series(const std::string& name, Mark mark, int colour);
void add_point(Series& series, double x, double y);
void add_bar(Series& series, double x, double y, double low, double high);
// Into the chart, unless it has no point.
void add(Chart& chart, Series series);
// The chart has points to draw.
bool drawable(const Chart& chart);
// Whether positive numbers from low to high are better seen on a logarithmic axis.
bool worth_a_logarithm(double low, double high);
// Evenly spaced numbers from low to high, for lines.
std::vector<double> spaced(double low, double high, int count = 41);

// --- into a section, unless there is nothing in it ----------------------------------------------------------------
void add(Section& section, Figure figure);
void add(Section& section, Table table);
void add(Section& section, List list);
void add_sentence(Section& section, const std::string& text);
void add(Page& page, Section section);

// --- sections that every result has ---------------------------------------------------------------------------------
Section findings_section(const Json& result);
Section left_out_section(const Json& result);
// Version, processor, what it cost.
Section provenance_section(const Json& result);
// The job as it was read.
Section input_section(const Json& result);

}  // namespace percal::page
