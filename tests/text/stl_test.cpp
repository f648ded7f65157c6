// STL as text and in binary: what is read, and what is refused with its line.
#include "percal/text/stl.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "percal/base/error.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

const std::string one_facet =
    "solid a body\n  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n      vertex 1 0 0\n      vertex 0 1.5e0 "
    "-.25\n    endloop\n  endfacet\nendsolid a body\n";

std::string binary(const std::string& head, const std::vector<float>& numbers) {
  std::string content = head;
  content.resize(80, ' ');
  const auto put = [&content](std::uint32_t bits, int bytes) {
    for (int k = 0; k < bytes; ++k) content += static_cast<char>(bits >> 8 * k & 0xff);
  };
  put(static_cast<std::uint32_t>(numbers.size() / 9), 4);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (k % 9 == 0) content.append(12, '\0');  // the normal
    std::uint32_t bits = 0;
    std::memcpy(&bits, &numbers[k], 4);
    put(bits, 4);
    if (k % 9 == 8) put(0, 2);
  }
  return content;
}

std::string stl_refusal(const std::string& content) {
  try {
    parse_stl(content, "body.stl");
    return "accepted";
  } catch (const BadInput& error) {
    return error.what();
  }
}

TEST(Stl, TextAndBinaryAreTheSameTriangles) {
  const auto text = parse_stl(one_facet, "a");
  ASSERT_EQ(text.size(), 1u);
  EXPECT_EQ(text[0].corners[2], (std::array{0.0, 1.5, -0.25}));
  EXPECT_EQ(text[0].lines, (std::array{4, 5, 6}));
  for (const char* head : {"made by hand", "solid made by hand"}) {
    const auto found = parse_stl(binary(head, {0, 0, 0, 1, 0, 0, 0, 1.5F, -0.25F}), "a");
    ASSERT_EQ(found.size(), 1u) << head;
    EXPECT_EQ(found[0].corners, text[0].corners);
  }
}

TEST(Stl, WhatIsNoneIsRefusedWithItsLine) {
  const auto with = [](const std::string& text, const std::string& instead) {
    std::string changed = one_facet;
    return changed.replace(changed.find(text), text.size(), instead);
  };
  EXPECT_THAT(stl_refusal(with("vertex 1 0 0", "vertex 1 x 0")),
              HasSubstr("body.stl:5: found \"x\"; accepted: a finite number"));
  EXPECT_THAT(stl_refusal(with("vertex 1 0 0", "vertex 1 nan 0")), HasSubstr("body.stl:5: found \"nan\""));
  EXPECT_EQ(stl_refusal(with("vertex 1 0 0", "vertex +1 -0 +0")), "accepted");
  EXPECT_THAT(stl_refusal(with("vertex 1 0 0", "vertex 1 +-2 0")), HasSubstr("body.stl:5: found \"+-2\""));
  EXPECT_THAT(stl_refusal(with("vertex 1 0 0\n", "")),
              HasSubstr("body.stl:6: found \"endloop\"; accepted: \"vertex\""));
  EXPECT_THAT(stl_refusal(with("endsolid a body\n", "")), HasSubstr("body.stl:8: found \"the end of the file\""));
  EXPECT_THAT(stl_refusal(one_facet + one_facet), HasSubstr("body.stl:10: found \"solid\"; accepted: nothing behind"));
  EXPECT_THAT(stl_refusal("solid nothing\nendsolid\n"), HasSubstr("found no triangle"));
  EXPECT_THAT(stl_refusal("x_mm,y_mm,z_mm\n"), HasSubstr("found 15 bytes that do not begin with \"solid\""));
  const std::string whole = binary("", {0, 0, 0, 1, 0, 0, 0, 1, 0});
  EXPECT_THAT(stl_refusal(whole.substr(0, whole.size() - 1)),
              HasSubstr("found 133 bytes, which are not those of the 1 triangles"));
  EXPECT_THAT(stl_refusal(binary("", {0, 0, 0, 1, 0, 0, 0, INFINITY, 0})),
              HasSubstr("a number that is not finite in triangle 1"));
}

}  // namespace
}  // namespace percal
