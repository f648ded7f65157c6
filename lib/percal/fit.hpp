// fit: solids from stress-stretch curves.
//
// Curves out of CSV files or of points; every minimum of one- to three-term Ogden solids, neo-Hooke and Mooney-Rivlin;
// intervals; models compared; one rate factor between two curves.
//
//     const percal::CurveData data = percal::read_curves({"curve.csv"}, {.mode = "uniaxial"});
//     const percal::CurveFit fit = percal::fit_curves(data, {});
//     const percal::Uncertainty sure = percal::uncertainty_of(data, fit, {});
//     std::cout << percal::small_strain_modulus(fit.minima.front().solid) << " Pa\n";
//
// See docs/theory/curves.md.
#pragma once
#include "percal/fit/interval/findings.hpp"
#include "percal/fit/interval/rate_factor.hpp"
#include "percal/fit/interval/uncertainty.hpp"
#include "percal/fit/page/fit_json.hpp"
#include "percal/fit/page/page.hpp"
#include "percal/fit/points/curve_data.hpp"
#include "percal/fit/read/read_curves.hpp"
#include "percal/fit/search/compare_models.hpp"
#include "percal/fit/search/fit_curves.hpp"
