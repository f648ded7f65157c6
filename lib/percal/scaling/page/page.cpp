// The page of `percal scale`.
#include "percal/scaling/page/page.hpp"

#include <fmt/core.h>

#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"
#include "percal/scaling/system.hpp"

namespace percal {

using namespace page;

namespace {

// The key of a quantity in a result, which ends with its unit.
std::string key_of(const SystemQuantity& of) {
  const std::string key = of.member == &System::mu ? "mu_true" : of.key;
  return of.unit.empty() ? key : key + "_" + of.unit;
}

// Rates have no prefixes of their own.
std::string shown_quantity(const std::optional<double>& value, const SystemQuantity& of) {
  if (of.dimension == Dimension{.time = -1}) return value ? shown(value, 6) + " 1/s" : "-";
  return quantity(value, of.dimension, 6);
}

std::string name_of(const Json& system) {
  const std::string particle = text(system, "particle"), target = text(system, "target");
  return particle.empty() && target.empty() ? "-" : particle + " into " + target;
}

int groups_that(const Json& result, const char* agreement) {
  int count = 0;
  for (const Json& group : list(result, "groups")) count += text(group, "agreement") == agreement;
  return count;
}

std::string summary_of(const Json& result) {
  const std::size_t obstacles = list(result, "not_similar_because").size();
  std::string summary = fmt::format("{} and {}: {} of {} groups agree within {}.", name_of(at(result, "prototype")),
                                    name_of(at(result, "model")), groups_that(result, "agree"),
                                    list(result, "groups").size(), percent(number(result, "tolerance"), 1));
  if (const auto ratio = number(result, "modulus_ratio"))
    summary += " The model's shear modulus is " + shown(ratio) + " times the prototype's (mu true).";
  return summary + (obstacles == 0 ? " Nothing stands in the way of similarity."
                                   : fmt::format(" {} thing{} in the way of similarity.", obstacles,
                                                 obstacles == 1 ? " stands" : "s stand"));
}

std::string verdict(const Json& group) {
  std::string words = text(group, "agreement");
  const auto missing = [&](const char* key, const char* system) {
    std::string all;
    for (const std::string& name : texts(at(group, key))) all += (all.empty() ? "" : ", ") + name;
    if (!all.empty()) words += std::string("; ") + system + " lacks " + all;
  };
  missing("missing_in_prototype", "prototype");
  missing("missing_in_model", "model");
  return words;
}

Section groups_section(const Json& result) {
  Section section{.id = "groups", .title = "The dimensionless groups", .blocks = {}};
  Table table{.caption = "Both systems without dimensions",
              .rows = {{"group", "formula", "meaning", "prototype", "model", "difference", "verdict"}},
              .notes = {"Two systems are similar where every group that decides the run is equal. Agree: within " +
                        percent(number(result, "tolerance"), 1) + "."}};
  for (const Json& group : list(result, "groups"))
    table.rows.push_back({text(group, "symbol"), text(group, "formula"), text(group, "name"),
                          shown(number(group, "prototype"), 6), shown(number(group, "model"), 6),
                          signed_percent(number(group, "difference"), 2), verdict(group)});
  add(section, table);
  if (const auto obstacles = texts(at(result, "not_similar_because")); !obstacles.empty()) {
    add_sentence(section, "What stands in the way of similarity:");
    section.blocks.push_back(List{obstacles});
  }
  return section;
}

// 2 mu/alpha of a system with both.
std::string mu1(const Json& system) {
  const auto mu = number(system, "mu_true_Pa"), alpha = number(system, "alpha");
  return mu && alpha && *alpha != 0 ? pressure(2 * *mu / *alpha) : "-";
}

Section systems_section(const Json& result) {
  Section section{.id = "systems", .title = "The two systems", .blocks = {}};
  const Json &prototype = at(result, "prototype"), &model = at(result, "model");
  Table table{.caption = "With dimensions", .rows = {{"", "prototype", "model"}}, .notes = {}};
  table.rows.push_back({"particle", text(prototype, "particle"), text(model, "particle")});
  table.rows.push_back({"target", text(prototype, "target"), text(model, "target")});
  for (const SystemQuantity& one : system_quantities()) {
    const auto first = number(prototype, key_of(one)), second = number(model, key_of(one));
    if (first || second) table.rows.push_back({one.words, shown_quantity(first, one), shown_quantity(second, one)});
  }
  table.rows.push_back({"2 mu/alpha", mu1(prototype), mu1(model)});
  table.rows.push_back({"the job's convention of mu", text(prototype, "convention"), text(model, "convention")});
  table.notes = {
      "mu true is the small-strain shear modulus; 2 mu/alpha is the number that LS-DYNA and others call MU1 or mu "
      "(the convention mu/alpha)."};
  add(section, table);
  return section;
}

Section derived_section(const Json& result) {
  Section section{.id = "derived", .title = "What the model takes from the prototype", .blocks = {}};
  Table table{.caption = "The model's missing values", .rows = {{"", "value", "from the group"}}, .notes = {}};
  for (const Json& one : list(result, "derived"))
    for (const SystemQuantity& quantity : system_quantities())
      if (key_of(quantity) == text(one, "quantity"))
        table.rows.push_back({quantity.words, shown_quantity(number(one, "value"), quantity), text(one, "from")});
  table.notes = {
      "These numbers carry the prototype's errors: a relative error of the prototype's modulus is one of the model's."};
  add(section, table);
  return section;
}

}  // namespace

page::Page scale_page(const page::Json& result) {
  Page page;
  page.title = "Similarity: " + name_of(at(result, "prototype")) + ", " + name_of(at(result, "model"));
  page.summary = summary_of(result);
  for (auto section : {groups_section, systems_section, derived_section, provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal
