// Text within gnuplot's scripts and CSV files, whatever it holds: on one line, control characters left out.
#pragma once
#include <string>

namespace percal {

// In single quotes, as gnuplot takes it as it stands; `noenhanced` keeps its markup from being read.
std::string gnuplot_quoted(const std::string& text);

// In double quotes, as a cell of a CSV file. Spreadsheets run a cell that begins with = + - or @ as a formula: a ' goes before it.
std::string csv_quoted(const std::string& text);

}  // namespace percal
