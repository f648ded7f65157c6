#include "percal/observe/page/over_time.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/impact/result.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page {
namespace {

constexpr const char* how_to_get_it =
    "This result keeps no history. `percal impact SCENE --history FILE.csv`, or [output] history = true in the scene, "
    "keeps depth, speed, force and energy over time.";

struct TimeUnit {
  const char* name;
  double seconds;
};
TimeUnit unit_for(double longest) {
  if (longest >= 0.1) return {"s", 1};
  if (longest >= 1e-4) return {"ms", 1e-3};
  return longest >= 1e-7 ? TimeUnit{"us", 1e-6} : TimeUnit{"ns", 1e-9};
}

// Every n-th point, so that a plot has some hundreds, and the last.
std::vector<std::size_t> thinned(std::size_t count) {
  constexpr std::size_t most = 250;
  const std::size_t step = std::max<std::size_t>(1, (count + most - 1) / most);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < count; i += step) places.push_back(i);
  if (count > 0 && places.back() != count - 1) places.push_back(count - 1);
  return places;
}

struct Times {
  std::vector<double> values;  // in unit.name
  TimeUnit unit;
  std::vector<std::size_t> places;  // to be drawn
  std::string label() const { return std::string("time since contact, ") + unit.name; }
};
Times times_of(const Json& history) {
  auto values = numbers(at(history, "time_s"));
  const TimeUnit unit = unit_for(values.empty() ? 0 : values.back());
  for (double& value : values) value /= unit.seconds;
  const std::size_t count = values.size();
  return {values, unit, thinned(count)};
}

// A figure of one list of the history.
Figure figure_of(const Times& times, const std::vector<double>& values, const std::string& name,
                 const std::string& title, const std::string& label, const std::string& finding) {
  Figure figure;
  figure.name = name;
  figure.chart.title = title;
  figure.chart.x.label = times.label();
  figure.chart.y.label = label;
  Series line = series("", Mark::line, 1);
  for (const std::size_t i : times.places)
    if (i < values.size()) add_point(line, times.values[i], values[i]);
  add(figure.chart, line);
  figure.caption = finding;
  figure.alt = title + ". " + finding;
  return figure;
}

std::vector<double> scaled(std::vector<double> values, double unit) {
  for (double& value : values) value /= unit;
  return values;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values)
    if (std::isfinite(value)) most = std::max(most, std::abs(value));
  return most;
}

struct ForceUnit {
  const char* name;
  double newtons;
};
ForceUnit force_unit(double largest_force) {
  if (largest_force >= 1e3) return {"kN", 1e3};
  if (largest_force >= 0.1) return {"N", 1};
  if (largest_force >= 1e-4) return {"mN", 1e-3};
  return largest_force >= 1e-7 ? ForceUnit{"uN", 1e-6} : ForceUnit{"nN", 1e-9};
}

// A layer upon what is stacked already.
void stack(Chart& chart, const Times& times, std::vector<double>& height, const std::vector<double>& shares,
           const std::string& name, int colour) {
  Series band = series(name, Mark::band, colour), edge = series("", Mark::line, colour);
  const std::vector<double> below = height;
  for (std::size_t i = 0; i < height.size(); ++i) height[i] += std::isfinite(shares[i]) ? shares[i] : 0;
  for (const std::size_t i : times.places) {
    add_bar(band, times.values[i], height[i], below[i], height[i]);
    add_point(edge, times.values[i], height[i]);
  }
  add(chart, band);
  add(chart, edge);
}

// Stacked, in the order of the ledger: what is left to 1 is the ledger's error.
Figure ledger_figure(const Times& times, const Json& energy) {
  constexpr double small = 0.01;  // terms that never reach it share a layer
  Figure figure;
  figure.name = "energy_over_time";
  figure.chart.title = "The energy ledger over time";
  figure.chart.x.label = times.label();
  figure.chart.y.label = "share of the energy";
  figure.chart.y.low = 0;
  std::vector<double> height(times.values.size(), 0), others = height;
  int colour = 0;
  for (const EnergyTerm& term : energy_terms) {
    const auto shares = numbers(at(energy, term.key));
    if (shares.size() != height.size()) continue;
    if (largest(shares) >= small)
      stack(figure.chart, times, height, shares, term.words, colour++);
    else
      for (std::size_t i = 0; i < others.size(); ++i) others[i] += std::isfinite(shares[i]) ? shares[i] : 0;
  }
  if (largest(others) > 0) stack(figure.chart, times, height, others, "others, each below 1 %", -1);
  double worst = 0;
  for (const double sum : height) worst = std::max(worst, std::abs(sum - 1));
  figure.caption = fmt::format(
      "Shares of the impact energy of the middle replicate, one upon the other. The stack is at 1 within {:.2g} %: "
      "that is the solver's own energy error.",
      100 * worst);
  figure.alt = "The terms of the energy ledger stacked over time. " + figure.caption;
  return figure;
}

}  // namespace

Section impact_energy_section(const Json& result) {
  Section section{.id = "energy", .title = "Where the energy went", .blocks = {}};
  const Json &energy = at(result, "energy"), &history = at(result, "history");
  Table table{
      .caption = "Shares of the impact energy at the end, means of the runs", .rows = {{"", "share"}}, .notes = {}};
  for (const EnergyTerm& term : energy_terms)
    if (const auto share = number(energy, term.key); share && *share != 0)
      table.rows.push_back({term.words, percent(share, 2)});
  table.rows.push_back({"sum", percent(number(energy, "sum"), 2)});
  table.notes = {
      "A sum other than 100 % is the solver's own energy error; the worst of the runs is off by " +
          percent(number(result, "energy_worst_closure"), 3) + ".",
      "Hourglass springs, bulk viscosity and collisions are numerical: they stand for nothing in the material. "
      "What the scene does not have is not listed."};
  add(section, table);
  if (at(history, "energy").is_object())
    add(section, ledger_figure(times_of(history), at(history, "energy")));
  else
    add_sentence(section, how_to_get_it);
  return section;
}

Section impact_history_section(const Json& result) {
  Section section{.id = "history", .title = "Penetration over time", .blocks = {}};
  const Json& history = at(result, "history");
  if (!history.is_object()) return section;
  const Times times = times_of(history);
  const Json& per_metre = maybe(history, "force_N_per_m");  // in plane strain
  const auto tip = numbers(at(history, "tip_m")), speed = numbers(at(history, "speed_m_s")),
             force = numbers(per_metre.is_null() ? at(history, "force_N") : per_metre);
  const ShownUnit depth_unit = length_unit(largest(tip));
  const ForceUnit newtons = force_unit(largest(force));
  const std::string force_words = newtons.name + std::string(per_metre.is_null() ? "" : " per metre of thickness");
  add(section,
      figure_of(times, scaled(tip, depth_unit.size), "tip_over_time", "Depth of the tip over time",
                "depth, " + depth_unit.name, fmt::format("First replicate; deepest {}.", length(largest(tip)))));
  add(section, figure_of(times, speed, "speed_over_time", "Speed over time", "speed downwards, m/s",
                         fmt::format("First replicate; from {:.4g} m/s, negative on the rebound.",
                                     speed.empty() ? NAN : speed.front())));
  add(section,
      figure_of(times, scaled(force, newtons.newtons), "force_over_time", "Force on the particle over time",
                "force upwards, " + force_words,
                fmt::format("First replicate; at most {:.3g} {}. The peaks are single elements: they come and go with "
                            "the mesh.",
                            largest(force) / newtons.newtons, force_words)));
  return section;
}

}  // namespace percal::page
