#include "percal/study/error_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/plot/quoted.hpp"

namespace percal {
namespace {

constexpr std::array<const char*, 3> colours{"#c8553d", "#1b6ca8", "#4d8f3c"};

// Where the processor time of a series starts and ends, with room beside it.
struct Span {
  double from, to;
};
Span seconds_of(const Ladder& ladder, const ErrorVsTime& study) {
  double low = HUGE_VAL, high = 0;
  for (std::size_t i = study.first_used; i < ladder.meshes.size(); ++i) {
    low = std::min(low, ladder.meshes[i].cpu_seconds);
    high = std::max(high, ladder.meshes[i].cpu_seconds);
  }
  return {std::max(low, 1e-6) / 1.6, std::max(high, 1e-6) * replicate_counts.back() * 1.6};
}

double percent(double share) { return std::max(100 * share, 1e-4); }

std::string data_block(const Ladder& ladder, const ErrorVsTime& study, std::size_t count) {
  std::string block = fmt::format("$mean{} << EOD\n", replicate_counts[count]);
  for (std::size_t i = 0; i < study.errors.size(); ++i) {
    const Rung& rung = ladder.meshes[study.first_used + i];
    const ErrorBand& error = study.errors[i].combined[count];
    block += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g} {}\n", rung.cpu_seconds * replicate_counts[count],
                         percent(error.value), percent(error.low), percent(error.high), rung.elements_per_radius);
  }
  return block + "EOD\n";
}

}  // namespace

std::string error_plot_script(const Ladder& ladder, const ErrorVsTime& study, const std::string& title) {
  std::string script;
  double lowest = HUGE_VAL, highest = 0;
  for (const RungError& error : study.errors)
    for (const ErrorBand& mean : error.combined) {
      lowest = std::min(lowest, percent(mean.low));
      highest = std::max(highest, percent(mean.high));
    }
  for (std::size_t c = 0; c < replicate_counts.size(); ++c) script += data_block(ladder, study, c);
  const Span seconds = seconds_of(ladder, study);
  script += fmt::format(R"(set terminal svg size 860,480 font "sans,13" background rgb "white" dynamic
set title {0} noenhanced
set label 1 "small numbers: elements per radius" at graph 0.99,0.97 right font ",11" tc rgb "{5}"
set xlabel "processor time of all runs, s"
set ylabel "error of the mean depth, % of the extrapolated one"
set logscale xy
set xrange [{1:.6g}:{2:.6g}]
set yrange [{3:.6g}:{4:.6g}]
set border 3 lw 0.8
set tics nomirror out
set ytics add (0.2,0.5,1,2,5,10,20,50) format "%g"
set xtics format "%g"
set key outside right top samplen 1.5 spacing 1.2
set arrow from {1:.6g},5 to {2:.6g},5 nohead lw 0.6 lc rgb "#cccccc" back
set arrow from {1:.6g},2 to {2:.6g},2 nohead lw 0.6 lc rgb "#cccccc" back
set arrow from {1:.6g},1 to {2:.6g},1 nohead lw 0.6 lc rgb "#cccccc" back
)",
                        gnuplot_quoted(title), seconds.from, seconds.to, lowest / 1.3, std::max(highest * 1.3, 6.0),
                        colours[0]);
  std::string plot;
  for (std::size_t c = 0; c < replicate_counts.size(); ++c) {
    const int count = replicate_counts[c];
    const std::string name = count == 1 ? "one run" : fmt::format("mean of {}", count);
    plot += fmt::format("{}$mean{} using 1:2:3:4 with yerrorlines pt 7 ps 0.6 lw 1.3 lc rgb \"{}\" title \"{}\", \\\n",
                        plot.empty() ? "plot " : "     ", count, colours[c], name);
    plot += fmt::format("     {:.6g} with lines dt 2 lw 0.9 lc rgb \"{}\" title \"its noise\", \\\n",
                        percent(study.model.noise / std::sqrt(count)), colours[c]);
  }
  plot += fmt::format("     $mean1 using 1:2:5 with labels right offset -0.7,-0.7 font \",10\" tc rgb \"{}\" notitle\n",
                      colours[0]);
  return script + plot;
}

}  // namespace percal
