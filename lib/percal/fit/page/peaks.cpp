// What the user asked to be made of the files, and the peaks of their curves.
#include <fmt/core.h>

#include "percal/fit/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page_of_fit {

Section taken_section(const Json& result) {
  Section section{.id = "taken", .title = "What was taken of the files", .blocks = {}, .detail = Detail::answer};
  List sentences;
  for (const Json& source : list(result, "sources"))
    for (const std::string& sentence : texts(maybe(source, "taken"))) sentences.items.push_back(sentence);
  add(section, sentences);
  return section;
}

Section peaks_section(const Json& result) {
  Section section{.id = "peaks", .title = "Where the curves peak", .blocks = {}, .detail = Detail::answer};
  Table table{
      .caption = "", .rows = {{"curve", "stretch or shear", "stress", "behind it", "as erosion strain"}}, .notes = {}};
  for (const Json& source : list(result, "sources"))
    for (const Json& peak : maybe(source, "peaks")) {
      const std::string end = text(peak, "end");
      table.rows.push_back({text(peak, "test"), shown(number(peak, "amount")), pressure(number(peak, "stress_Pa")),
                            end == "falls"  ? "falls to " + percent(number(peak, "fallen_to"), 0)
                            : end == "held" ? "relaxes, held"
                                            : "no fall",
                            end == "falls" ? shown(number(peak, "erosion_strain"), 3) : absent});
    }
  if (table.rows.size() < 2) return section;
  add(section, table);
  const Json& prior = maybe(result, "erosion_prior");
  if (prior.is_null()) {
    add_sentence(section,
                 "No curve falls behind its largest stress: they say nothing of an erosion strain but that it "
                 "is no smaller.");
    return section;
  }
  add_sentence(
      section,
      "The strain at the peak is offered as a prior for the erosion strain, for the solid bears no more there; "
      "with caution: a specimen fails from its flaws and at its grips, and a particle's erosion strain belongs "
      "to a size of element and to a rate, so that the prior is wide.");
  add_sentence(section,
               fmt::format("For a job of percal calibrate, in its parameter of kind \"erosion strain\": prior = {} "
                           "and prior_error = \"{:.0f} %\".",
                           shown(number(prior, "strain"), 3), 100 * number_or(prior, "error", 0)));
  return section;
}

}  // namespace percal::page_of_fit
