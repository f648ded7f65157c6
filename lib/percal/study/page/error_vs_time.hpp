// A study of error against processor time as its result.json, its table as CSV, and its page.
#pragma once
#include "percal/study/advised_setting.hpp"
#include "percal/study/page/page.hpp"

namespace percal {

page::Json error_vs_time_to_json(const Scene& scene, const Ladder& ladder, const ErrorVsTime& study,
                                 const std::vector<AdvisedSetting>& advice, const page::Cost& cost);
page::Json advice_to_json(const AdvisedSetting& advice);

// A line a rung: the meshes, the half steps, the one in double precision.
std::string error_vs_time_csv(const page::Json& result);

page::Page error_vs_time_page(const page::Json& result);

// "A run scatters by 3.8 % on 10 elements per radius, in proportion to their size"; empty where it is not known.
std::string spread_words(const page::Json& result);

// Its figures: ladder_figures.cpp.
page::Figure error_against_time(const page::Json& result);
page::Figure depth_against_element_size(const page::Json& result);

}  // namespace percal
