// Which columns of a table hold the curve, and what they mean.
#pragma once
#include <optional>
#include <string>

#include "percal/fit/read_curves.hpp"

namespace percal {

// What the abscissa counts. `stretch_or_gamma`: gamma in simple shear, the stretch in every other deformation.
enum class Abscissa { stretch, engineering_strain, true_strain, green_lagrange_strain, gamma, stretch_or_gamma };

struct FoundColumns {
  int x;
  int y;
  Abscissa abscissa;
  bool cauchy;               // y is a Cauchy stress
  std::optional<int> mode;   // the column of the deformation's word
  std::optional<int> error;  // the column of the standard errors of y
};

// The columns the user named, or else those whose names say it: x with stretch, strain, gamma, lambda or shear; y with
// stress, sigma or cauchy. The standard errors are in a column with sem, se, sd, std, err, error or uncertainty among
// its words and a pressure as its unit: the one that begins as y does where there are several, none where that does not
// decide. Throws BadInput that lists the columns there are.
FoundColumns find_columns(const CsvTable& table, const CurveColumns& wanted);

// For general biaxial data: the column of the other stretch of a pair (stretch_y for stretch_x, lambda_2 for lambda_1).
int partner_column(const CsvTable& table, int x);

// Stretch or gamma of a number of column x. Throws std::invalid_argument that says what does not fit (a stretch of 0,
// gamma in a tension test, a stretch in simple shear).
double amount_of(double value, Abscissa abscissa, Deformation deformation);

}  // namespace percal
