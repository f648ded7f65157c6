// Sections of a calibration's page. For the .cpp files of this folder.
#pragma once
#include "percal/page/sections.hpp"

namespace percal::page {

// A number of a parameter or a modulus under KEY or KEY_Pa, with its unit.
std::string value_words(const Json& object, const std::string& key);
// "1.2 MPa to 3.4 MPa" under KEY or KEY_Pa; an end that a bound cut off is said to be.
std::string interval_words(const Json& object, const std::string& key);
std::string level_words(const Json& result);  // "95 %"

// calibrate_page_reading.cpp: what one reading found.
Section reading_section(const Json& result, const Json& reading, int number);

// calibrate_page_curves.cpp: a reading's curves over the data, and what is left.
std::vector<Figure> curve_figures(const Json& result, const Json& reading, int number);

// calibrate_page_depths.cpp: depths measured against model's, and against the impact parameter.
Figure depths_figure(const Json& result, const Json& reading, int number);
Section impact_parameter_section(const Json& result);

// calibrate_page_all.cpp: what concerns all readings.
Section ridges_section(const Json& result);
Section predictions_section(const Json& result);
Section emulators_section(const Json& result);

}  // namespace percal::page
