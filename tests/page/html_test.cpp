// A page as HTML: well-formed, escaped, with ids of its own.
#include "percal/page/html.hpp"

#include <gmock/gmock.h>

#include <set>
#include <stdexcept>

#include "page/markup_faults.hpp"

namespace percal {
namespace {

using namespace page;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Chart chart() {
  Chart made;
  made.title = "Stress <1>";
  made.x.label = "stretch";
  made.y.label = "stress, kPa";
  Series line;
  line.name = "fit & data";
  line.x = {1, 2};
  line.y = {0, 3.5};
  made.series = {line};
  return made;
}

Page made_up_page() {
  Page made;
  made.title = "<script>alert('x')</script> & \"more\"";
  made.summary = "mu < 3";
  Table table{.caption = "Values",
              .rows = {{"", "value", "remark"}, {"mu", "3.4 MPa", "a<b"}, {"alpha", "-"}},
              .notes = {"n<m"}};
  Table names{.caption = "", .rows = {{"", ""}, {"percal", "0.1.0"}}, .notes = {}};
  made.sections = {
      {"result", "What came <out>", {Sentence{"p & q"}, table, names}},
      {"curves", "Curves", {Figure{"one", "c < d", "alt \"text\"", chart()}, Figure{"two", "", "second", chart()}}},
      {"input", "Input", {List{{"</li>"}}, Code{"job.toml", "a = \"</pre>\"\n"}}}};
  return made;
}

TEST(Html, IsWellFormed) { EXPECT_THAT(test::markup_faults(html(made_up_page(), {})), IsEmpty()); }

TEST(Html, WithItsFiguresItIsWellFormedToo) {
  const DrawnFigures figures = draw_figures(made_up_page());
  if (figures.empty()) GTEST_SKIP() << "gnuplot is not there";
  EXPECT_EQ(figures.size(), 2u);
  EXPECT_THAT(test::markup_faults(html(made_up_page(), figures)), IsEmpty());
}

TEST(Html, EscapesEveryTextOfTheUser) {
  const std::string text = html(made_up_page(), {});
  EXPECT_THAT(text, Not(HasSubstr("<script")));
  for (const char* escaped :
       {"&lt;script&gt;alert(&#39;x&#39;)", "mu &lt; 3", "What came &lt;out&gt;", "p &amp; q", "a&lt;b", "n&lt;m",
        "c &lt; d", "Stress &lt;1&gt;", "<li>&lt;/li&gt;</li>", "&lt;/pre&gt;"})
    EXPECT_THAT(text, HasSubstr(escaped));
}

TEST(Html, ForbidsScriptsAndFetchingByItsOwnPolicy) {
  EXPECT_THAT(html(made_up_page(), {}), HasSubstr("content=\"default-src 'none'; style-src 'unsafe-inline'\""));
}

TEST(Html, TablesSayWhatTheirCellsBelongTo) {
  const std::string text = html(made_up_page(), {});
  EXPECT_THAT(text, AllOf(HasSubstr("<html lang=\"en\">"), HasSubstr("<th scope=\"col\" class=\"number\">value</th>"),
                          HasSubstr("<th scope=\"row\">mu</th><td class=\"number\">3.4 MPa</td><td>a&lt;b</td>"),
                          HasSubstr("<th scope=\"row\">percal</th><td>0.1.0</td>")));
}

TEST(Html, AFigureThatWasNotDrawnShowsItsPointsAndSaysWhy) {
  const std::string text = html(made_up_page(), {});
  EXPECT_THAT(text, AllOf(HasSubstr("gnuplot is not there"), HasSubstr("<td class=\"number\">3.5</td>")));
  const std::string drawn = html(made_up_page(), {{"one", "<svg></svg>"}, {"two", "<svg></svg>"}});
  EXPECT_THAT(drawn, AllOf(HasSubstr("<svg></svg>"), Not(HasSubstr("gnuplot is not there"))));
}

TEST(Html, FiguresHaveAltTexts) {
  const DrawnFigures figures = draw_figures(made_up_page());
  if (figures.empty()) GTEST_SKIP() << "gnuplot is not there";
  EXPECT_THAT(figures.at("one"), HasSubstr("<svg role=\"img\" aria-label=\"alt &quot;text&quot;\""));
}

TEST(Html, TwoOfOneNameAreAFault) {
  Page twice = made_up_page();
  twice.sections[2].id = "result";
  EXPECT_THROW(html(twice, {}), std::logic_error);
  twice = made_up_page();
  std::get<Figure>(twice.sections[1].blocks[1]).name = "one";
  EXPECT_THROW(html(twice, {}), std::logic_error);
}

}  // namespace
}  // namespace percal
