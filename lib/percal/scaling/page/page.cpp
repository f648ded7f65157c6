// The page of `percal scale`.
#include "percal/scaling/page/page.hpp"

#include <fmt/ranges.h>

#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"
#include "percal/scaling/system.hpp"

namespace percal {

using namespace page;

namespace {

// Rates have no prefixes of their own.
std::string shown_quantity(const std::optional<double>& value, const SystemQuantity& of) {
  if (of.dimension == Dimension{.time = -1}) return value ? shown(value, 6) + " 1/s" : absent;
  return quantity(value, of.dimension, 6);
}

std::string name_of(const Json& system) {
  const std::string particle = text(system, "particle"), target = text(system, "target");
  return particle + " into " + target;
}

// "1 %"; of any size.
std::string tolerance_words(const Json& result) { return shown(100 * number_or(result, "tolerance", NAN)) + " %"; }

int groups_that(const Json& result, const char* agreement) {
  int count = 0;
  for (const Json& group : list(result, "groups")) count += text(group, "agreement") == agreement;
  return count;
}

std::string summary_of(const Json& result) {
  const std::size_t obstacles = list(result, "not_similar_because").size();
  std::string summary = fmt::format("{} of {} groups agree within {}.", groups_that(result, "agree"),
                                    list(result, "groups").size(), tolerance_words(result));
  if (const auto ratio = number(result, "modulus_ratio"))
    summary += " The model's shear modulus is " + shown(ratio) + " times the prototype's (mu true).";
  return summary + (obstacles == 0 ? " Nothing stands in the way of similarity."
                                   : fmt::format(" {} thing{} in the way of similarity.", obstacles,
                                                 obstacles == 1 ? " stands" : "s stand"));
}

// "agree", "differ", or what is missing for it.
std::string verdict(const Json& group) {
  const auto lacks = [&](const char* key) { return fmt::format("{}", fmt::join(texts(at(group, key)), ", ")); };
  const std::string prototype = lacks("missing_in_prototype"), model = lacks("missing_in_model");
  if (prototype.empty() && model.empty()) return text(group, "agreement");
  if (prototype == model) return "both lack " + model;
  return (prototype.empty() ? "" : "prototype lacks " + prototype + (model.empty() ? "" : "; ")) +
         (model.empty() ? "" : "model lacks " + model);
}

// The groups that are not known to be equal, and why the two cannot be similar.
Section unlike_section(const Json& result) {
  Section section{.id = "unlike", .title = "What is not equal", .blocks = {}, .detail = Detail::answer};
  add(section, List{texts(at(result, "not_similar_because")), Tone::warning});
  Table table{.caption = "", .rows = {{"group", "meaning", "prototype", "model", "verdict"}}, .notes = {}};
  for (const Json& group : list(result, "groups"))
    if (text(group, "agreement") != "agree")
      table.rows.push_back({text(group, "symbol"), text(group, "name"), shown(number(group, "prototype")),
                            shown(number(group, "model")), verdict(group)});
  add(section, table);
  const auto prototype = number(at(result, "prototype"), "particle_compliance"),
             model = number(at(result, "model"), "particle_compliance");
  if (prototype || model)
    add_sentence(section, fmt::format("(rho_t v^2 + 10 mu)/E is {} in the prototype and {} in the model; where it is "
                                      "small the particle is rigid and pi3 has no effect.",
                                      shown(prototype, 2), shown(model, 2)));
  return section;
}

Section groups_section(const Json& result) {
  Section section{.id = "groups", .title = "The dimensionless groups", .blocks = {}};
  Table table{.caption = "Both systems without dimensions",
              .rows = {{"group", "formula", "meaning", "prototype", "model", "difference", "verdict"}},
              .notes = {"Two systems are similar where every group that decides the run is equal. Agree: within " +
                        tolerance_words(result) + "."}};
  for (const Json& group : list(result, "groups"))
    table.rows.push_back({text(group, "symbol"), text(group, "formula"), text(group, "name"),
                          shown(number(group, "prototype"), 6), shown(number(group, "model"), 6),
                          signed_percent(number(group, "difference"), 2), verdict(group)});
  add(section, table);
  return section;
}

// 2 mu/alpha of a system with both.
std::string mu1(const Json& system) {
  const auto mu = number(system, result_key(system_quantity(&System::mu))), alpha = number(system, "alpha");
  return mu && alpha && *alpha != 0 ? pressure(2 * *mu / *alpha) : "-";
}

Section systems_section(const Json& result) {
  Section section{.id = "systems", .title = "The two systems", .blocks = {}};
  const Json &prototype = at(result, "prototype"), &model = at(result, "model");
  Table table{.caption = "With dimensions", .rows = {{"", "prototype", "model"}}, .notes = {}};
  table.rows.push_back({"particle", text(prototype, "particle"), text(model, "particle")});
  table.rows.push_back({"target", text(prototype, "target"), text(model, "target")});
  for (const SystemQuantity& one : system_quantities()) {
    const auto first = number(prototype, result_key(one)), second = number(model, result_key(one));
    if (first || second) table.rows.push_back({one.words, shown_quantity(first, one), shown_quantity(second, one)});
  }
  const auto row_of = [&](const char* words, const char* key, const Dimension& dimension) {
    const auto first = number(prototype, key), second = number(model, key);
    if (first || second) table.rows.push_back({words, quantity(first, dimension, 6), quantity(second, dimension, 6)});
  };
  row_of("impact parameter rho_p v a", "impact_parameter_kg_m_s", dimension::impact_parameter);
  row_of("sectional density m/(pi a^2)", "sectional_density_kg_m2", dimension::sectional_density);
  table.rows.push_back({"2 mu/alpha", mu1(prototype), mu1(model)});
  table.rows.push_back({"the job's convention of mu", text(prototype, "convention"), text(model, "convention")});
  table.notes = {
      "mu true is the small-strain shear modulus; 2 mu/alpha is the number that LS-DYNA and others call MU1 or mu "
      "(the convention mu/alpha)."};
  add(section, table);
  return section;
}

Section derived_section(const Json& result) {
  Section section{
      .id = "derived", .title = "What the model takes from the prototype", .blocks = {}, .detail = Detail::answer};
  Table table{.caption = "", .rows = {{"the model's", "value", "from the group"}}, .notes = {}};
  const Json& model = at(result, "model");
  for (const Json& one : list(result, "derived"))
    for (const SystemQuantity& quantity : system_quantities()) {
      if (result_key(quantity) != text(one, "quantity")) continue;
      table.rows.push_back({quantity.words, shown_quantity(number(one, "value"), quantity), text(one, "from")});
      if (quantity.member == &System::mu) table.rows.push_back({"2 mu/alpha", mu1(model), text(one, "from")});
    }
  table.notes = {"They carry the prototype's relative errors."};
  add(section, table);
  if (const std::string file = text(result, "similar_scene"); !file.empty())
    add_sentence(section, "The similar scene: " + file);
  return section;
}

}  // namespace

page::Page scale_page(const page::Json& result) {
  Page page;
  page.title = "Similarity: " + name_of(at(result, "prototype")) + ", " + name_of(at(result, "model"));
  page.summary = summary_of(result);
  for (auto section :
       {derived_section, unlike_section, groups_section, systems_section, provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal
