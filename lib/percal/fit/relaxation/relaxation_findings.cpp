// What a fit of relaxation leaves open, in sentences.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/fit/interval/findings.hpp"
#include "percal/fit/relaxation/fit_relaxation.hpp"
#include "percal/page/numbers.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr double worth_a_word = 2;     // of AICc
constexpr double nothing_left = 1e-3;  // of the instantaneous modulus
constexpr const char* tests = "The record";

std::string seconds(double time) { return page::quantity(time, dimension::time, 3); }

const ParameterUncertainty* parameter_of(const RelaxationFit& fit, const std::string& name) {
  const auto found = std::ranges::find(fit.parameters, name, &ParameterUncertainty::name);
  return found == fit.parameters.end() ? nullptr : &*found;
}

// A time beyond what the rows follow, or that may lie there.
void time_beyond_the_rows(const RelaxationFit& fit, int k, double time, std::vector<std::string>& sentences) {
  const auto& [shortest, longest] = fit.scales;
  const std::string name = fmt::format("tau_{}", k + 1);
  const ParameterUncertainty* known = parameter_of(fit, name);
  const bool may_be_short = known && known->interval.low < shortest,
             may_be_long = known && known->interval.high > longest;
  if (time < shortest || may_be_short)
    sentences.push_back(
        fmt::format("{} {} shorter than the shortest time between two rows, {}: how fast that part relaxes, and how "
                    "much of it there "
                    "is, the rows do not follow; g_{} and mu_0 are of what is seen of it.",
                    name, time < shortest ? "= " + seconds(time) + " is" : "may be", seconds(shortest), k + 1));
  if (time > longest || may_be_long)
    sentences.push_back(
        fmt::format("{} {} longer than the longest record, {}: what the stress comes to in the end is not seen; g_{} "
                    "and mu_inf are "
                    "extrapolated.",
                    name, time > longest ? "= " + seconds(time) + " is" : "may be", seconds(longest), k + 1));
}

// Ends of intervals, but those of times, which have words of their own.
void open_ends(const RelaxationFit& fit, std::vector<std::string>& sentences) {
  for (const ParameterUncertainty& parameter : fit.parameters) {
    const bool share = parameter.name.starts_with("g_");
    if (share && parameter.interval.low <= 0) {
      sentences.push_back(fmt::format("{} may be 0: the data do not ask for that term.", parameter.name));
      continue;
    }
    if (parameter.name.starts_with("tau_") && !parameter.identifiable) {
      sentences.push_back(fmt::format("{} hardly determines {}: its {:g} % interval goes from {} to {}.", tests,
                                      parameter.name, 100 * fit.level, seconds(parameter.interval.low),
                                      seconds(parameter.interval.high)));
      continue;
    }
    if (const std::string sentence = undetermined(parameter, tests, fit.level); !sentence.empty())
      sentences.push_back(sentence);
  }
}

const RelaxationRung* rung_of(const RelaxationFit& fit, int terms) {
  const auto found = std::ranges::find(fit.rungs, terms, &RelaxationRung::terms);
  return found == fit.rungs.end() ? nullptr : &*found;
}

void fewer_terms(const RelaxationFit& fit, std::vector<std::string>& sentences) {
  const RelaxationRung* own = rung_of(fit, fit.terms);
  if (!own || !own->aicc) return;
  const RelaxationRung* best = own;
  for (const RelaxationRung& rung : fit.rungs)
    if (rung.terms < fit.terms && rung.aicc && *rung.aicc < *best->aicc) best = &rung;
  if (best == own || *own->aicc - *best->aicc < worth_a_word) return;
  sentences.push_back(fmt::format("AICc wants fewer terms: {} {} by {:.3g}.",
                                  best->terms == 0 ? "no relaxation" : page::counted(best->terms, "term"),
                                  best->terms == 0   ? "wins"
                                  : best->terms == 1 ? "wins"
                                                     : "win",
                                  *own->aicc - *best->aicc));
}

}  // namespace

std::vector<std::string> relaxation_findings(const RelaxationFit& fit) {
  std::vector<std::string> sentences;
  if (fit.terms == 0) {
    sentences.push_back(fit.rungs.size() > 1
                            ? "The data ask for no relaxation: a solid that knows no time has the lowest AICc."
                            : "No relaxing solid could be fitted to these points.");
    return sentences;
  }
  const RelaxationMinimum& best = fit.minima.front();
  if (!best.minimum.converged)
    sentences.push_back("The best minimum of the relaxing solid did not converge within the iterations allowed.");
  if (fit.parameters.empty()) return sentences;
  const auto& terms = best.solid.series.terms;
  for (std::size_t k = 0; k < terms.size(); ++k)
    time_beyond_the_rows(fit, static_cast<int>(k), terms[k].time, sentences);
  if (lasting_share(best.solid.series) < nothing_left)
    sentences.push_back("All of the modulus relaxes: the data want no long-term modulus.");
  open_ends(fit, sentences);
  fewer_terms(fit, sentences);
  if (const std::string misfit =
          systematic_misfit(fit.neighbour_correlation, static_cast<std::size_t>(best.minimum.residual.size()));
      !misfit.empty())
    sentences.push_back(misfit);
  return sentences;
}

}  // namespace percal
