#include "percal/text/json.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "percal/base/error.hpp"

namespace percal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string json_refusal(const std::string& text) {
  try {
    parse_json(text, "result.json", "a result");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

std::string nested(int levels) { return std::string(levels, '[') + std::string(levels, ']'); }

TEST(Json, IsReadToItsLastLevel) {
  EXPECT_EQ(parse_json(R"({"a": [1, "]}]}[[[ \" \\"]})", "f", "a result")["a"][0], 1);
  EXPECT_EQ(json_refusal(nested(deepest_json)), "");
}

TEST(Json, NamesTheLineOfWhatIsNone) {
  EXPECT_THAT(json_refusal("{\n\"a\": 1,\n]"),
              HasSubstr("result.json:3: found text that is not JSON; accepted: a result"));
  EXPECT_THAT(json_refusal("\n" + nested(deepest_json + 1)),
              AllOf(HasSubstr("result.json:2"), HasSubstr("too deeply")));
  EXPECT_THAT(json_refusal(std::string(20000, '[')), HasSubstr("too deeply"));
  EXPECT_THAT(json_refusal("[\n1,\n1e509]"), AllOf(HasSubstr("result.json:3"), HasSubstr("found 1e509")));
  EXPECT_THAT(json_refusal(std::string(largest_json + 1, ' ')), HasSubstr("64 MiB"));
}

}  // namespace
}  // namespace percal
