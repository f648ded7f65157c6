// The words by which headers name the measure of a stress or a strain.                        docs/formats/csv.md
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "percal/fit/points/curve_data.hpp"
#include "percal/text/csv.hpp"

namespace percal {

// What the abscissa counts. `stretch_or_gamma`: gamma in simple shear, the stretch in every other deformation.
enum class Abscissa {
  stretch,
  engineering_strain,
  true_strain,
  green_lagrange_strain,
  almansi_strain,
  gamma,
  stretch_or_gamma
};

struct StressWords {
  StressMeasure measure;  // nominal where no word says another
  bool compressive;       // a word says that compression is measured
};

struct AbscissaWords {
  Abscissa abscissa;
  double size;  // what 1 of the column's numbers means: 0.01 for percent
  bool compressive;
};

// The meaning of a header, word by word. Throws BadInput that names a word which is not known, two measures that contradict each
// other, a unit that measures no strain.
StressWords stress_words(const CsvTable& table, int column);
AbscissaWords abscissa_words(const CsvTable& table, int column);

// Whether a word of the header says that compression is measured, and none tension.
bool says_compressive(const CsvColumn& column);

// "strainPercent", "Second Piola-Kirchhoff" -> the words in small letters.
std::vector<std::string> words_of_header(const std::string& name);

// Every phrase with the measure it means, as the messages list them and the docs have them.
std::vector<std::pair<std::string, std::string>> stress_phrases();
std::vector<std::pair<std::string, std::string>> strain_phrases();

// "nominal", "cauchy", "second Piola-Kirchhoff", "biot".
std::string word(StressMeasure measure);

// Pa of nominal stress.                                                         docs/theory/curves.md (10a)
// Throws std::invalid_argument in simple shear for measures of which one shear component does not tell the nominal one.
double nominal_of(double stress, StressMeasure measure, const Strained& strained);

}  // namespace percal
