// A chart's CSV and its script for gnuplot.
#include "percal/plot/chart.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace percal {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

Series series(const std::string& name, Mark mark, std::vector<double> x, std::vector<double> y) {
  Series made;
  made.name = name;
  made.mark = mark;
  made.x = std::move(x);
  made.y = std::move(y);
  return made;
}

Chart chart_of(const std::vector<Series>& all) {
  Chart chart;
  chart.x.label = "stretch";
  chart.y.label = "stress, kPa";
  chart.series = all;
  return chart;
}

TEST(PlotOf, APictureHasEqualScales) {
  Chart chart = chart_of({series("wall", Mark::line, {1, 2}, {3, 4})});
  EXPECT_THAT(plot_of("channel", chart).script, Not(HasSubstr("set size ratio")));
  chart.equal_scales = true;
  EXPECT_THAT(plot_of("channel", chart).script, HasSubstr("set size ratio -1\n"));
}

TEST(PlotOf, TheCsvHasEveryPointOfEverySeriesUnderTheAxesLabels) {
  Series bars = series("measured", Mark::points_with_bars, {1, 2}, {10, 20});
  bars.low = {9, 18};
  bars.high = {11, 22.5};
  Chart chart = chart_of({bars, series("fit", Mark::line, {1.5}, {NAN})});
  chart.remarks = {"mu 3.4 MPa\nalpha 2"};
  EXPECT_EQ(plot_of("curve", chart).csv,
            "# mu 3.4 MPa alpha 2\n"
            "series,\"stretch\",\"stress, kPa\",low,high\n"
            "\"measured\",1,10,9,11\n\"measured\",2,20,18,22.5\n\"fit\",1.5,,,\n");
}

TEST(PlotOf, QuotesWhatGnuplotOrASpreadsheetWouldRead) {
  Chart chart = chart_of({series("it's \"1\"\n!rm", Mark::line, {1, 2}, {1, 2})});
  chart.title = "a'; system 'rm\n{/=40 x}";
  const Plot plot = plot_of("x", chart);
  EXPECT_THAT(plot.script, HasSubstr("set title 'a''; system ''rm{/=40 x}' noenhanced\n"));
  EXPECT_THAT(plot.script, HasSubstr("title 'it''s \"1\"!rm'"));
  EXPECT_THAT(plot.csv, HasSubstr("\"it's \"\"1\"\"!rm\",1,1,,\n"));
}

// Spreadsheets run such cells.
TEST(PlotOf, TheCsvHasNoCellThatASpreadsheetWouldRun) {
  for (const char* name : {"=cmd|' /C calc'!A0", "+1", "-1", "@SUM(1)", " \t=1"}) {
    const std::string csv = plot_of("x", chart_of({series(name, Mark::line, {1}, {1})})).csv;
    EXPECT_THAT(csv, HasSubstr("\n\"'")) << name;
  }
  EXPECT_THAT(plot_of("x", chart_of({series("a-b", Mark::line, {1}, {-1})})).csv, HasSubstr("\n\"a-b\",1,-1,,\n"));
}

// gnuplot would look for tics without end.
TEST(PlotOf, NumbersThatNoQuantityHasAreNotDrawn) {
  Chart chart = chart_of({series("", Mark::line, {1, 2}, {1e-320, 1e-318})});
  chart.y.logarithmic = true;
  EXPECT_EQ(plot_of("x", chart).script, "");
  chart.y.logarithmic = false;
  EXPECT_THAT(plot_of("x", chart).script, HasSubstr("set yrange [-0.1:0.1]\n"));  // flat
  chart.series[0].y = {1e300, 1e308};
  EXPECT_EQ(plot_of("x", chart).script, "");
  chart.series[0].y = {1, 2};
  chart.y.low = -1e300;
  EXPECT_THAT(plot_of("x", chart).script, HasSubstr("set yrange [0.97:2.03]\n"));
}

TEST(PlotOf, AChartWithoutAPointThatCanBeDrawnHasNoScript) {
  Chart chart = chart_of({series("none", Mark::line, {1, NAN}, {NAN, 1})});
  EXPECT_EQ(plot_of("x", chart).script, "");
  chart.series[0].y = {-1, -1};
  EXPECT_NE(plot_of("x", chart).script, "");
  chart.y.logarithmic = true;
  EXPECT_EQ(plot_of("x", chart).script, "");
}

TEST(PlotOf, ALineIsBrokenWhereANumberIsMissing) {
  const Chart chart = chart_of({series("", Mark::line, {1, 2, 3}, {5, NAN, 7})});
  EXPECT_THAT(plot_of("x", chart).script, HasSubstr("EOD\n1 5\n\n3 7\nEOD\n"));
}

TEST(PlotOf, ABarWithoutAnEndStopsAtItsPoint) {
  Series bars = series("", Mark::points_with_bars, {1}, {5});
  bars.low = {4};
  bars.high = {INFINITY};
  const std::string script = plot_of("x", chart_of({bars})).script;
  EXPECT_THAT(script, HasSubstr("\n1 5 4 5\n"));
  EXPECT_THAT(script, Not(HasSubstr("inf")));
}

TEST(PlotOf, ABandNeedsNoMiddle) {
  Series band = series("", Mark::band, {1, 2}, {});
  band.low = {3, 4};
  band.high = {5, 6};
  const std::string script = plot_of("x", chart_of({band})).script;
  EXPECT_THAT(script, HasSubstr("\n1 5 3 5\n2 6 4 6\n"));
  EXPECT_THAT(script, HasSubstr("using 1:3:4 with filledcurves"));
}

TEST(PlotOf, LogarithmicAxesHaveTicsAtOneTwoFiveOrAtDecades) {
  Chart chart = chart_of({series("", Mark::line, {1, 2}, {3, 40})});
  chart.y.logarithmic = true;
  EXPECT_THAT(plot_of("x", chart).script, HasSubstr("set ytics ('5' 5, '10' 10, '20' 20) noenhanced\n"));
  chart.series[0].y = {1, 1e5};
  EXPECT_THAT(plot_of("x", chart).script,
              HasSubstr("('1' 1, '10' 10, '100' 100, '1000' 1000, '10000' 10000, '100000' 1"));
}

TEST(PlotOf, ARangeThatIsGivenIsKept) {
  Chart chart = chart_of({series("", Mark::line, {1, 2}, {3, 40})});
  chart.x.low = 0;
  EXPECT_THAT(plot_of("x", chart).script, HasSubstr("set xrange [0:2.03]\n"));
}

TEST(PlotOf, LabelsOfALogarithmicAxisStandClearOfEachOther) {
  Chart chart = chart_of({series("", Mark::line, {1200, 9000}, {1200, 9000})});
  chart.x.logarithmic = chart.y.logarithmic = true;
  const std::string script = plot_of("x", chart).script;
  EXPECT_THAT(script, HasSubstr("set xtics ('1500' 1500, '2000' 2000, '3000' 3000, '4000' 4000, '6000' 6000, "
                                "'8000' 8000)"));
  EXPECT_THAT(script, HasSubstr("'4000' 4000, '5000' 5000, '6000' 6000, '8000' 8000)")) << "upwards there is room";
}

TEST(PlotOf, TheUpperAxisIsTheLowerOneTimesItsFactor) {
  Chart chart = chart_of({series("", Mark::line, {1, 2}, {3, 40})});
  chart.x.low = 1;
  chart.x.high = 3;
  chart.upper = Axis{};
  chart.upper->label = "above";
  chart.upper_factor = 10;
  EXPECT_THAT(plot_of("x", chart).script, HasSubstr("set x2range [10:30]\n"));
}

TEST(Palette, ColoursCycleAndGreyIsOutsideOfIt) {
  EXPECT_EQ(palette_colour(0), palette_colour(8));
  EXPECT_NE(palette_colour(0), palette_colour(1));
  EXPECT_EQ(palette_colour(-1), "#808080");
}

double luminance_of_channel(const std::string& colour, int place) {
  const double c = std::stoi(colour.substr(static_cast<std::size_t>(place), 2), nullptr, 16) / 255.0;
  return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(const std::string& colour) {
  return 0.2126 * luminance_of_channel(colour, 1) + 0.7152 * luminance_of_channel(colour, 3) +
         0.0722 * luminance_of_channel(colour, 5);
}

// Contrast as the Web Content Accessibility Guidelines define it: 3 for what is not text.
TEST(Palette, EveryColourIsReadableOnWhiteAndOnTheDarkPage) {
  for (int k = -1; k < 8; ++k) {
    const double colour = luminance(palette_colour(k));
    EXPECT_GE(1.05 / (colour + 0.05), 3) << palette_colour(k);
    EXPECT_GE((colour + 0.05) / (luminance("#14171a") + 0.05), 3) << palette_colour(k);
  }
}

// Of a reader who sees all colours, no red or no green, as CIE Lab: Machado, Oliveira and Fernandes (2009), severity 1.
using Triple = std::array<double, 3>;
constexpr std::array<std::array<Triple, 3>, 3> visions{
    {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}}};
constexpr std::array<Triple, 3> to_xyz{{{0.4339, 0.3763, 0.1899}, {0.2126, 0.7152, 0.0722}, {0.0177, 0.1095, 0.8729}}};

Triple times(const std::array<Triple, 3>& matrix, const Triple& v) {
  Triple product{};
  for (int i = 0; i < 3; ++i) product[i] = matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2];
  return product;
}

Triple as_seen(const std::string& colour, const std::array<Triple, 3>& vision) {
  Triple seen = times(
      vision, {luminance_of_channel(colour, 1), luminance_of_channel(colour, 3), luminance_of_channel(colour, 5)});
  for (double& channel : seen) channel = std::clamp(channel, 0.0, 1.0);
  Triple xyz = times(to_xyz, seen);  // over white's
  for (double& one : xyz) one = one > 0.008856 ? std::cbrt(one) : 7.787 * one + 16.0 / 116;
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

TEST(Palette, ColoursDifferForAReaderWhoSeesNoRedOrNoGreen) {
  constexpr double clearly = 20;  // distance in Lab; 2.3 is just noticeable side by side
  for (const auto& vision : visions)
    for (int k = -1; k < 5; ++k)
      for (int other = k + 1; other < 5; ++other) {
        const Triple a = as_seen(palette_colour(k), vision), b = as_seen(palette_colour(other), vision);
        EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), clearly) << k << " " << other;
      }
}

}  // namespace
}  // namespace percal
