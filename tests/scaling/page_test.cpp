// The page of percal scale, and the JSON that it reads.
#include "percal/scaling/page/page.hpp"

#include <gmock/gmock.h>

#include "page/page_words.hpp"

namespace percal {
namespace {

using page::Json;
using test::section_of;
using test::words_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string gold_and_steel = R"([prototype]
particle = "gold"
target = "skin"
radius = "1 um"
particle_density = "16800 kg/m3"
particle_modulus = "79 GPa"
speed = "651 m/s"
target_density = "1000 kg/m3"
mu = "15 MPa"
convention = "mu/alpha"
alpha = 8.5
strain_rate = "1e8 1/s"
[model]
particle = "steel"
target = "gelatin"
radius = "1.59 mm"
particle_density = "7800 kg/m3"
particle_modulus = "210 GPa"
speed = "83 m/s"
)";

Json result_of(const std::string& text, const std::string& similar_scene = "") {
  const ScaleJob job = parse_scale_job(text, "similar.toml");
  return scale_to_json(job, complete(job.prototype.system, job.model.system), similar_scene);
}

TEST(ScalePage, HasGroupsSystemsAndWhatFollows) {
  const std::string words = words_of(scale_page(result_of(gold_and_steel)));
  for (const char* there :
       {"4 of 10 groups agree within 1 %", "0.007547 times",
        "pi4 | rho_t v^2 / mu | inertia over target stiffness | 6.64786 | 6.64786 | +0.00 % | agree", "both lack depth",
        "true shear modulus | 63.75 MPa | 481.127 kPa", "2 mu/alpha | 15 MPa | 113.2 kPa",
        "particle radius | 1 um | 1.59 mm", "strain rate | 1e+08 1/s | 8018.63 1/s",
        "impact parameter rho_p v a | 10.9368 kg/(m s) | 1029.37 kg/(m s)", "sectional density m/(pi a^2) | 22.4 g/m2 | 16.536 kg/m2",
        "true shear modulus | 481.127 kPa | pi4", "[prototype]", "similar.toml"})
    EXPECT_THAT(words, HasSubstr(there));
}

TEST(ScalePage, TheAnswerIsWhatTheModelTakesAndWhatIsNotEqual) {
  const page::Page whole = scale_page(result_of(gold_and_steel, "steel.toml"));
  const std::string derived = words_of(*section_of(whole, "derived")), unlike = words_of(*section_of(whole, "unlike"));
  EXPECT_THAT(derived, AllOf(HasSubstr("target density | 464.286 kg/m3 | pi5"),
                             HasSubstr("2 mu/alpha | 113.2 kPa | pi4"), HasSubstr("The similar scene: steel.toml")));
  EXPECT_THAT(unlike, AllOf(HasSubstr("pi3 | inertia over particle stiffness | 0.09012 | 0.0002559 | differ"),
                            HasSubstr("0.013 in the prototype and 3.8e-05 in the model"), Not(HasSubstr("pi4"))));
}

TEST(ScalePage, WarnsOfWhatStandsInTheWay) {
  const Json result = result_of(gold_and_steel + "target_density = \"1010 kg/m3\"\n");
  const page::Page whole = scale_page(result);
  EXPECT_THAT(words_of(*section_of(whole, "unlike")), HasSubstr("pi5 = rho_t / rho_p is over-determined"));
  EXPECT_THAT(whole.summary, HasSubstr("in the way of similarity"));
}

TEST(ScalePage, TakesNoMissingKeyForANo) {
  for (const char* key : {"not_similar_because", "similar_scene", "derived", "tolerance", "cost"}) {
    Json cut = result_of(gold_and_steel);
    cut.erase(key);
    EXPECT_THROW(scale_page(cut), page::MissingKey) << key;
  }
}

}  // namespace
}  // namespace percal
