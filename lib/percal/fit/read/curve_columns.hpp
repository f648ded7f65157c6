// Which columns of a table hold the curve, and what they mean.
#pragma once
#include <optional>
#include <string>

#include "percal/fit/read/curve_measures.hpp"
#include "percal/fit/read/read_curves.hpp"

namespace percal {

struct FoundColumns {
  int x;
  int y;
  AbscissaWords x_words;
  StressWords y_words;
  Dimension x_dimension = dimension::none, y_dimension = dimension::pressure;
  double x_over = 1,
         y_over = 1;  // what the numbers are divided by: the gauge length, 100 for percent; the cross-section
  std::optional<int> mode = {};   // the column of the deformation's word
  std::optional<int> error = {};  // the column of the standard errors of y
};

// The columns the user named, or else those whose names say it: x with stretch, strain, gamma, lambda or shear; y with
// stress, sigma, cauchy, piola, kirchhoff, pk1 or pk2; with a gauge length x is a displacement, with a cross-section y
// is a force. The standard errors are in a column with sem, se, sd, std, err, error or uncertainty among
// its words and a unit of y's kind: the one that begins as y does where there are several, none where that does not
// decide. Throws BadInput that lists the columns there are, and as stress_words and abscissa_words do.
FoundColumns find_columns(const CsvTable& table, const CurveColumns& wanted);

// For general biaxial data: the column of the other stretch of a pair (stretch_y for stretch_x, lambda_2 for lambda_1).
int partner_column(const CsvTable& table, int x);

// Stretch or gamma of a number of column x. Throws std::invalid_argument that says what does not fit (a stretch of 0,
// gamma in a tension test, a stretch in simple shear).
double amount_of(double value, Abscissa abscissa, Deformation deformation);

}  // namespace percal
