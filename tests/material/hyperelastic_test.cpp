#include "percal/material/hyperelastic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "material/solids.hpp"

namespace percal {
namespace {

using test::all_deformations;
using test::mooney_rivlin;
TEST(Hyperelastic, MooneyRivlinHasItsTextbookStresses) {
  const double c10 = 3, c01 = 0.7;
  const Hyperelastic solid = mooney_rivlin(c10, c01);
  for (const double l : {0.4, 0.9, 1.1, 2.5}) {
    const auto meets = [&](const Strained& strained, double exact) {
      EXPECT_NEAR(nominal_stress(solid, strained), exact, 1e-13 * (std::abs(exact) + 1)) << word(strained.deformation);
    };
    meets({Deformation::uniaxial, l}, 2 * (l - 1 / (l * l)) * (c10 + c01 / l));
    meets({Deformation::equibiaxial, l}, 2 * (l - std::pow(l, -5)) * (c10 + c01 * l * l));
    meets({Deformation::planar, l}, 2 * (l - std::pow(l, -3)) * (c10 + c01));
    meets({Deformation::planar_held, l}, 2 * (1 - 1 / (l * l)) * (c10 + c01 * l * l));
    meets({Deformation::simple_shear, l}, 2 * (c10 + c01) * l);
  }
}

TEST(Hyperelastic, OneTermMeetsTheExactTable) {
  std::ifstream file(PERCAL_DATA "/verification/ogden_homogeneous_stress.csv");
  std::string line;
  int rows = 0;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#' || line[0] == 'a') continue;
    std::istringstream cells(line);
    double v[8];
    char comma;
    for (double& value : v) cells >> value >> comma;
    const Deformation columns[] = {Deformation::uniaxial, Deformation::equibiaxial, Deformation::planar,
                                   Deformation::planar_held};
    for (int c = 0; c < 4; ++c) {
      const PrincipalPair pair = principal_pair({columns[c], v[1]});
      EXPECT_NEAR(nominal_stress(Hyperelastic{{{1, v[0]}}}, pair), v[2 + c], 1e-10 * std::abs(v[2 + c])) << line;
      EXPECT_NEAR(unit_term(v[0], pair).stress, v[2 + c], 1e-10 * std::abs(v[2 + c])) << line;
    }
    ++rows;
  }
  EXPECT_GE(rows, 150);
}

TEST(Hyperelastic, TheDerivativeByAlphaMeetsDifferencesAlsoWhereTheSeriesIsUsed) {
  for (const auto deformation : all_deformations)
    for (const double alpha : {-25.0, -3.0, -1e-7, 0.0, 0.4, 2.0, 11.0, 39.0})
      for (const double amount : {0.5, 0.999, 1.02, 1.6, 4.0}) {
        const PrincipalPair pair = principal_pair({deformation, amount, 1.1});
        const double h = 1e-4;
        const double difference = (unit_term(alpha + h, pair).stress - unit_term(alpha - h, pair).stress) / (2 * h);
        const UnitTerm unit = unit_term(alpha, pair);
        EXPECT_NEAR(unit.by_alpha, difference, 1e-6 * std::abs(difference) + 1e-10 * std::abs(unit.stress))
            << word(deformation) << ' ' << alpha << ' ' << amount;
      }
}

TEST(Hyperelastic, TheSmallStrainModulusIsTheSumOfAll) {
  const Hyperelastic solid{{{5, 3.1}, {-1.5, -2.2}, {0.25, 11}}};
  EXPECT_DOUBLE_EQ(small_strain_modulus(solid), 3.75);
  EXPECT_NEAR(nominal_stress(solid, Strained{Deformation::simple_shear, 1e-6}), 3.75e-6, 1e-15);
}

TEST(Hyperelastic, ModelsHaveTheirParametersAndWords) {
  const std::pair<Model, int> parameters[] = {
      {Model::neo_hooke, 1}, {Model::mooney_rivlin, 2}, {Model::ogden, 2}, {Model::ogden2, 4}, {Model::ogden3, 6}};
  for (const auto& [model, count] : parameters) {
    EXPECT_EQ(parameters_of(model), count);
    EXPECT_EQ(model_of(word(model)), model);
  }
  EXPECT_EQ(model_of("yeoh"), std::nullopt);
}

}  // namespace
}  // namespace percal
