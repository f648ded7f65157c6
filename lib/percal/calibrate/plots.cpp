#include "percal/calibrate/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "percal/plot/quoted.hpp"

namespace percal {
namespace {

constexpr std::array<const char*, 8> colours{"#c8553d", "#1b6ca8", "#4d8f3c", "#8a5fa8",
                                             "#b8860b", "#3a9d9d", "#7f7f7f", "#d1749c"};
const char* colour(std::size_t k) { return colours[k % colours.size()]; }

std::string heading(const std::string& title, const std::string& x, const std::string& y) {
  return fmt::format(R"(set terminal svg size 860,520 font "sans,13" background rgb "white" dynamic
set title {} noenhanced
set xlabel {} noenhanced
set ylabel {} noenhanced
set border 3 lw 0.8
set tics nomirror out
set key outside right top samplen 1.5 spacing 1.2 noenhanced
)",
                     gnuplot_quoted(title), gnuplot_quoted(x), gnuplot_quoted(y));
}

// A plot grows series by series: a block of data, and how it is drawn.
struct Script {
  std::string blocks, plot;
  int series = 0;

  void add(const std::string& data, const std::string& drawn) {
    ++series;
    blocks += fmt::format("$s{} << EOD\n{}EOD\n", series, data);
    plot += fmt::format("{}$s{} {}", plot.empty() ? "plot " : ", \\\n     ", series, drawn);
  }
  std::string text(const std::string& head) const { return head + blocks + plot + "\n"; }
};

// The numbers of a logarithmic axis.
struct Extent {
  double low = HUGE_VAL, high = 0;

  void take(double value) {
    if (!(value > 0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // A range with room on both sides, and tics at 1, 2 and 5 of every decade.
  std::string axis(char name) const {
    if (!(low <= high)) return "";
    const double room = 1.3, first = low / room, last = high * room;
    std::string tics;
    for (int decade = static_cast<int>(std::floor(std::log10(first))); decade <= std::log10(last); ++decade)
      for (const int step : {1, 2, 5})
        if (const double at = step * std::pow(10, decade); first <= at && at <= last)
          tics += fmt::format("{}{:.3g}", tics.empty() ? "" : ",", at);
    return fmt::format("set {0}range [{1:.5g}:{2:.5g}]\nset {0}tics ({3})\n", name, first, last, tics);
  }
};

// --- ridges -----------------------------------------------------------------------------------------------------

// A hypothesis's ridge of one modulus, if it has one.
const RidgeMap* ridge_of(const HypothesisResult& hypothesis, int modulus) {
  for (const RidgeMap& map : hypothesis.ridges)
    if (hypothesis.parameters[map.second] == modulus) return &map;
  return nullptr;
}

double best_at(const CalibrationJob& job, const HypothesisResult& hypothesis, int place) {
  return job.parameters[hypothesis.parameters[place]].free.natural(hypothesis.minima.front().searched[place]);
}

std::string contour_points(const RidgeMap& map) {
  std::string points;
  for (const auto& line : map.contours) {
    for (const auto& [x, y] : line) points += fmt::format("{:.5g} {:.5g}\n", x, y);
    points += "\n";
  }
  return points;
}

void add_hypothesis(const CalibrationJob& job, const HypothesisResult& hypothesis, int modulus, Script& script,
                    std::string& csv, Extent& extent) {
  const RidgeMap* map = ridge_of(hypothesis, modulus);
  if (!map || hypothesis.minima.empty()) return;
  const std::string& name = job.hypotheses[hypothesis.index].name;
  const double strain = best_at(job, hypothesis, map->first), mu = best_at(job, hypothesis, map->second);
  const char* const drawn_in = colour(static_cast<std::size_t>(hypothesis.index));
  if (!map->contours.empty())
    script.add(contour_points(*map),
               fmt::format("with lines lw 1.5 lc rgb \"{}\" title {}", drawn_in, gnuplot_quoted(name)));
  script.add(fmt::format("{:.5g} {:.5g}\n", strain, mu),
             fmt::format("with points pt 7 ps 0.8 lc rgb \"{}\" {}", drawn_in,
                         map->contours.empty() ? "title " + gnuplot_quoted(name) : "notitle"));
  extent.take(mu);
  csv += fmt::format("{},best,0,{:.8g},{:.8g}\n", csv_quoted(name), strain, mu);
  for (std::size_t line = 0; line < map->contours.size(); ++line)
    for (const auto& [x, y] : map->contours[line]) {
      extent.take(y);
      csv += fmt::format("{},level set,{},{:.8g},{:.8g}\n", csv_quoted(name), line + 1, x, y);
    }
}

void add_published(const CalibrationJob& job, int modulus, Script& script, std::string& csv, Extent& extent) {
  for (const PublishedPairs& published : job.published) {
    if (published.modulus != modulus) continue;
    std::string points;
    for (const PublishedPair& pair : published.pairs) {
      extent.take(pair.mu);
      points += fmt::format("{:.5g} {:.5g}\n", pair.erosion_strain, pair.mu);
      csv += fmt::format("{},published,0,{:.8g},{:.8g}\n", csv_quoted(published.name), pair.erosion_strain, pair.mu);
    }
    script.add(points,
               fmt::format("with points pt 4 ps 0.9 lc rgb \"black\" title {}", gnuplot_quoted(published.name)));
  }
}

Plot ridge_plot(const CalibrationJob& job, const CalibrationResult& result, int modulus) {
  const std::string& name = job.parameters[modulus].free.name;
  Script script;
  Extent extent;
  std::string csv = "of,kind,line,erosion_strain,mu_as_given_Pa\n";
  for (const HypothesisResult& hypothesis : result.hypotheses)
    add_hypothesis(job, hypothesis, modulus, script, csv, extent);
  add_published(job, modulus, script, csv, extent);
  return {"ridge_" + name, csv,
          script.text(heading("What the data allow: " + name + " over the erosion strain (95 % regions)",
                              "erosion strain", name + " as given, Pa") +
                      "set logscale y\nset format y \"%.0s %cPa\"\n" + extent.axis('y'))};
}

// --- depths -----------------------------------------------------------------------------------------------------

// In radii, so that large and small balls share a plot.
std::string depth_row(const MeasuredShot& shot, const ShotDepth& depth) {
  return fmt::format("{:.5g} {:.5g} {:.5g} {:.5g}\n", shot.depth / shot.radius, depth.depth / shot.radius,
                     depth.low / shot.radius, depth.high / shot.radius);
}

Plot depth_plot(const CalibrationJob& job, const HypothesisResult& hypothesis) {
  Script script;
  std::string csv = "label,set,measured_m,at_least,model_m,low_m,high_m,fitted\n";
  Extent extent;
  for (std::size_t s = 0; s < job.sets.size(); ++s) {
    std::string fitted, predicted;
    for (const ShotDepth& depth : hypothesis.shots) {
      const MeasuredShot& shot = job.shots[depth.shot];
      if (shot.set != static_cast<int>(s)) continue;
      (depth.fitted ? fitted : predicted) += depth_row(shot, depth);
      for (const double value : {shot.depth, depth.depth}) extent.take(value / shot.radius);
      csv += fmt::format("{},{},{:.8g},{},{:.8g},{:.8g},{:.8g},{}\n", csv_quoted(shot.label),
                         csv_quoted(job.sets[s].name), shot.depth, shot.at_least ? "yes" : "no", depth.depth, depth.low,
                         depth.high, depth.fitted ? "yes" : "no");
    }
    const auto add = [&](const std::string& points, int point_type, const std::string& of) {
      if (!points.empty())
        script.add(points, fmt::format("using 1:2:3:4 with yerrorbars pt {} ps 0.6 lc rgb \"{}\" title {}", point_type,
                                       colour(s), gnuplot_quoted(job.sets[s].name + of)));
    };
    add(fitted, 7, ", fitted");
    add(predicted, 6, ", predicted");
  }
  script.plot +=
      fmt::format("{}x with lines lw 0.8 lc rgb \"#888888\" notitle", script.plot.empty() ? "plot " : ", \\\n     ");
  return {fmt::format("depths_{}", hypothesis.index + 1), csv,
          script.text(heading("Depths: " + job.hypotheses[hypothesis.index].name, "measured, radii",
                              "model, radii; interval of one shot") +
                      "set logscale xy\n" + extent.axis('x') + extent.axis('y'))};
}

// --- error against time -----------------------------------------------------------------------------------------

Plot time_plot(const CalibrationResult& result) {
  Script script;
  Extent seconds, errors;
  std::string csv = "emulator,runs,cpu_s,error_at_optimum,data_error\n";
  for (std::size_t e = 0; e < result.emulators.size(); ++e) {
    const EmulatorReport& emulator = result.emulators[e];
    std::string points;
    for (const auto& round : emulator.rounds) {
      csv += fmt::format("{},{},{:.6g},{:.6g},{:.6g}\n", csv_quoted(emulator.setting), round.runs, round.cpu_seconds,
                         round.error, emulator.data_error);
      if (!(round.cpu_seconds > 0 && round.error > 0)) continue;
      points += fmt::format("{:.5g} {:.5g} {}\n", round.cpu_seconds, 100 * round.error, round.runs);
      seconds.take(round.cpu_seconds);
      errors.take(100 * round.error);
    }
    if (points.empty()) continue;
    script.add(points, fmt::format("using 1:2 with linespoints pt 7 ps 0.6 lw 1.3 lc rgb \"{}\" title {}", colour(e),
                                   gnuplot_quoted(emulator.setting)));
    if (!(emulator.data_error > 0)) continue;
    errors.take(100 * emulator.data_error);
    script.plot += fmt::format(", \\\n     {:.5g} with lines dt 2 lw 0.9 lc rgb \"{}\" title \"the data's\"",
                               100 * emulator.data_error, colour(e));
  }
  return {"error_vs_time", csv,
          script.series == 0 ? ""
                             : script.text(heading("The emulators' error at the optimum against processor time",
                                                   "processor time of the runs, s", "error of a depth, %") +
                                           "set logscale xy\n" + seconds.axis('x') + errors.axis('y'))};
}

}  // namespace

std::vector<Plot> calibration_plots(const CalibrationJob& job, const CalibrationResult& result) {
  std::vector<Plot> plots;
  for (int k = 0; k < static_cast<int>(job.parameters.size()); ++k)
    if (std::any_of(result.hypotheses.begin(), result.hypotheses.end(),
                    [k](const HypothesisResult& r) { return ridge_of(r, k); }))
      plots.push_back(ridge_plot(job, result, k));
  for (const HypothesisResult& hypothesis : result.hypotheses)
    if (!hypothesis.shots.empty()) plots.push_back(depth_plot(job, hypothesis));
  if (!result.emulators.empty()) plots.push_back(time_plot(result));
  return plots;
}

}  // namespace percal
