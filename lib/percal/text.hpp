// text: CSV, TOML, files.
//
// CSV as people have it, TOML with every key checked, files that are written whole or not at all. What is wrong is
// told with file and line.
//
//     const percal::CsvTable table = percal::read_csv("curve.csv");
//     const auto stress = table.numbers("stress", percal::dimension::pressure);  // Pa, whatever the header's unit
//
// See docs/formats/csv.md.
#pragma once
#include "percal/text/csv.hpp"
#include "percal/text/file.hpp"
#include "percal/text/job_table.hpp"
#include "percal/text/range.hpp"
#include "percal/text/stl.hpp"
#include "percal/text/toml.hpp"
#include "percal/text/toml_edits.hpp"
