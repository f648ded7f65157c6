// What the pages of curve fits read out of a result: intervals, sources, points.
#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "percal/fit/page/parts.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page {

Table sources_table(const Json& result) {
  Table table{.caption = "The curves", .rows = {{"file", "x", "stress", "points", "SHA-256"}}, .notes = {}};
  for (const Json& source : list(result, "sources")) {
    const std::string error = text(source, "error"), digest = text(source, "sha256");
    table.rows.push_back(
        {std::filesystem::path(text(source, "file")).filename().string(), text(source, "x"),
         text(source, "y") + " (" + text(source, "stress") + ")" + (error.empty() ? "" : ", errors " + error),
         shown(number(source, "points"), 9), digest.empty() ? "-" : digest.substr(0, 16) + "..."});
  }
  return table;
}

std::vector<PagePoints> points_of(const Json& result) {
  std::vector<PagePoints> all;
  for (const Json& test : list(result, "data")) {
    PagePoints points;
    points.name = text(test, "name");
    points.deformation = deformation_of(text(test, "deformation")).value_or(Deformation::uniaxial);
    const auto amount = numbers(at(test, "amount")), across = numbers(at(test, "across"));
    points.stress = numbers(at(test, "stress_Pa"));
    points.error = numbers(at(test, "error_Pa"));
    points.stress.resize(amount.size(), NAN);
    points.error.resize(amount.size(), NAN);
    for (std::size_t i = 0; i < amount.size(); ++i)
      points.strained.push_back(
          {points.deformation, amount[i], i < across.size() && std::isfinite(across[i]) ? across[i] : 1});
    all.push_back(points);
  }
  return all;
}

}  // namespace percal::page
