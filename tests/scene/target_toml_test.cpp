// Erosion, relaxation, further layers and solver choices: what is read and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "percal/scene/scene_toml.hpp"
#include "scene/refusal.hpp"

namespace percal {
namespace {

using test::refusal;
using testing::AllOf;
using testing::HasSubstr;

const std::string base =
    "[particle]\nradius = \"1 mm\"\ndensity = \"7 t/m3\"\nspeed = \"50 m/s\"\n"
    "[target]\ndensity = \"1 t/m3\"\nmu = \"1 MPa\"\nalpha = 9\ndepth = \"75 mm\"\nwidth = \"12 mm\"\n";
const std::string layer = "[[below]]\ndensity = \"1.1 t/m3\"\nmu = \"2 MPa\"\nalpha = 3\ndepth = \"10 mm\"\n";

Scene with(const std::string& lines) { return parse_scene(base + lines, "scene.toml"); }

std::string refusal_with(const std::string& lines) { return refusal(base + lines); }

TEST(TargetToml, ErosionIsByStrainStressOrEnergy) {
  EXPECT_EQ(with("[target.erosion]\nstrain = 0.7\n").target.erosion, Erosion(StrainErosion{0.7}));
  EXPECT_EQ(with("[target.erosion]\nstress = \"1 MPa\"\n").target.erosion, Erosion(StressErosion{1e6}));
  EXPECT_EQ(with("[target.erosion]\nenergy = \"100 kJ/m^3\"\n").target.erosion, Erosion(EnergyErosion{1e5}));
  EXPECT_EQ(with("[target.erosion]\nenergy = \"100 kPa\"\n").target.erosion, Erosion(EnergyErosion{1e5}));
}

TEST(TargetToml, SeveralCriteriaAreTheFirstOfThemAndFurtherOnes) {
  const Scene all = with("[target.erosion]\nenergy = \"1 kPa\"\nstress = \"1 MPa\"\nstrain = 0.7\n" + layer +
                         "[below.erosion]\nenergy = \"2 kPa\"\n" + layer + "[below.erosion]\nstrain = 0.4\nstress = \"3 MPa\"\n");
  EXPECT_EQ(all.target.erosion, Erosion(StrainErosion{0.7}));
  EXPECT_EQ(all.target.further_erosion, (FurtherErosion{1e6, 1e3}));
  EXPECT_FALSE(all.below[0].erosion_limit);
  EXPECT_EQ(all.below[0].further_erosion, (FurtherErosion{std::nullopt, 2e3}));
  EXPECT_EQ(all.below[1].erosion_limit, 0.4);
  EXPECT_EQ(all.below[1].further_erosion, (FurtherErosion{3e6, std::nullopt}));
  const Scene two = with("[target.erosion]\nenergy = \"1 kPa\"\nstress = \"1 MPa\"\n");
  EXPECT_EQ(two.target.erosion, Erosion(StressErosion{1e6}));
  EXPECT_EQ(two.target.further_erosion, (FurtherErosion{std::nullopt, 1e3}));
  for (const Scene& scene : {all, two}) EXPECT_EQ(parse_scene(scene_to_toml(scene, ""), scene.source), scene);
  EXPECT_THAT(refusal_with("[target.erosion]\nstrain = 0.7\nenergy = \"1 kPa\"\nlength_in_radii = 0.4\n"),
              HasSubstr("target.erosion.length_in_radii: found this beside strain and energy"));
  EXPECT_THAT(refusal_with("[target.erosion]\nstrain = 0.7\nenergy = \"1 kPa\"\n" + layer + "[below.erosion]\nstress = \"1 Pa\"\n"),
              HasSubstr("found this; accepted: strain or energy, the criteria of [target.erosion]"));
}

TEST(TargetToml, ALimitOfStrainMayHangOnTheParticlesSizeAgainstACells) {
  const std::string cell = "strain_below = 0.3\ncell = \"15 um\"\n";
  const Scene scene = with("[target.erosion]\nstrain = 0.7\n" + cell + layer + "[below.erosion]\nstrain = 0.4\n" + cell);
  EXPECT_EQ(scene.target.erosion, Erosion(StrainErosion{0.7}));
  EXPECT_EQ(scene.target.erosion_by_size, ErosionBySize(SmallerThanCell{15e-6, 0.3}));
  EXPECT_EQ(scene.below[0].erosion_by_size, scene.target.erosion_by_size);
  EXPECT_EQ(parse_scene(scene_to_toml(scene, ""), scene.source), scene);
  EXPECT_THAT(refusal_with("[target.erosion]\nstrain = 0.7\nstrain_below = 0.3\n"),
              HasSubstr("target.erosion.strain_below: found this without cell"));
  EXPECT_THAT(refusal_with("[target.erosion]\nstrain = 0.7\ncell = \"15 um\"\n"),
              HasSubstr("target.erosion.cell: found this without strain_below"));
  EXPECT_THAT(refusal_with("[target.erosion]\nstress = \"1 MPa\"\n" + cell), HasSubstr("strain_below only beside strain"));
  EXPECT_THAT(refusal_with("[target.erosion]\nstrain = 0.7\ncell = \"0 um\"\nstrain_below = 0.3\n"), HasSubstr("a positive length"));
}

TEST(TargetToml, EachLayerMayBeStretchedBeforeTheImpact) {
  const Scene scene = with("stretch = 1.1\n" + layer + "stretch = 1.2\n" + layer);
  EXPECT_EQ(scene.target.stretch, 1.1);
  EXPECT_EQ(scene.below[0].stretch, 1.2);
  EXPECT_EQ(scene.below[1].stretch, 1);
  EXPECT_EQ(parse_scene(scene_to_toml(scene, ""), scene.source), scene);
  EXPECT_THAT(refusal_with("stretch = 0\n"), HasSubstr("target.stretch: found 0; accepted: a stretch from 0.5 to 3"));
}

TEST(TargetToml, EachLayerMayHaveFibres) {
  const std::string table = "k1 = \"24 MPa\"\nk2 = 0.1\n";
  const Scene scene = with("[target.fibres]\n" + table + layer + "[below.fibres]\nkappa = 0.4\n" + table + layer);
  EXPECT_EQ(scene.target.fibres, Fibres(PlanarFibres{24e6, 0.1, 0.5}));
  EXPECT_EQ(scene.below[0].fibres, Fibres(PlanarFibres{24e6, 0.1, 0.4}));
  EXPECT_EQ(scene.below[1].fibres, Fibres(NoFibres{}));
  EXPECT_EQ(parse_scene(scene_to_toml(scene, ""), scene.source), scene);
  EXPECT_THAT(refusal_with("[target.fibres]\nk1 = \"1 MPa\"\n"), HasSubstr("target.fibres.k2: found no such key"));
  EXPECT_THAT(refusal_with("[target.fibres]\nkappa = 0.6\n" + table), HasSubstr("a number from 1/3"));
}

TEST(TargetToml, AtLeastOneCriterionIsGiven) {
  EXPECT_THAT(refusal_with("[target.erosion]\n"), HasSubstr("accepted: one or more of strain, stress and energy"));
  EXPECT_THAT(refusal_with("[target.erosion]\nstress = \"1 MPa\"\nmeasure = \"true\"\n"),
              HasSubstr("measure only beside strain"));
  EXPECT_THAT(refusal_with("[target.erosion]\nstress = \"0 MPa\"\n"), HasSubstr("a positive stress"));
  EXPECT_THAT(refusal_with("[target.erosion]\nenergy = \"1 J\"\n"), HasSubstr("a positive energy per volume"));
  EXPECT_THAT(refusal_with("[target.erosion]\nstress = 1\n"), HasSubstr("without a unit"));
}

TEST(TargetToml, ALengthOfErosionIsALengthOrANumberOfRadii) {
  const std::string erosion = "[target.erosion]\nstrain = 0.7\n";
  EXPECT_EQ(with(erosion).target.erosion_average, ErosionAverage(NoAverage{}));
  const Scene scene = with(erosion + "length = \"0.4 mm\"\n");
  EXPECT_EQ(scene.target.erosion_average, ErosionAverage(AverageWithin{4e-4}));
  EXPECT_EQ(with(erosion + "length_in_radii = 0.4\n").target.erosion_average, scene.target.erosion_average);
  EXPECT_EQ(with("[target.erosion]\nenergy = \"1 MPa\"\nlength_in_radii = 0.4\n").target.erosion_average,
            scene.target.erosion_average);
  EXPECT_EQ(parse_scene(scene_to_toml(scene, ""), "again").target, scene.target);
}

TEST(TargetToml, ALengthOfErosionIsRefusedTwiceBesideStressAndBelow) {
  const std::string erosion = "[target.erosion]\nstrain = 0.7\n";
  EXPECT_THAT(refusal_with(erosion + "length = \"0.4 mm\"\nlength_in_radii = 0.4\n"),
              HasSubstr("scene.toml:14: target.erosion.length_in_radii: found this beside length; accepted: one of"));
  EXPECT_THAT(refusal_with("[target.erosion]\nstress = \"1 MPa\"\nlength = \"0.4 mm\"\n"),
              HasSubstr("scene.toml:13: target.erosion.length: found this beside stress"));
  EXPECT_THAT(refusal_with(erosion + "length = 0.4\n"), HasSubstr("without a unit"));
  EXPECT_THAT(refusal_with(erosion + "length_in_radii = 0\n"), HasSubstr("a positive number of radii"));
  EXPECT_THAT(refusal_with(erosion + layer + "[below.erosion]\nstrain = 0.4\nlength = \"0.4 mm\"\n"),
              HasSubstr("below[1].erosion.length: found an unknown key"));
}

TEST(TargetToml, AMeshWithFewerThanThreeElementsInTheLengthIsRefused) {
  const std::string erosion = "[target.erosion]\nstrain = 0.7\nlength_in_radii = 0.3\n";
  EXPECT_EQ(refusal_with(erosion), "accepted") << "ten elements per radius: just three";
  EXPECT_THAT(refusal_with(erosion + "[mesh]\nelements_per_radius = 9\n"),
              AllOf(HasSubstr("scene.toml:13: target.erosion.length_in_radii: found 300 um (0.3 radii), 2.7 elements"),
                    HasSubstr("accepted: a length of three elements or more: 0.3333 radii, or "
                              "elements_per_radius = 10")));
}

TEST(TargetToml, RelaxationHasOneToThreeTermsThatLeaveSomeStiffness) {
  const auto term = [](const std::string& share, const std::string& time = "\"1 us\"") {
    return "[[target.relaxation]]\nshare = " + share + "\ntime = " + time + "\n";
  };
  EXPECT_EQ(with("").target.relaxation, Relaxation(NoRelaxation{}));
  EXPECT_EQ(with(term("0.3") + term("0.2", "\"2 ms\"")).target.relaxation,
            Relaxation(PronySeries{{{0.3, 1e-6}, {0.2, 2e-3}}}));
  EXPECT_THAT(refusal_with(term("0.5") + term("0.5")),
              AllOf(HasSubstr("target.relaxation[2].share"), HasSubstr("a sum below 1")));
  EXPECT_THAT(refusal_with(term("0.1") + term("0.1") + term("0.1") + term("0.1")), HasSubstr("4 terms"));
  for (const char* share : {"0", "1", "-0.1", "nan"})
    EXPECT_THAT(refusal_with(term(share)), HasSubstr("a number between 0 and 1")) << share;
  EXPECT_THAT(refusal_with(term("0.1", "\"0 s\"")), HasSubstr("a positive time"));
  EXPECT_THAT(refusal_with("[target.relaxation]\nshare = 0.1\n"), HasSubstr("tables: [[target.relaxation]]"));
}

TEST(TargetToml, LayersBelowHaveTheirOwnMaterialAndLimit) {
  const Scene scene = with("[target.erosion]\nstrain = 0.7\n" + layer + "name = \"dermis\"\nnu = 0.49\n" +
                           "[below.erosion]\nstrain = 0.4\n" + layer);
  ASSERT_EQ(scene.below.size(), 2u);
  EXPECT_EQ(scene.below[0], (LowerLayerScene{.name = "dermis",
                                             .density = 1100,
                                             .mu_as_given = 2e6,
                                             .alpha = 3,
                                             .volumetric = PoissonRatio{0.49},
                                             .depth = 0.01,
                                             .erosion_limit = 0.4}));
  EXPECT_EQ(scene.below[1].name, "layer");
  EXPECT_FALSE(scene.below[1].erosion_limit);
}

TEST(TargetToml, LayersBelowErodeByTheFirstOnesCriterion) {
  EXPECT_THAT(refusal_with(layer + "[below.erosion]\nstrain = 0.4\n"),
              AllOf(HasSubstr("below[1].erosion"), HasSubstr("found this where the first layer has none")));
  EXPECT_THAT(refusal_with("[target.erosion]\nstrain = 0.7\n" + layer + "[below.erosion]\nstress = \"1 MPa\"\n"),
              HasSubstr("below[1].erosion.stress: found this; accepted: strain, the criterion of [target.erosion]"));
  EXPECT_EQ(with("[target.erosion]\nenergy = \"7 kPa\"\n" + layer + "[below.erosion]\nenergy = \"1 kJ/m3\"\n")
                .below[0]
                .erosion_limit,
            1000);
}

TEST(TargetToml, AFirstLayerMayBeThinnerThanTheParticleButNotAllLayers) {
  std::string thin = base;
  thin.replace(thin.find("75 mm"), 5, "0.1 mm");
  EXPECT_THAT(refusal(thin), HasSubstr("a length above the particle's radius of 1 mm"));
  EXPECT_EQ(refusal(thin + layer), "accepted");
  std::string both_thin = thin + layer;
  both_thin.replace(both_thin.find("10 mm"), 5, "0.9 mm");
  EXPECT_THAT(refusal(both_thin), HasSubstr("target.depth: found 1 mm with the layers below"));
}

TEST(TargetToml, ALayerBelowIsCheckedLikeTheFirst) {
  for (const char* line : {"nu = 0.5", "nu = 0.4\nbulk_to_shear = 3", "width = \"1 mm\"", "convention = \"true\""})
    EXPECT_THAT(refusal_with(layer + line + "\n"), HasSubstr("below[1].")) << line;
  std::string wrong = layer;
  wrong.replace(wrong.find("alpha = 3"), 9, "alpha = 0");
  EXPECT_THAT(refusal_with(wrong), HasSubstr("below[1].alpha: found 0"));
  std::string negative = layer;
  negative.replace(negative.find("2 MPa"), 5, "-2 MPa");
  EXPECT_THAT(refusal_with(negative), HasSubstr("below[1].mu"));
}

TEST(SolverToml, EveryChoiceIsRead) {
  const SolverScene solver =
      with(
          "[solver]\nhourglass_form = \"viscosity\"\nvolumetric_law = \"logarithmic\"\neroded_nodes = \"in contact\"\n"
          "rates = 1\nstiffen_supersonic = true\n")
          .solver;
  SolverScene expected;
  expected.hourglass_form = HourglassForm::viscosity;
  expected.hourglass = usual_hourglass(HourglassForm::viscosity);
  expected.volumetric_law = VolumetricLaw::logarithmic;
  expected.eroded_nodes = ErodedNodes::in_contact;
  expected.rates = 1;
  expected.stiffen_supersonic = true;
  EXPECT_EQ(solver, expected);
  EXPECT_EQ(with("[solver]\nvolumetric_law = \"quadratic\"\n").solver.volumetric_law, VolumetricLaw::quadratic);
  for (const char* line : {"hourglass_form = \"none\"", "volumetric_law = \"cubic\"", "eroded_nodes = \"kept\"",
                           "rates = 0", "rates = 3", "stiffen_supersonic = 1"})
    EXPECT_THAT(refusal_with("[solver]\n" + std::string(line) + "\n"), HasSubstr("solver.")) << line;
}

}  // namespace
}  // namespace percal
