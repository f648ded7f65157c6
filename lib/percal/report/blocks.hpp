// Blocks and sections that the pages of several commands share. For the .cpp files of this folder.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/report/json_read.hpp"
#include "percal/report/page.hpp"

namespace percal::report_parts {

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
void add(PageSection& section, PageFigure figure);
void add(PageSection& section, PageTable table);
void add_paragraph(PageSection& section, const std::string& text);
void add(Page& page, PageSection section);

// A table of numbers beside somebody else's, as identifications write them.
PageTable comparison_table(const Json& table);

// --- sections that every result has ---------------------------------------------------------------------------------
PageSection findings_section(const Json& result);
PageSection left_out_section(const Json& result);
// Version, processor, what it cost.
PageSection provenance_section(const Json& result);
// The job as it was read.
PageSection input_section(const Json& result);

}  // namespace percal::report_parts
