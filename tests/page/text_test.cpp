// A page on the terminal: the answer first, tables that fit, sentences that are folded.
#include "percal/page/text.hpp"

#include <gmock/gmock.h>

namespace percal {
namespace {

using namespace page;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const Table values{.caption = "Values",
                   .rows = {{"", "value", "remark"}, {"mu", "3.4 MPa", "held"}, {"alpha \u00b1", "-12", "found"}},
                   .notes = {"By hand."}};

Page gel_page() {
  return {.title = "Gel",
          .summary = "mu is 3.4 MPa.",
          .sections = {{"answer", "What came out", {values, List{{"it slips"}, Tone::warning}}, Detail::answer},
                       {"runs", "The runs", {Sentence{"Three runs."}}, Detail::more}}};
}

TEST(PageAsText, TheAnswerComesAloneAndTheRestWhereItIsAskedFor) {
  const std::string answer = as_text(gel_page(), {}), all = as_text(gel_page(), {.detail = Detail::more});
  EXPECT_THAT(answer, AllOf(HasSubstr("mu is 3.4 MPa."), HasSubstr("What came out"), Not(HasSubstr("Three runs."))));
  EXPECT_THAT(all, AllOf(HasSubstr("What came out"), HasSubstr("Three runs.")));
}

TEST(PageAsText, ColumnsOfNumbersAreFlushRightAndWordsFlushLeft) {
  EXPECT_EQ(as_text(values, {}),
            "  Values\n"
            "             value  remark\n"
            "  ------------------------\n"
            "  mu       3.4 MPa  held\n"
            "  alpha \u00b1      -12  found\n"
            "  By hand.\n");
}

TEST(PageAsText, ATableWithoutAHeaderHasNone) {
  EXPECT_EQ(as_text(Table{.caption = "", .rows = {{"", ""}, {"runs", "3"}}, .notes = {}}, {}), "  runs  3\n");
}

TEST(PageAsText, SentencesAreFoldedAtTheColumns) {
  const Section section{"a", "A", {List{{"one two three four five six seven eight nine"}, Tone::note}}};
  EXPECT_EQ(as_text(section, {.columns = 30}), "A\n  note: one two three four\n    five six seven eight nine\n\n");
  EXPECT_EQ(as_text(section, {}), "A\n  note: one two three four five six seven eight nine\n\n");
}

TEST(PageAsText, ATableThatIsTooWideIsFoldedAndThenBecomesAList) {
  const Table table{.caption = "",
                    .rows = {{"", "value", "remark"}, {"modulus", "3.4 MPa", "a remark of several words, all of them"}},
                    .notes = {}};
  EXPECT_THAT(as_text(table, {.columns = 44}), HasSubstr("  modulus  3.4 MPa  a remark of several\n"));
  EXPECT_THAT(as_text(table, {.columns = 20}), HasSubstr("  modulus\n    value: 3.4 MPa\n    remark: a remark"));
}

TEST(PageAsText, AnyColumnOfWordsIsFoldedAndColumnsOfNumbersAreNot) {
  const Table table{
      .caption = "", .rows = {{"", "depth", "remark"}, {"tungsten carbide at 120 m/s", "222.7", "far"}}, .notes = {}};
  EXPECT_THAT(as_text(table, {.columns = 36}), HasSubstr("  tungsten carbide at  222.7  far\n"
                                                         "  120 m/s\n"));
}

TEST(PageAsText, ColoursAreThereWhereTheyAreAskedFor) {
  const std::string coloured = as_text(gel_page(), {.colour = true});
  EXPECT_THAT(coloured, AllOf(HasSubstr("\033[1mGel\033[0m"), HasSubstr("\033[33mwarning:\033[0m it slips")));
  EXPECT_THAT(as_text(gel_page(), {}), Not(HasSubstr("\033")));
}

}  // namespace
}  // namespace percal
