// A page as Markdown.
#include "percal/page/markdown.hpp"

#include <gmock/gmock.h>

namespace percal {
namespace {

using namespace page;

TEST(PageAsMarkdown, HasItsSectionsTablesListsAndFigures) {
  const Page made{.title = "Gel",
                  .summary = "Soft.",
                  .sections = {{"a",
                                "Answer",
                                {Table{"Values", {{"", "value"}, {"a|b", "3.4 MPa"}}, {"A note."}},
                                 List{{"slips"}, Tone::warning}, Figure{"ridge", "The ridge.", "a line", {}}},
                                Detail::answer},
                               {"b", "More", {Sentence{"And so on."}}, Detail::more}}};
  const std::string answer =
      "# Gel\n\nSoft.\n\n## Answer\n\n**Values**\n\n|  | value |\n| --- | ---: |\n| a\\|b | 3.4 MPa |\n\nA note.\n\n"
      "- **Warning:** slips\n\n![a line](figures/ridge.svg)\n\nThe ridge.\n";
  EXPECT_EQ(markdown(made, Detail::answer, "figures"), answer);
  EXPECT_EQ(markdown(made, Detail::more, "figures"), answer + "\n## More\n\nAnd so on.\n");
}

}  // namespace
}  // namespace percal
