// The stress of a solid that relaxes, over whole histories of stretch: hereditary integrals, row by row.   docs/theory/relaxation.md
#pragma once
#include <Eigen/Core>
#include <vector>

#include "percal/fit/relaxation/histories.hpp"
#include "percal/material/isochoric.hpp"
#include "percal/material/prony.hpp"

namespace percal {

// A hyperelastic solid at once, less what its series has let go since.
struct RelaxingSolid {
  Hyperelastic instantaneous;
  PronySeries series = {};
};

// What of the data the stress depends on: one state for each row, and the time since the row before it (since rest, of a first one).
struct RelaxingRow {
  IsochoricState state;
  double elapsed;  // s
  bool first;      // of its history
};
std::vector<RelaxingRow> relaxing_rows(const CurveData& data, const std::vector<History>& histories);

// Nominal stresses of a term with mu = 1, a row for each row of the data: of the elastic solid, and convolved with exp(-t/tau) for each
// tau, a column each; with their derivatives.
struct UnitHistory {
  Eigen::VectorXd elastic, elastic_by_alpha;
  Eigen::MatrixXd convolved, convolved_by_alpha, convolved_by_log_time;
};
UnitHistory unit_history(const std::vector<RelaxingRow>& rows, double alpha, const std::vector<double>& times);

// Pa, one for each row.                                                                                    (1)
Eigen::VectorXd relaxing_stress(const std::vector<RelaxingRow>& rows, const RelaxingSolid& solid);

}  // namespace percal
