// A curve in a CSV file -> the modulus and exponent of an Ogden solid, with intervals.        fit FILE.csv
#include <cstdio>
#include <exception>
#include <percal/fit.hpp>

int main(int argc, char** argv) try {
  if (argc != 2) return std::fprintf(stderr, "usage: fit FILE.csv\n"), 2;

  // Columns are found by their names, units by their headers; the mode is for files that don't say it themselves.
  const percal::CurveData data = percal::read_curves({argv[1]}, {.mode = "uniaxial"});

  // Every minimum, best first: curves of soft solids often have a second one with an alpha of the other sign.
  const percal::CurveFit fit = percal::fit_curves(data, {.model = percal::Model::ogden});
  if (fit.minima.empty()) return std::puts("nothing fits"), 3;
  for (const percal::CurveMinimum& minimum : fit.minima)
    std::printf("mu %.5g Pa, alpha %.4g, R2 %.4f\n", percal::small_strain_modulus(minimum.solid),
                minimum.solid.terms[0].alpha, minimum.r2.value_or(0));

  // How well the points determine them: profile likelihood about the best minimum.
  const percal::Uncertainty sure = percal::uncertainty_of(data, fit, {.level = 0.95});
  if (!sure.minima.empty())
    for (const percal::ParameterUncertainty& parameter : sure.minima[0].parameters)
      std::printf("%s: %.4g to %.4g %s\n", parameter.name.c_str(), parameter.interval.low, parameter.interval.high,
                  parameter.unit.c_str());

  // The solid answers for stretches that nobody measured.
  const percal::Strained stretched{percal::Deformation::equibiaxial, 1.2};
  std::printf("equibiaxial, stretch 1.2: %.4g Pa nominal\n", percal::nominal_stress(fit.minima[0].solid, stretched));
} catch (const std::exception& error) {  // BadInput: file, line, what was found and what is accepted
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
