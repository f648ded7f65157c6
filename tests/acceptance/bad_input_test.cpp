// Input that cannot be used, through the program: exit code 2, one message on standard error, nothing on standard output,
// nothing written.
#include <gmock/gmock.h>

#include <algorithm>

#include "acceptance/liver.hpp"

namespace percal {
namespace {

using acceptance::LiverJob;
using test::Ended;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

struct BadCommand {
  std::string name;
  std::string command;         // words, without the program's
  std::string file, from, to;  // in this file, this text is replaced; an empty `from` adds to the end
  std::vector<std::string> says;
};
void PrintTo(const BadCommand& bad, std::ostream* out) { *out << bad.name; }

class BadInputTo : public LiverJob, public testing::WithParamInterface<BadCommand> {
 protected:
  BadInputTo() {
    job();
    write("layer.toml", text_of(test::test_data + "layer.toml"));
    write("curve.csv", "stretch,stress_kPa,mode\n1.1,10,UT\n1.2,21,UT\n1.5,60,UT\n");
    write("scale.toml",
          "[prototype]\nscene = \"layer.toml\"\n[model]\nradius = \"2 mm\"\nparticle_density = \"7800 kg/m3\"\nspeed = "
          "\"30 m/s\"\n");
    write("folder/file", "");
  }
};

TEST_P(BadInputTo, EndsWithExitCodeTwoAndOneClearMessage) {
  const BadCommand& bad = GetParam();
  if (!bad.file.empty()) {
    std::string text = read(bad.file);
    const auto at = bad.from.empty() ? text.size() : text.find(bad.from);
    ASSERT_NE(at, std::string::npos);
    write(bad.file, text.replace(at, bad.from.size(), bad.to));
  }
  const auto before = files();
  const Ended ended = run(test::words_of(bad.command));
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_THAT(ended.err, AllOf(StartsWith("percal: "), Not(HasSubstr("internal error"))));
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  for (const auto& text : bad.says) EXPECT_THAT(ended.err, HasSubstr(text));
  EXPECT_EQ(files(), before) << "something was written";
}

const std::vector<BadCommand> bad_commands{
    {"ImpactMalformed",
     "impact layer.toml --out out",
     "layer.toml",
     "[mesh]",
     "[mesh",
     {"layer.toml:", "not valid TOML"}},
    {"ImpactUnknownKey",
     "impact layer.toml --out out",
     "layer.toml",
     "alpha = 5",
     "alpha = 5\nconvektion = \"true\"",
     {"layer.toml:15: target.convektion", "did you mean convention?"}},
    {"ImpactMissingUnit",
     "impact layer.toml --out out",
     "layer.toml",
     "\"600 um\"",
     "600",
     {"layer.toml:15: target.depth", "without a unit", "um"}},
    {"ImpactWrongUnit",
     "impact layer.toml --out out",
     "layer.toml",
     "\"12 MPa\"",
     "\"12 mm\"",
     {"layer.toml:13: target.mu", "12 mm", "kPa"}},
    {"ImpactNegativeRadius",
     "impact layer.toml --out out",
     "layer.toml",
     "\"20 um\"",
     "\"-20 um\"",
     {"layer.toml:6: particle.radius", "-20 um", "a positive length"}},
    {"ImpactIncompressible",
     "impact layer.toml --out out",
     "layer.toml",
     "alpha = 5",
     "alpha = 5\nnu = 0.5",
     {"layer.toml:15: target.nu", "0.5", "between -1 and 0.5"}},
    {"ImpactAlphaZero",
     "impact layer.toml --out out",
     "layer.toml",
     "alpha = 5",
     "alpha = 0",
     {"layer.toml:14: target.alpha", "found 0"}},
    {"ImpactEmptyFile", "impact nothing.toml --out out", "nothing.toml", "", " ", {"nothing.toml", "particle"}},
    {"ImpactOfNoFile", "impact nowhere.toml --out out", "", "", "", {"nowhere.toml: there is no such file"}},
    {"ImpactOfAFolder", "impact folder --out out", "", "", "", {"folder: is a folder, not a file"}},
    {"ImpactOfACsv", "impact curve.csv --out out", "", "", "", {"curve.csv:1", "not valid TOML"}},
    {"IdentifyMalformed",
     "identify liver.toml --out out",
     "liver.toml",
     "name = \"agar\"",
     "name = agar",
     {"liver.toml:10", "not valid TOML"}},
    {"IdentifyUnknownKey",
     "identify liver.toml --out out",
     "liver.toml",
     "rate_factor",
     "rate_facter",
     {"liver.toml:", "rate_facter"}},
    {"IdentifyMissingUnit",
     "identify liver.toml --out out",
     "liver.toml",
     "\"230 um\"",
     "230",
     {"liver.toml:32: calibration.penetration", "without a unit"}},
    {"IdentifyWrongUnit",
     "identify liver.toml --out out",
     "liver.toml",
     "\"230 um\"",
     "\"230 um/s\"",
     {"liver.toml:32: calibration.penetration", "a speed"}},
    {"IdentifyNegativeRadius",
     "identify liver.toml --out out",
     "liver.toml",
     "\"2.5 mm\"",
     "\"-2.5 mm\"",
     {"liver.toml:37: model.radius", "-2.5 mm"}},
    {"IdentifyIncompressible",
     "identify liver.toml --out out",
     "liver.toml",
     "bulk_to_shear = 40",
     "nu = 0.6",
     {"liver.toml:47: solver.nu", "0.6"}},
    {"IdentifyEmptyTable",
     "identify liver.toml --out out",
     "liver.toml",
     "agar=2",
     "agar=9",
     {"shots.csv: agar", "\"9\""}},
    {"IdentifyBadCell", "identify liver.toml --out out", "agar.csv", "31.8", "31,8", {"agar.csv"}},
    {"IdentifyTextInANumber",
     "identify liver.toml --out out",
     "agar.csv",
     "31.8",
     "about 32",
     {"agar.csv:4", "modulus_kPa", "about 32"}},
    {"IdentifyOfNoFile", "identify nowhere.toml --out out", "", "", "", {"nowhere.toml: there is no such file"}},
    {"IdentifyOfAFolder", "identify folder --out out", "", "", "", {"folder: is a folder, not a file"}},
    {"ImpactOfAMeshThatNoMemoryHolds",
     "impact layer.toml --check",
     "layer.toml",
     "\"600 um\"",
     "\"1000 km\"",
     {"layer.toml: target.depth: found", "rows", "memory"}},
    {"IdentifyOfElementsLargerThanTheParticle",
     "identify liver.toml --out out",
     "liver.toml",
     "[3, 4, 5]",
     "[3, 0.5]",
     {"liver.toml:", "mesh_study.elements_per_radius", "a number from 1 to 1000"}},
    {"CheckIsNoLessStrict",
     "identify liver.toml --check --quiet",
     "liver.toml",
     "\"2.5 mm\"",
     "\"2.5\"",
     {"liver.toml:37: model.radius"}},
    {"FitTooManyCells", "fit curve.csv --out out", "curve.csv", "1.2,21,UT", "1.2,21,UT,3", {"curve.csv:3"}},
    {"FitNoRows", "fit empty.csv --out out", "empty.csv", "", "stretch,stress_kPa,mode\n", {"empty.csv", "rows"}},
    {"FitEmptyFile", "fit empty.csv --out out", "empty.csv", "", "\n", {"empty.csv"}},
    {"FitMissingUnit", "fit curve.csv --out out", "curve.csv", "stress_kPa", "stress", {"curve.csv:1", "unit"}},
    {"FitWrongUnit", "fit curve.csv --out out", "curve.csv", "stress_kPa", "stress_mm", {"curve.csv:1"}},
    {"FitNegativeStretch", "fit curve.csv --out out", "curve.csv", "1.2,21", "-1.2,21", {"curve.csv", "3", "-1.2"}},
    {"FitNoRowAfterWhere", "fit curve.csv --where mode=PS --out out", "", "", "", {"curve.csv", "PS"}},
    {"FitOfNoFile", "fit nowhere.csv --out out", "", "", "", {"nowhere.csv: there is no such file"}},
    {"ScaleMalformed",
     "scale scale.toml --out out",
     "scale.toml",
     "[model]",
     "[model",
     {"scale.toml:3", "not valid TOML"}},
    {"ScaleUnknownKey", "scale scale.toml --out out", "scale.toml", "radius", "radios", {"scale.toml", "radios"}},
    {"ScaleNegativeRadius",
     "scale scale.toml --out out",
     "scale.toml",
     "\"2 mm\"",
     "\"-2 mm\"",
     {"scale.toml:4: model.radius", "-2 mm"}},
    {"ScaleOfABadScene",
     "scale scale.toml --out out",
     "layer.toml",
     "\"600 um\"",
     "600",
     {"layer.toml:15: target.depth"}},
    {"CardOfAJob", "card write liver.toml --solver lsdyna --file card.k", "", "", "", {"liver.toml"}},
};
INSTANTIATE_TEST_SUITE_P(Commands, BadInputTo, testing::ValuesIn(bad_commands),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace percal
