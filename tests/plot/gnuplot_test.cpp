// Drawn by gnuplot, where it is there.
#include "percal/plot/gnuplot.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

#include "percal/plot/svg.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Plot parabola(int points) {
  Chart chart;
  chart.title = "a < b & c";
  Series line;
  line.name = "y";
  line.mark = Mark::points;
  for (int i = 0; i <= points; ++i) {
    line.x.push_back(i);
    line.y.push_back(i * i);
  }
  chart.series = {line};
  return plot_of("parabola", chart);
}

class Gnuplot : public testing::Test {
 protected:
  void SetUp() override {
    if (!gnuplot("set terminal svg\nplot x\n")) GTEST_SKIP() << "gnuplot is not there";
  }
};

TEST_F(Gnuplot, AnSvgTakesItsColourFromTheTextAroundItAndHasNothingWhite) {
  const std::string svg = draw_svg(parabola(4)).value();
  EXPECT_THAT(svg, AllOf(StartsWith("<svg"), HasSubstr("currentColor"), HasSubstr("a &lt; b &amp; c")));
  for (const char* fault : {"white", "black", "url(", "<filter", "Gnuplot"}) EXPECT_THAT(svg, Not(HasSubstr(fault)));
}

TEST_F(Gnuplot, IdsCarryTheNameOfThePlot) {
  const std::string svg = draw_svg(parabola(4)).value();
  EXPECT_THAT(svg, AllOf(HasSubstr("id='parabola-gpPt6'"), HasSubstr("href='#parabola-gpPt6'")));
  EXPECT_THAT(svg, Not(AnyOf(HasSubstr("id='gp"), HasSubstr("id=\"gnuplot"), HasSubstr("href='#gp"))));
}

TEST_F(Gnuplot, TakesScriptsLongerThanAPipeHolds) {
  const Plot plot = parabola(20000);
  ASSERT_GT(plot.script.size(), 100000u);
  EXPECT_TRUE(draw_svg(plot).has_value());
}

TEST_F(Gnuplot, APngIsAPng) { EXPECT_THAT(draw_png(parabola(4)).value(), StartsWith("\x89PNG")); }

TEST_F(Gnuplot, StopsWhereADrawingDoesNotEnd) {
  EXPECT_FALSE(
      gnuplot("set print '-'\ndo for [i=1:100000000] { print 'a line that is written a hundred million times' }\n"));
}

TEST(GnuplotNotThere, DrawsNothing) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  EXPECT_FALSE(draw_svg(parabola(4)).has_value());
  EXPECT_FALSE(draw_png(parabola(4)).has_value());
  setenv("PATH", path.c_str(), 1);
}

TEST(InlineSvg, NeedsNoNamespaceAndReadsItsAltText) {
  const std::string svg =
      "<svg \n viewBox=\"0 0 1 1\"\n xmlns=\"http://www.w3.org/2000/svg\"\n "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\"\n>"
      "<use xlink:href='#x'/></svg>\n";
  const std::string text = inline_svg(svg, "a \"b\" <c>");
  EXPECT_THAT(text, StartsWith("<svg role=\"img\" aria-label=\"a &quot;b&quot; &lt;c&gt;\""));
  EXPECT_THAT(text, AllOf(HasSubstr("<use href='#x'/>"), Not(HasSubstr("http"))));
}

}  // namespace
}  // namespace percal
