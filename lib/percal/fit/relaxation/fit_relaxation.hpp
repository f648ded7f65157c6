// A hyperelastic law times a Prony series, fitted to whole stress histories: ramps and holds, at any number of rates.
// docs/theory/relaxation.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/fit/interval/uncertainty.hpp"
#include "percal/fit/relaxation/relaxation_search.hpp"

namespace percal {

// How many terms: so many, or as many as AICc wants.
struct RelaxationChoice {
  std::optional<int> terms = {};  // 1 .. most_relaxation_terms; none: auto, where it may come to none at all
};
// "1", "2", "3" or "auto"; none for other texts. And back.
std::optional<RelaxationChoice> relaxation_choice_of(const std::string& text);
std::string word(const RelaxationChoice& choice);
inline constexpr const char* relaxation_words = "1, 2, 3 or auto (as many terms of a Prony series as AICc wants)";

// The best fit of a number of terms; 0 is the solid that knows no time.
struct RelaxationRung {
  int terms = 0;
  double objective = 0;  // as CurveMinimum has it
  std::optional<double> aicc = {};
  std::optional<double> r2 = {};
};

// What a datum was measured in, and the model there.
struct FittedHistory {
  History history;
  std::string name;           // "test 2 (muscle.csv)"
  std::vector<double> model;  // Pa, nominal, one for each of its rows
};

struct RelaxationFit {
  RelaxationChoice choice = {};
  std::vector<RelaxationRung> rungs = {};             // from 0 terms up, all that were fitted
  int terms = 0;                                      // chosen
  std::vector<RelaxationMinimum> minima = {};         // of that number, best first; empty for 0 terms
  std::vector<ParameterUncertainty> parameters = {};  // "mu_0", "mu_inf" in Pa, "alpha", "g_1", .., "tau_1" in s
  std::vector<Region> regions = {};                   // of each parameter, over all minima
  double level = 0.95;
  ErrorSource errors = ErrorSource::residuals;
  double scatter = 0;  // standard deviation of the residuals: dimensionless or Pa
  int degrees_of_freedom = 0;
  std::optional<double> neighbour_correlation = {};
  TimeScales scales = {};
  std::vector<FittedHistory> histories = {};
  std::vector<std::string> findings = {};
};

// `rate_blind` is fit_curves of the same data. Every point needs a time. Throws BadInput for a robust loss, free signs, rows without
// times, and fewer points than parameters.
RelaxationFit fit_relaxation(const CurveData& data, const CurveFit& rate_blind, const RelaxationChoice& choice,
                             const std::optional<UncertaintyOptions>& intervals);

// What the numbers alone do not say: a time that the rows are too far apart or too few for, terms that are not needed, a long-term
// modulus of nothing.
std::vector<std::string> relaxation_findings(const RelaxationFit& fit);

}  // namespace percal
