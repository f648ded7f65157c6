#include "percal/observe/picture.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "impact/polygons.hpp"
#include "observe/crater.hpp"
#include "percal/base/error.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/plot/gnuplot.hpp"

namespace percal {
namespace {

using test::crater;
using test::scales;
using testing::HasSubstr;

Frame last_frame(const Problem& problem) {
  struct Last : FrameObserver {
    bool is_due(const Moment&) override { return false; }
    void see(const Frame& seen) override { frame = seen; }
    Frame frame;
  } last;
  run_impact(problem, last);
  return last.frame;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

// Cells are separated by two empty lines.
std::size_t cells_in(const std::string& script) { return count(script, "\n\n\n"); }

TEST(PictureFormat, IsTheEndOfTheFilesName) {
  EXPECT_EQ(picture_format("a/b.png", "--picture"), PictureFormat::png);
  EXPECT_EQ(picture_format("b.c.svg", "--picture"), PictureFormat::svg);
  EXPECT_EQ(picture_format("x.pdf", "--picture"), PictureFormat::pdf);
  for (const char* file : {"", "png", "a.jpg", "a.PNG", "a.png.txt"})
    EXPECT_THROW(picture_format(file, "--picture"), BadInput) << file;
}

TEST(Picture, ErodedCellsAndThoseFarBelowAreLeftOut) {
  Frame frame = last_frame(crater());
  const std::size_t all = cells_in(picture_script(frame, crater(), scales, PictureFormat::svg, ""));
  EXPECT_GT(all, 200u);
  EXPECT_LT(all, 400u) << "most of the 75 radii of depth are not shown";
  const auto live = std::find(frame.target.eroded.begin(), frame.target.eroded.end(), 0);
  *live = 1;
  EXPECT_EQ(cells_in(picture_script(frame, crater(), scales, PictureFormat::svg, "")), all - 1);
}

// As where it has gone out of the plane of the cut.
TEST(Picture, AParticleOfWhichThereIsNothingIsNotDrawn) {
  Frame frame = last_frame(crater());
  frame.particle = {};
  EXPECT_EQ(picture_script(frame, crater(), scales, PictureFormat::svg, "").find("polygon"), std::string::npos);
}

TEST(Picture, IsMirroredUnlessTheModelIsWhole) {
  EXPECT_THAT(picture_script(last_frame(crater()), crater(), scales, PictureFormat::svg, ""),
              HasSubstr("using (-$1):2:3"));
  Problem whole = prism_impact(square_on_its_corner());
  whole.end_time = 1;
  EXPECT_THAT(picture_script(last_frame(whole), whole, scales, PictureFormat::svg, ""),
              testing::Not(HasSubstr("using (-$1)")));
}

TEST(Picture, ATitleIsTextAndNotACommand) {
  const std::string script =
      picture_script(last_frame(crater()), crater(), scales, PictureFormat::svg, "it's\nexit\n`touch x`");
  EXPECT_THAT(script, HasSubstr("set title 'it''sexit`touch x`' noenhanced\n"));
}

// Where gnuplot is there.
TEST(Picture, IsDrawnInEachFormatWithOnePolygonACellOnEachSide) {
  if (!gnuplot("set print '-'\nprint 1\n")) GTEST_SKIP() << "no gnuplot";
  const Frame frame = last_frame(crater());
  const std::string script = picture_script(frame, crater(), scales, PictureFormat::svg, "a title");
  const auto svg = gnuplot(script);
  ASSERT_TRUE(svg);
  EXPECT_THAT(*svg, HasSubstr("a title"));
  EXPECT_THAT(*svg, HasSubstr("largest principal stretch"));
  EXPECT_GE(count(*svg, "<polygon"), 2 * cells_in(script));
  const auto png = gnuplot(picture_script(frame, crater(), scales, PictureFormat::png, ""));
  ASSERT_TRUE(png);
  EXPECT_EQ(png->substr(1, 3), "PNG");
  const auto pdf = gnuplot(picture_script(frame, crater(), scales, PictureFormat::pdf, ""));
  ASSERT_TRUE(pdf);
  EXPECT_EQ(pdf->substr(0, 4), "%PDF");
}

TEST(Picture, ARunWithoutNumbersIsStillDrawn) {
  Frame frame = last_frame(crater());
  frame.target.position.assign(frame.target.position.size(), {0.0 / 0.0, 0.0 / 0.0});
  frame.particle.position.assign(frame.particle.position.size(), {0.0 / 0.0, 0.0 / 0.0});
  frame.moment.tip = 0.0 / 0.0;
  const std::string script = picture_script(frame, crater(), scales, PictureFormat::svg, "");
  EXPECT_EQ(cells_in(script), 0u);
  EXPECT_THAT(script, testing::Not(HasSubstr("nan")));
  if (gnuplot("set print '-'\nprint 1\n")) {
    EXPECT_TRUE(gnuplot(script));
  }
}

}  // namespace
}  // namespace percal
