// Points of stress-stretch curves, in SI, whatever files they came from.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/fit/points/specimen.hpp"
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
  std::optional<double> time = {};            // s; read where relaxation is fitted
};

// Where the stress of a curve is largest, and what becomes of it behind.
struct CurvePeak {
  enum class End { none, held, falls };  // nothing to speak of; relaxation at a held stretch; a falling branch
  std::string test;                      // "uniaxial tension", with its number where there are several
  double amount, stress;                 // stretch or gamma; Pa, nominal
  double erosion_strain;                 // the largest principal stretch there, less 1
  double fallen_to;                      // share of the stress that is left at the end
  End end;
  int rows_behind;
};

// A stress that relaxes while the stretch is held.
struct CurveHold {
  std::string test;
  double amount, stress_before, stress_after;  // stretch or gamma; Pa, nominal
  int rows;                                    // left out
};

// Where points came from: which columns of which file.
struct CurveSource {
  std::string file;
  std::string x, y;                               // headers; x of general biaxial data are the two stretches
  std::string error = {};                         // header of the standard errors of y; empty where there are none
  StressMeasure stress = StressMeasure::nominal;  // of y as the file has it; the points are nominal already
  bool mode_column = false;                       // the file says the deformation of every row itself
  int points = 0;                                 // rows of the file that were taken
  Specimen specimen = {};                  // of force and displacement; nothing where the file has stress and stretch
  std::vector<CurvePeak> peaks = {};       // that the curves were taken up to
  std::vector<CurveHold> holds = {};       // that were left out
  std::vector<std::string> taken = {};     // sentences: what was made of the file as the user asked
  std::vector<std::string> warnings = {};  // sentences: what in the file contradicts itself, what was done about it
};

struct CurveData {
  std::vector<StressPoint> points;
  std::vector<CurveSource> sources;
};

}  // namespace percal
