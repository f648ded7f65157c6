// Points of stress-stretch curves, in SI, whatever files they came from.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/material/homogeneous.hpp"

namespace percal {

// Which stress a column holds: first Piola, Cauchy (Kirchhoff: the same at constant volume), second Piola-Kirchhoff, Biot (nominal but in
// simple shear).
enum class StressMeasure { nominal, cauchy, second_piola, biot };

struct StressPoint {
  Strained strained;
  double nominal_stress;                      // Pa; the shear stress in simple shear
  std::optional<double> standard_error = {};  // Pa, of nominal_stress
  int source = 0;                             // index of its CurveSource
  int rows = 1;                               // of the file that it is the mean of: see thin_curves.hpp
};

// Where points came from: which columns of which file.
struct CurveSource {
  std::string file;
  std::string x, y;                               // headers; x of general biaxial data are the two stretches
  std::string error = {};                         // header of the standard errors of y; empty where there are none
  StressMeasure stress = StressMeasure::nominal;  // of y as the file has it; the points are nominal already
  bool mode_column = false;                       // the file says the deformation of every row itself
  int points = 0;                                 // rows of the file
  std::vector<std::string> warnings = {};  // sentences: what in the file contradicts itself, what was done about it
};

struct CurveData {
  std::vector<StressPoint> points;
  std::vector<CurveSource> sources;
};

}  // namespace percal
