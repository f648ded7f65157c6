#include "percal/fit/read/curve_shapes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <variant>

#include "percal/fit/shape/curve_branches.hpp"
#include "percal/page/numbers.hpp"
#include "percal/text/csv_cells.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr double offset_share = 0.02;  // of the largest stress, at stretch 1
constexpr double toe_end = 0.25;       // of the largest strain
constexpr double toe_kink = 10;        // times as steep behind the toe as in it
constexpr double toe_slope = 0.3;      // of the whole curve's, at least, behind it
constexpr double toe_noise = 4;        // standard deviations of one stress that the toe lacks, at least
constexpr std::size_t coarse = 64;  // means that a toe is looked for in, of a log with more than twice as many points

std::string of_test(const CsvTable& table, const Followed& test) { return table.file + ": " + test.name + ": "; }

enum class Keep { up_to, behind };

// "--where "strain<=0.4"": the rows up to a point of a loading, or those behind it; `end` is another behind it.
std::string rows_kept(const CsvTable& table, const FoundColumns& found, const Met& point, const Met& end, Keep keep) {
  const std::string here = table.cell(table.rows[point.row], found.x);
  const auto a = parse_number(here, table.dialect.decimal_comma),
             b = parse_number(table.cell(table.rows[end.row], found.x), table.dialect.decimal_comma);
  const bool rising = a.value && b.value && *b.value > *a.value;
  return fmt::format("--where \"{}{}{}\"", table.columns[static_cast<std::size_t>(found.x)].name,
                     keep == Keep::up_to ? (rising ? "<=" : ">=") : (rising ? ">" : "<"), here);
}

std::string stretch_of(const CsvTable& table, const FoundColumns& found, const Met& point) {
  const CsvColumn& x = table.columns[static_cast<std::size_t>(found.x)];
  return x.name + " " + table.cell(table.rows[point.row], found.x) + (x.unit.empty() ? "" : " " + x.unit);
}

void runs_back(const CsvTable& table, const Followed& test, const std::vector<Branch>& branches,
               std::vector<std::string>& sentences) {
  const std::size_t all = branches.size();
  if (all < 2 || all * 4 > test.points.size()) return;  // in no order at all
  const auto loading = std::count_if(branches.begin(), branches.end(), [](const Branch& b) { return b.loading; });
  const auto restarts = std::count_if(branches.begin(), branches.end(), [](const Branch& b) { return b.anew; });
  if (static_cast<std::size_t>(loading) < all)
    sentences.push_back(
        of_test(table, test) +
        fmt::format("the stretch runs back: {} branches, {} of loading and {} of unloading, are taken as one "
                    "curve; an elastic solid has one: --branch loading, unloading or a number keeps what is meant.",
                    all, loading, all - static_cast<std::size_t>(loading)));
  else
    sentences.push_back(of_test(table, test) +
                        fmt::format("the stretch starts anew {} time{}: {} curves in one file are taken as "
                                    "one solid's; --where keeps one.",
                                    restarts, restarts == 1 ? "" : "s", all));
}

void holds(const CsvTable& table, const FoundColumns& found, const Followed& test,
           std::vector<std::string>& sentences) {
  const std::vector<HeldRows> all = holds_of(test);
  if (all.empty()) return;
  const Met &first = test.points[all[0].begin], &last = test.points[all[0].end];
  sentences.push_back(of_test(table, test) +
                      fmt::format("{}: the stress falls from {} to {} at the constant {} (lines {} to {}): relaxation, "
                                  "which no elastic solid has; --without holds leaves such rows out.",
                                  page::counted(static_cast<long>(all.size()), "hold"),
                                  page::quantity(first.stress, dimension::pressure),
                                  page::quantity(last.stress, dimension::pressure), stretch_of(table, found, first),
                                  table.rows[first.row].line, table.rows[last.row].line));
}

void peak(const CsvTable& table, const FoundColumns& found, const Followed& test, std::vector<std::string>& sentences) {
  const Top top = top_of(test, 0, test.points.size() - 1);
  if (test.points[top.at].strain > 0.98 * test.longest || !(top.fallen_to < fallen)) return;
  sentences.push_back(
      of_test(table, test) +
      fmt::format("the stress peaks at {} and falls to {:.0f} % of that: a falling branch (failure, slip or "
                  "damage), which no elastic solid has; --until peak, or {}, keeps what is before it.",
                  stretch_of(table, found, test.points[top.at]), 100 * top.fallen_to,
                  rows_kept(table, found, test.points[top.at], test.points.back(), Keep::up_to)));
}

// Stress where there is no strain.
bool offset(const CsvTable& table, const Followed& test, std::vector<std::string>& sentences) {
  for (const Met& point : test.points) {
    if (point.strain > standing * test.longest || std::abs(point.stress) < offset_share * test.largest) continue;
    sentences.push_back(
        of_test(table, test) +
        fmt::format("an offset: the stress is {} at stretch 1 ({:.2g} % of the largest): a preload, or a zero that "
                    "is none; take it off the column.",
                    page::quantity(point.stress, dimension::pressure), 100 * std::abs(point.stress) / test.largest));
    return true;
  }
  return false;
}

// Standard deviation of one stress, from the second differences of neighbours: their median size, as of normal errors.
double noise_of(const std::vector<Met>& points) {
  std::vector<double> bends;
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    bends.push_back(std::abs(points[i - 1].stress - 2 * points[i].stress + points[i + 1].stress));
  const auto middle = bends.begin() + static_cast<std::ptrdiff_t>(bends.size() / 2);
  std::nth_element(bends.begin(), middle, bends.end());
  return *middle / 0.6745 / std::sqrt(6.0);
}

// The points of a branch up to `end`; of many the means of neighbours, each in the row of its last.
std::vector<Met> coarsened(const Followed& test, std::size_t end) {
  std::vector<Met> all(test.points.begin(), test.points.begin() + static_cast<std::ptrdiff_t>(end) + 1);
  if (all.size() <= 2 * coarse) return all;
  std::vector<Met> means;
  for (std::size_t k = 0; k < coarse; ++k) {
    const std::size_t from = k * all.size() / coarse, to = (k + 1) * all.size() / coarse;
    Met mean{0, 0, all[to - 1].row};
    for (std::size_t i = from; i < to; ++i) {
      mean.strain += all[i].strain / static_cast<double>(to - from);
      mean.stress += all[i].stress / static_cast<double>(to - from);
    }
    means.push_back(mean);
  }
  return means;
}

// Hardly any slope at first, then all at once that of the curve.
void toe(const CsvTable& table, const FoundColumns& found, const Followed& test, std::size_t last,
         std::vector<std::string>& sentences) {
  const std::vector<Met> p = coarsened(test, last);
  const std::size_t end = p.size() - 1;
  const double whole = (p[end].stress - p[0].stress) / (p[end].strain - p[0].strain), noise = noise_of(p);
  std::size_t knee = 0;
  double sharpest = toe_kink;  // the knee is the last place half as sharp as the sharpest
  for (std::size_t i = 2, j = 2; i < end && p[i].strain <= toe_end * test.longest; ++i) {
    const double length = p[i].strain - p[0].strain;
    while (j < end && p[j].strain < p[i].strain + length) ++j;
    if (!(length > 0) || p[j].strain <= p[i].strain) continue;
    const double before = (p[i].stress - p[0].stress) / length,
                 after = (p[j].stress - p[i].stress) / (p[j].strain - p[i].strain);
    if (!(after > toe_slope * whole) || (after - before) * length < toe_noise * noise) continue;
    const double ratio = after / std::max(std::abs(before), 1e-3 * after);
    if (ratio > toe_kink && ratio > 0.5 * sharpest) sharpest = std::max(sharpest, ratio), knee = i;
  }
  if (knee == 0) return;
  sentences.push_back(
      of_test(table, test) +
      fmt::format(
          "a toe: the first points, to {}, carry next to no stress ({} to {}), behind them the curve is {:.0f} times "
          "as steep: slack or seating; {} leaves them out (and count the stretch from there), --residual absolute "
          "gives "
          "them little weight.",
          stretch_of(table, found, p[knee]), page::quantity(p[0].stress, dimension::pressure),
          page::quantity(p[knee].stress, dimension::pressure), sharpest,
          rows_kept(table, found, p[knee], p[end], Keep::behind)));
}

bool names_specimens(const std::string& name) {
  for (const auto& wanted : {"specimen", "sample", "cycle", "replicate", "batch"})
    if (lower_case(name).find(wanted) != std::string::npos) return true;
  return false;
}

}  // namespace

std::vector<std::string> several_materials(const CsvTable& table, const FoundColumns& found,
                                           const std::vector<Deformation>& modes) {
  std::map<int, std::map<Deformation, std::set<std::string>>> values;
  const auto first = table.cells(table.rows[0]);
  for (int c = 0; c < static_cast<int>(first.size()); ++c) {
    const bool text = !first[c].empty() && !parse_number(first[c], table.dialect.decimal_comma).value;
    const bool read = c == found.x || c == found.y || found.mode == c || found.error == c;
    if (!read && (text || names_specimens(table.columns[c].name))) values[c];
  }
  for (std::size_t i = 0; i < table.rows.size() && !values.empty(); ++i) {
    const auto cells = table.cells(table.rows[i]);
    for (auto& [c, of] : values) of[modes[i]].insert(cells[static_cast<std::size_t>(c)]);
  }
  std::vector<std::string> sentences;
  for (const auto& [c, of] : values)
    for (const auto& [mode, different] : of) {
      if (different.size() < 2 || 2 * different.size() > table.rows.size()) continue;
      std::vector<std::string> some;
      for (const auto& value : different) some.push_back(some.size() < 3 ? in_quotes(value) : "...");
      some.resize(std::min<std::size_t>(some.size(), 4));
      const std::string& header = table.columns[static_cast<std::size_t>(c)].header;
      sentences.push_back(
          fmt::format("{}: {}: column {} has {} values ({}), which are fitted as one solid: --where \"{}={}\" keeps "
                      "one.",
                      table.file, word(mode), in_quotes(header), different.size(), fmt::format("{}", listed(some)),
                      header, *different.begin()));
      break;
    }
  return sentences;
}

std::vector<std::string> shapes(const CsvTable& table, const FoundColumns& found,
                                const std::vector<StressPoint>& points, const RowChoice& choice) {
  std::vector<std::string> sentences;
  for (const Followed& test : followed(points)) {
    if (!(test.longest > 0) || !(test.largest > 0)) continue;
    const std::vector<Branch> branches = branches_of(test);
    if (std::holds_alternative<AllBranches>(choice.branch) && choice.holds != Holds::timed)
      runs_back(table, test, branches, sentences);
    if (choice.holds == Holds::kept) holds(table, found, test, sentences);
    if (choice.until == CurveEnd::last_row && choice.holds != Holds::timed && branches.size() == 1)
      peak(table, found, test, sentences);
    offset(table, test, sentences);
    const bool loaded = std::any_of(branches.begin(), branches.end(), [](const Branch& b) { return b.loading; });
    if (loaded && branches[0].end >= fewest_rows - 1) toe(table, found, test, branches[0].end, sentences);
  }
  return sentences;
}

}  // namespace percal
