// Sections of the pages of fits, and what they share. For the .cpp files of this folder.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "percal/material/hyperelastic.hpp"
#include "percal/page/sections.hpp"

namespace percal::page_of_fit {

using namespace page;

// --- error_band.cpp
// The solid of an entry of `minima`.
Hyperelastic solid_of(const Json& minimum);

// What the linearised model says of the best minimum: the covariance of mu_1, .., mu_K (Pa) and of the exponents that
// were fitted, and Student's t at the fit's level.
struct CurveErrors {
  Eigen::MatrixXd covariance;
  double student = 2, level = 0.95;
  bool free_alphas = true;
};
// None where the fit gives no standard errors: at a bound, with a robust loss, where the points cannot tell.
std::optional<CurveErrors> curve_errors(const Json& result);

// Half the width of the curve's confidence band, Pa.
double half_width(const Hyperelastic& solid, const CurveErrors& errors, const Strained& strained);

// 2 mu/alpha of a one-term solid and half the width of its interval, by the linearised model.
struct Mu1 {
  double value;
  std::optional<double> half_width;
};
Mu1 mu_over_alpha(const Ogden& term, const std::optional<CurveErrors>& errors);

// --- curves.cpp
// The points of one test in a result's `data`.
struct PagePoints {
  std::string name;
  Deformation deformation = Deformation::uniaxial;
  std::vector<Strained> strained;
  std::vector<double> stress, error;  // Pa; error is NaN where there is none
};
std::vector<PagePoints> points_of(const Json& result);

// One curve beside its points: the model's stress at a deformation, and half its band's width (NaN: no band).
struct PageCurve {
  std::string name;  // "fit"
  PagePoints points;
  std::function<double(const Strained&)> stress, half_width;
};

// A figure for each deformation, points over curves, and one of the residuals, in the fit's own kind.
void add_curve_figures(Section& section, const std::vector<PageCurve>& curves, const std::string& band_words);
Figure residual_figure(const std::vector<PageCurve>& curves, const std::string& residual);

// --- details.cpp
const Json& best(const Json& result);                        // minimum; null where there is none
const Json& about(const Json& result, std::size_t minimum);  // its intervals; null where it has none
bool has_intervals(const Json& result);
std::string level_of(const Json& result);  // "95 % interval"
// Of a parameter at the best minimum, over all pieces that the points allow.
std::string region_of(const Json& result, const std::string& key, const Dimension& dimension, int digits = 3);

Section warnings_section(const Json& result);  // what must be read before the answer; none for a plausible curve
Table sources_table(const Json& result);       // files, columns, SHA-256
Section parameters_section(const Json& result);
Section minima_section(const Json& result);
Section stability_section(const Json& result);
Section solids_section(const Json& result);  // of all models
Section sources_section(const Json& result);
Section left_out_points_section(const Json& result);

// --- peaks.cpp
Section taken_section(const Json& result);  // what was made of the files as the user asked; none without such an option
Section peaks_section(const Json& result);  // where the curves are largest, and what that is worth as an erosion strain

// --- relaxation.cpp
bool relaxes(const Json& result);  // whether a Prony series was fitted, and came to a term or more
Page relaxation_page(const Json& result, const std::string& title);

// --- rate_factor.cpp
Page rate_factor_page(const Json& result);

}  // namespace percal::page_of_fit
