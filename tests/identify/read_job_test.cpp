// Jobs that cannot be run: refused on reading, with the place, what was found and what is accepted.
#include <gmock/gmock.h>

#include "acceptance/liver.hpp"
#include "percal/identify/job.hpp"

namespace percal {
namespace {

using acceptance::LiverJob;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

struct BadJob {
  std::string name;
  std::vector<std::pair<std::string, std::string>> replacements;
  std::string place;     // a regular expression: file, line, key
  std::string found;     // part of what the message says was found
  std::string accepted;  // part of what it says is accepted
};
void PrintTo(const BadJob& job, std::ostream* out) { *out << job.name; }

const std::string alpha_scan =
    "scan = [4, 5, 6]\n[alpha.target]\nfile = \"pairs.csv\"\nmu = \"mu\"\nerosion_strain = \"strain\"";
const std::string trend = "\n[[trends]]\nname = \"line\"\nfile = \"shots.csv\"\nx = \"speed\"\ny = \"depth\"\n";
const std::string scaled_line =
    "\n[scaled_line]\nname = \"line\"\n[scaled_line.shots]\nfile = \"lead.csv\"\ndensity = \"density\"\n"
    "diameter = \"diameter\"\nspeed = \"speed\"\npenetration = \"depth\"\n[scaled_line.cases]\nfile = \"shots.csv\"\n"
    "particle_density = \"7800 kg/m3\"\ndiameter_column = \"diameter\"\nspeed_column = \"speed\"\n";
const std::string equal_mass =
    "\n[equal_mass]\nmass = \"1 g\"\nspeed = \"40 m/s\"\n[[equal_mass.shapes]]\nname = \"cube\"\n";
const std::string at_end = "material = \"tissue\"";  // in the last block

class ReadBadJob : public LiverJob, public testing::WithParamInterface<BadJob> {
 protected:
  ReadBadJob() {
    write("pairs.csv", "mu_MPa,strain,model_kPa,shape\n12,0.6,300,a\n6,1.0,150,b\n");
    write("bad_pairs.csv", "mu_MPa,strain\n12,0.6\n-6,1.0\n");
    write("one.csv", "agar_wtpct,modulus_kPa,depth_mm\n2,31.8,28\n2,32.0,27\n");
    write("negative.csv", "agar_wtpct,modulus_kPa,depth_mm\n2,31.8,28\n3,72,-17\n");
    write("no_unit.csv", "agar_wtpct,modulus,depth_mm\n2,31.8,28\n3,72,17\n");
    write("furlongs.csv", "speed [m/s],depth [furlong]\n20,1\n30,2\n");
    write("lead.csv", "density_kg/m3,diameter_mm,speed_m/s,depth_mm\n11300,3,50,30\n11300,3,50,31\n");
    write("empty.csv", "agar_wtpct,modulus_kPa,depth_mm\n# nothing\n");
  }
};

TEST_P(ReadBadJob, IsRefusedWithPlaceFindingAndRemedy) {
  const BadJob& bad = GetParam();
  try {
    read_identify_job(job(bad.replacements));
    FAIL() << "read as if nothing were wrong";
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), AllOf(ContainsRegex(bad.place), HasSubstr(bad.found), HasSubstr(bad.accepted)));
    EXPECT_THAT(error.what(), testing::Not(HasSubstr("power law")));
  }
}

const std::vector<BadJob> bad_jobs{
    {"UnknownKey",
     {{"speed = \"120", "sped = \"1 m/s\"\nspeed = \"120"}},
     "liver.toml:31: calibration.sped: found",
     "unknown key (did you mean speed?)",
     "accepted: particle, radius, diameter"},
    {"UnknownBlock",
     {{"[ridge]", "[rigde]\nx = 1\n[ridge]"}},
     "liver.toml:[0-9]+: rigde: found",
     "did you mean ridge?",
     "model_check"},
    {"UnknownKeyInAPrediction",
     {{"particle_column = \"ball\"", "particle_column = \"ball\"\nseed = 3"}},
     "liver.toml:[0-9]+: predictions.1..seed: found",
     "an unknown key",
     "speed_column"},
    {"MissingUnit",
     {{"\"20 um\"", "20"}},
     "liver.toml:29: calibration.radius: found 20 without a unit",
     "20",
     "a positive length with its unit"},
    {"WrongUnit",
     {{"\"20 um\"", "\"20 kPa\""}},
     "liver.toml:29: calibration.radius: found",
     "\"20 kPa\", a pressure",
     "a positive length"},
    {"UnknownUnit", {{"\"20 um\"", "\"20 smoots\""}}, "liver.toml:29: calibration.radius: found", "smoots", "um"},
    {"NegativeRadius",
     {{"\"20 um\"", "\"-20 um\""}},
     "liver.toml:29: calibration.radius: found",
     "\"-20 um\"",
     "a positive length"},
    {"ZeroSpeed",
     {{"\"120 m/s\"", "\"0 m/s\""}},
     "liver.toml:31: calibration.speed: found",
     "\"0 m/s\"",
     "a positive speed"},
    {"MissingKey",
     {{"density = \"15600 kg/m3\"", ""}},
     "liver.toml:27: calibration.density: found",
     "no such key",
     "a positive density"},
    {"MissingBlock", {{"[tissue]", "[tissues]"}}, "liver.toml: tissue: found", "line 22 has \"tissues\"", "[tissue]"},
    {"PoissonRatioOfOneHalf",
     {{"bulk_to_shear = 40\n\n[alpha]", "nu = 0.5\n\n[alpha]"}},
     "liver.toml:[0-9]+: solver.nu: found 0.5",
     "0.5",
     "a number between -1 and 0.5, both excluded"},
    {"PoissonRatioBesideBulkModulus",
     {{"bulk_to_shear = 40\n\n[alpha]", "nu = 0.49\nbulk_to_shear = 40\n\n[alpha]"}},
     "liver.toml:[0-9]+: solver.bulk_to_shear: found",
     "beside nu",
     "one of the two"},
    {"PoissonRatioOfAPrediction",
     {{at_end, at_end + "\nnu = 0.7"}, {"bulk_to_shear = 40\nelements", "elements"}},
     "liver.toml:[0-9]+: predictions.2..nu: found 0.7",
     "0.7",
     "between -1 and 0.5"},
    {"NoRowAfterWhere", {{"agar=2", "agar=7"}}, "shots.csv: agar: found", "no row with \"7\"", "\"2\", \"0\""},
    {"WhereWithoutSuchAColumn", {{"agar=2", "gelatine=2"}}, "shots.csv", "gelatine", "agar"},
    {"WhereThatIsNoCondition", {{"agar=2", "agar"}}, "shots.csv: found", "\"agar\"", "COLUMN=VALUE"},
    {"NoMeasuredRow",
     {{"tested=yes", "tested=maybe"}},
     "agar.csv: tested: found",
     "no row with \"maybe\"",
     "\"yes\", \"no\""},
    {"NoSuchColumn",
     {{"\"depth\"\npenetration_sd", "\"deep\"\npenetration_sd"}},
     "liver.toml:[0-9]+: gelatin.formulations.penetration: found \"deep\"",
     "deep",
     "a column of "},
    {"NoSuchColumnOfShots",
     {{"speed_column = \"speed\"", "speed_column = \"pace\""}},
     "liver.toml:[0-9]+: predictions.1..speed_column: found \"pace\"",
     "pace",
     "a column of "},
    {"ColumnWithoutUnit",
     {{"agar.csv", "no_unit.csv"}},
     "no_unit.csv:1: modulus: found",
     "a column without a unit",
     "kPa"},
    {"ColumnOfAnotherDimension",
     {{"mu_quasi_static = \"modulus\"", "mu_quasi_static = \"depth\""}},
     "agar.csv:2: depth_mm: found",
     "the unit mm",
     "Pa, kPa"},
    {"NegativeNumberInATable",
     {{"agar.csv", "negative.csv"}, {"penetration_sd = \"depth_sd\"\nlaw_rows = \"tested=yes\"", ""}},
     "negative.csv:3: depth_mm: found -17",
     "-17",
     "a positive number"},
    {"TableWithoutRows", {{"agar.csv", "empty.csv"}}, "empty.csv", "a header without rows", "at least one row"},
    {"TableThatIsNotThere", {{"agar.csv", "agra.csv"}}, "agra.csv", "there is no such file", ""},
    {"OneConcentrationForTheLaw",
     {{"agar.csv", "one.csv"}, {"penetration_sd = \"depth_sd\"\nlaw_rows = \"tested=yes\"", ""}},
     "liver.toml:[0-9]+: gelatin.formulations.concentration: found",
     "one concentration",
     "gelatin.exponent"},
    {"AlphaNeitherGivenNorScanned",
     {{"value = 5", ""}},
     "liver.toml:[0-9]+: alpha.value: found",
     "neither value nor scan",
     "scan = [NUMBER, ...]"},
    {"AlphaBothGivenAndScanned",
     {{"value = 5", "value = 5\n" + alpha_scan}},
     "liver.toml:[0-9]+: alpha.value: found",
     "both value and scan",
     "one of them"},
    {"AlphaOfZero",
     {{"value = 5", "value = 0"}},
     "liver.toml:[0-9]+: alpha.value: found 0",
     "0",
     "at least 0.001 in size"},
    {"ScanThroughZero",
     {{"value = 5", alpha_scan}, {"[4, 5, 6]", "[-4, 0, 4]"}},
     "liver.toml:[0-9]+: alpha.scan: found 0",
     "0",
     "at least 0.001 in size"},
    {"ScanOfBothSigns",
     {{"value = 5", alpha_scan}, {"[4, 5, 6]", "[-4, 4]"}},
     "liver.toml:[0-9]+: alpha.scan: found",
     "both signs",
     "of one sign"},
    {"ScanOfOneExponent",
     {{"value = 5", alpha_scan}, {"[4, 5, 6]", "[4, 4]"}},
     "liver.toml:[0-9]+: alpha.scan: found",
     "one exponent",
     "two or more"},
    {"ScanWithoutTarget",
     {{"value = 5", "scan = [4, 5, 6]"}},
     "liver.toml:[0-9]+: alpha.target: found",
     "no such key",
     "[alpha.target]"},
    {"NegativeModulusInTheTarget",
     {{"value = 5", alpha_scan}, {"pairs.csv", "bad_pairs.csv"}},
     "bad_pairs.csv:3: mu_MPa: found -6",
     "-6",
     "a positive number"},
    {"NegativeAlphaBesideMuOverAlpha",
     {{"modulus = \"true\"", "modulus = \"mu/alpha\""}, {"value = 5", "value = -5"}},
     "liver.toml:[0-9]+: alpha.value: found",
     "mu/alpha",
     "convention.modulus = \"true\""},
    {"UnknownConvention",
     {{"modulus = \"true\"", "modulus = \"MU1\""}},
     "liver.toml:6: convention.modulus: found \"MU1\"",
     "MU1",
     "\"true\", \"mu/alpha\""},
    {"OneErosionStrain",
     {{"[0.3, 0.6, 0.8]", "[0.6]"}},
     "liver.toml:[0-9]+: ridge.erosion_strains: found",
     "one strain",
     "two or more"},
    {"OneErosionStrainTwice",
     {{"[0.3, 0.6, 0.8]", "[0.6, 0.6]"}},
     "liver.toml:[0-9]+: ridge.erosion_strains: found",
     "one strain",
     "two or more"},
    {"NegativeErosionStrain",
     {{"[0.3, 0.6, 0.8]", "[0.3, -0.6]"}},
     "liver.toml:[0-9]+: ridge.erosion_strains.2.: found -0.6",
     "-0.6",
     "a positive strain"},
    {"NegativeStart",
     {{"\"5 MPa\"", "\"-5 MPa\""}},
     "liver.toml:[0-9]+: ridge.start: found",
     "-5 MPa",
     "a positive pressure"},
    {"NoElements",
     {{"elements_per_radius = 4", "elements_per_radius = 0"}},
     "liver.toml:[0-9]+: ridge.elements_per_radius: found 0",
     "0",
     "a number from 1"},
    {"TrendThroughOnePoint",
     {{"[ridge]", trend + "where = [\"agar=0\"]\n\n[ridge]"}},
     "liver.toml:[0-9]+: trends.1..x: found",
     "rows that are all at one place",
     "for a straight line"},
    {"TrendInAnUnknownUnit",
     {{"[ridge]", trend + "\n[ridge]"}, {"\"shots.csv\"\nx", "\"furlongs.csv\"\nx"}},
     "furlongs.csv:1: depth .furlong.: found",
     "furlong",
     "a unit"},
    {"ScaledLineThroughOnePoint",
     {{"[ridge]", scaled_line + "\n[ridge]"}},
     "liver.toml:[0-9]+: scaled_line.shots.file: found",
     "rows that are all at one place",
     "for a straight line"},
    {"ShapeWithoutItsTrend",
     {{"[ridge]", trend + equal_mass + "trend = \"lime\"\nreference = \"2 cm\"\n\n[ridge]"}},
     "liver.toml:[0-9]+: equal_mass.shapes.1..trend: found \"lime\"",
     "lime",
     "[[trends]]"},
    {"ShapeWithoutAnyLine",
     {{"[ridge]", equal_mass + "reference = \"2 cm\"\n\n[ridge]"}},
     "liver.toml:[0-9]+: equal_mass.shapes.1..trend: found nothing",
     "nothing",
     "[scaled_line]"},
    {"CardInAnotherFolder",
     {{"[ridge]", "[card]\nname = \"../skin\"\n[ridge]"}},
     "liver.toml:[0-9]+: card: found",
     "../skin",
     "a name that files may have"},
    {"UnknownReference",
     {{"[ridge]", "[reference]\nmodel_densty = \"464 kg/m3\"\n[ridge]"}},
     "liver.toml:[0-9]+: reference.model_densty: found",
     "did you mean model_density?",
     ""},
    {"MalformedToml", {{"[tissue]", "[tissue"}}, "liver.toml:[0-9]+: not valid TOML", "", ""},
};
INSTANTIATE_TEST_SUITE_P(Jobs, ReadBadJob, testing::ValuesIn(bad_jobs),
                         [](const auto& info) { return info.param.name; });

TEST_F(LiverJob, IsReadAsItStands) {
  const IdentifyJob read = read_identify_job(job());
  EXPECT_EQ(read.convention, ModulusConvention::true_shear);
  EXPECT_EQ(read.measure, StrainMeasure::true_strain);
  ASSERT_EQ(read.gelatin.formulations.size(), 4u);
  EXPECT_FALSE(read.gelatin.exponent);
  EXPECT_DOUBLE_EQ(read.gelatin.formulations[1].mu_quasi_static, 31.8e3);
  EXPECT_DOUBLE_EQ(*read.gelatin.formulations[1].penetration_sd, 1.2e-3);
  EXPECT_TRUE(read.gelatin.formulations[2].measured);
  EXPECT_FALSE(read.gelatin.formulations[3].measured);
  EXPECT_FALSE(read.gelatin.formulations[0].mu_high_rate);
  EXPECT_DOUBLE_EQ(read.calibration.radius, 20e-6);
  EXPECT_EQ(read.layer.bottom, Bottom::fixed);
  EXPECT_EQ(std::get<BulkToShear>(read.volumetric).ratio, 40);
  EXPECT_EQ(std::get<AlphaGiven>(read.alpha).alpha, 5);
  ASSERT_EQ(read.predictions.size(), 3u) << "one block names two densities";
  EXPECT_TRUE(std::holds_alternative<IdentifiedModel>(read.predictions[0].material));
  EXPECT_TRUE(std::holds_alternative<ChooseBulk>(read.predictions[0].volumetric)) << "left out: chosen";
  EXPECT_DOUBLE_EQ(read.predictions[0].shots.at(1).measured.value(), 21.5e-3) << "a decimal comma";
  EXPECT_DOUBLE_EQ(read.predictions[2].target_density, 1000);
  EXPECT_EQ(read.card_name, "liver") << "left out: the tissue's name";
  EXPECT_TRUE(read.reference.empty());
}

TEST(SkinJob, IsReadAsItStands) {
  const IdentifyJob read = read_identify_job(test::guha2009 + "skin.toml");
  EXPECT_EQ(read.convention, ModulusConvention::mu_over_alpha);
  EXPECT_EQ(std::get<AlphaScan>(read.alpha).target.size(), 6u);
  EXPECT_EQ(read.ridge.erosion_strains.size(), 6u);
  EXPECT_DOUBLE_EQ(read.layer.depth, 75);
  EXPECT_EQ(read.predictions.size(), 5u) << "gelatin at two densities";
  EXPECT_DOUBLE_EQ(read.reference.at("model_penetration"), 0.0413);
}

}  // namespace
}  // namespace percal
