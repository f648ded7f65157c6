#include "percal/calibrate/hypothesis_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/calibrate/fresh_runs.hpp"
#include "percal/calibrate/hypothesis_fit.hpp"
#include "percal/calibrate/layer_width.hpp"
#include "percal/calibrate/shot_problem.hpp"
#include "percal/page/numbers.hpp"
#include "percal/scene/width.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr double mean_of_normal = 0.7979;  // E|x| of a standard normal number
constexpr double no_influence = 0.05;      // of a depth on a modulus, per cent for each per cent

std::string value_of(const FreeParameter& parameter, double natural) {
  if (parameter.unit == "m") return page::length(natural, 3);
  if (parameter.unit == "s") return page::quantity(natural, dimension::time, 3);
  return parameter.unit == "Pa" ? page::pressure(natural, 3) : page::shown(natural, 3);
}

std::string with_interval(const FreeParameter& parameter, double value, const Interval& interval) {
  return fmt::format("{} ({}{} to {}{})", value_of(parameter, value), interval.low_open ? "below " : "",
                     value_of(parameter, interval.low), interval.high_open ? "above " : "",
                     value_of(parameter, interval.high));
}

// What the fit's scatter would do to a perfect model: nothing can be predicted better.
void scatter_alone(const CalibrationJob& job, const JobFit& fit, std::vector<std::string>& sentences) {
  for (std::size_t g = 0; g < job.groups.size(); ++g) {
    const double scatter = fit.best().scatter[g];
    const bool any = std::any_of(fit.problem.data.begin(), fit.problem.data.end(),
                                 [&](const Datum& d) { return d.group == static_cast<int>(g); });
    if (!any || !(scatter > 0)) continue;
    sentences.push_back(
        fmt::format("The data of \"{}\" scatter by {} about the model beyond their known errors; a perfect model would "
                    "still be off by {} in the mean.",
                    job.groups[g].name, page::rough_percent(scatter), page::rough_percent(mean_of_normal * scatter)));
  }
}

void erosion_in_other_measures(const CalibrationJob& job, const JobFit& fit, const HypothesisResult& result,
                               std::vector<std::string>& sentences) {
  for (std::size_t k = 0; k < result.parameters.size(); ++k) {
    const auto& parameter = job.parameters[result.parameters[k]];
    if (parameter.kind != ParameterKind::erosion_strain) continue;
    const double strain = parameter.free.natural(fit.best().searched[static_cast<Eigen::Index>(k)]);
    const double stretch = 1 + strain;
    sentences.push_back(
        fmt::format("{} {:.3g} (engineering) is the critical stretch {:.3g}, all that depths know: {:.3g} as a true "
                    "strain, {:.3g} as a Green-Lagrange strain.",
                    parameter.free.name, strain, stretch, strain_at(stretch, StrainMeasure::true_strain),
                    strain_at(stretch, StrainMeasure::green_lagrange)));
  }
}

// What the laws of a material make of its numbers over its shots.
void laws_over_the_shots(const CalibrationJob& job, const HypothesisResult& result,
                         std::vector<std::string>& sentences) {
  if (result.minima.empty()) return;
  const Hypothesis& hypothesis = job.hypotheses[result.index];
  const auto natural = natural_values(job, hypothesis, result.parameters, result.minima.front().searched);
  for (std::size_t m = 0; m < job.materials.size(); ++m) {
    const MaterialAt at = material_at(job, hypothesis, static_cast<int>(m), natural);
    const auto of_shots = [&](const auto& number) {
      double least = INFINITY, most = 0;
      for (const MeasuredShot& shot : job.shots) {
        if (!meets(job, shot, static_cast<int>(m))) continue;
        least = std::min(least, number(shot));
        most = std::max(most, number(shot));
      }
      return std::pair(least, most);
    };
    if (at.laws.rate_exponent != 0) {
      const auto [slow, fast] = of_shots([](const MeasuredShot& shot) { return shot.speed / shot.radius; });
      if (fast > 0)
        sentences.push_back(
            fmt::format("mu of {} is meant at {:.3g} 1/s and goes as the rate to the power {:.3g}: over its shots, "
                        "{:.3g} to {:.3g} "
                        "1/s (speed over radius), from {} to {}, true.",
                        job.materials[m].name, at.laws.reference_rate, at.laws.rate_exponent, slow, fast,
                        page::pressure(at.mu_true * rate_factor(at.laws, slow)),
                        page::pressure(at.mu_true * rate_factor(at.laws, fast))));
    }
    if (!at.laws.relaxation.terms.empty()) {
      const auto [slow, fast] = of_shots([](const MeasuredShot& shot) { return shot.speed / shot.radius; });
      const std::string long_term = page::pressure(at.mu_true * lasting_share(at.laws.relaxation));
      sentences.push_back(
          fmt::format("mu of {} is the instantaneous modulus, {} true, and relaxes to {}", job.materials[m].name,
                      page::pressure(at.mu_true), long_term) +
          (fast > 0 ? fmt::format("; over its shots, {:.3g} to {:.3g} 1/s (speed over radius), {} to {} is met.", slow,
                                  fast, page::pressure(at.mu_true * rate_factor(at.laws, slow)),
                                  page::pressure(at.mu_true * rate_factor(at.laws, fast)))
                    : "."));
    }
    if (at.laws.cell > 0) {
      const auto below = std::ranges::count_if(job.shots, [&](const MeasuredShot& shot) {
        return meets(job, shot, static_cast<int>(m)) && is_below_cell(at.laws, shot.radius);
      });
      sentences.push_back(fmt::format(
          "{} erodes at {:.3g} under spheres of a diameter below {}, {} of its shots, and at {:.3g} under larger ones.",
          job.materials[m].name, at.laws.erosion_strain_below, page::length(at.laws.cell, 3), below,
          at.erosion_strain));
    }
    if (at.laws.size_exponent != 0) {
      const auto [small, large] = of_shots([](const MeasuredShot& shot) { return shot.radius; });
      if (large > 0)
        sentences.push_back(
            fmt::format("The erosion strain of {} is meant for a radius of {} and goes as the radius to the power "
                        "{:.3g}: {:.3g} for "
                        "spheres of {}, {:.3g} for {}. Where each element is judged by itself, all at one number of "
                        "elements per radius.",
                        job.materials[m].name, page::length(at.laws.reference_radius, 3), at.laws.size_exponent,
                        at.erosion_strain * size_factor(at.laws, small), page::length(small, 3),
                        at.erosion_strain * size_factor(at.laws, large), page::length(large, 3)));
    }
  }
}

// The length beside the spheres of its material, and the meshes that it makes.
void erosion_length_in_radii(const CalibrationJob& job, const HypothesisResult& result,
                             std::vector<std::string>& sentences) {
  if (!has_erosion_length(job) || result.minima.empty()) return;
  const Hypothesis& hypothesis = job.hypotheses[result.index];
  const auto natural = natural_values(job, hypothesis, result.parameters, result.minima.front().searched);
  for (std::size_t m = 0; m < job.materials.size(); ++m) {
    double least = INFINITY, most = 0;
    const double length = *material_at(job, hypothesis, static_cast<int>(m), natural).erosion_length;
    for (const MeasuredShot& shot : job.shots) {
      if (!meets(job, shot, static_cast<int>(m))) continue;
      least = std::min(least, length / shot.radius);
      most = std::max(most, length / shot.radius);
    }
    if (most == 0) continue;
    const double elements = job.training.verify;
    sentences.push_back(fmt::format(
        "Erosion of {} is judged over {}: {:.2g} to {:.2g} radii of its spheres, with {:g} elements in it on the "
        "finest mesh, {:.3g} to {:.3g} per radius.{}",
        job.materials[m].name, page::length(length, 3), least, most, elements, elements / most, elements / least,
        most > 1 ? " Over more than one radius, the average hardly tells the tip of the channel from its wall." : ""));
  }
}

// A curve's modulus is what the hypothesis takes the job's moduli for: mu, or MU1.
void moduli_beside_curves(const Hypothesis& hypothesis, const HypothesisResult& result,
                          std::vector<std::string>& sentences) {
  const bool is_mu1 = hypothesis.convention == ModulusConvention::mu_over_alpha;
  for (const MaterialModuli& m : result.moduli) {
    if (!m.curve_modulus) continue;
    const Estimate& needed = is_mu1 ? m.mu_over_alpha : m.mu_true;
    const double low = needed.interval.low, high = needed.interval.high;
    if (low == high) continue;  // held
    const bool agree = low <= *m.curve_modulus && *m.curve_modulus <= high;
    sentences.push_back(fmt::format("{}: the depths need {} = {} ({} to {}), its curve says {}: {}.", m.material,
                                    is_mu1 ? "MU1" : "mu", page::pressure(needed.value, 3), page::pressure(low, 3),
                                    page::pressure(high, 3), page::pressure(m.curve_modulus, 3),
                                    agree ? "no contradiction" : "they contradict each other"));
  }
}

// What the finest mesh of the runs is still worth.
void mesh_error(const HypothesisResult& result, std::vector<std::string>& sentences) {
  if (result.mesh_error != 0)
    sentences.push_back(fmt::format("Extrapolated to no mesh the depths would change by {} in the mean.",
                                    page::signed_percent(result.mesh_error)));
}

void synthetic_curves(const CalibrationJob& job, std::vector<std::string>& sentences) {
  for (const MeasuredCurve& curve : job.curves)
    if (curve.synthetic)
      sentences.push_back(fmt::format("The curve \"{}\" is synthetic: generated, not measured.", curve.name));
}

}  // namespace

std::vector<std::string> hypothesis_findings(const CalibrationJob& job, const JobFit& fit,
                                             const HypothesisResult& result) {
  std::vector<std::string> sentences = findings(fit.problem, fit.minima, result.intervals);
  erosion_in_other_measures(job, fit, result, sentences);
  erosion_length_in_radii(job, result, sentences);
  laws_over_the_shots(job, result, sentences);
  moduli_beside_curves(job.hypotheses[result.index], result, sentences);
  scatter_alone(job, fit, sentences);
  mesh_error(result, sentences);
  for (const ErrorBudget& budget : result.budgets)
    if (std::abs(budget.influence) > no_influence)
      sentences.push_back(fmt::format("{} hangs most on {}: {:+.2g} % for each per cent of that depth.",
                                      budget.quantity, budget.most_influential, budget.influence));
  synthetic_curves(job, sentences);
  return sentences;
}

namespace {

// A hypothesis that holds a number is set beside the first one that leaves it free.
void held_against_free(const CalibrationJob& job, const CalibrationResult& result,
                       std::vector<std::string>& sentences) {
  for (const HypothesisResult& holding : result.hypotheses)
    for (const auto& [parameter, value] : job.hypotheses[holding.index].held)
      for (const HypothesisResult& freeing : result.hypotheses) {
        const auto place = std::find(freeing.parameters.begin(), freeing.parameters.end(), parameter);
        const auto& a = job.hypotheses[holding.index];
        const auto& b = job.hypotheses[freeing.index];
        if (place == freeing.parameters.end() || a.convention != b.convention) continue;
        const auto k = static_cast<std::size_t>(place - freeing.parameters.begin());
        const FreeParameter& p = job.parameters[parameter].free;
        const Interval& interval = freeing.intervals[k].interval;
        const double best = p.natural(freeing.minima[0].searched[static_cast<Eigen::Index>(k)]);
        const bool inside = interval.low <= value && value <= interval.high;
        sentences.push_back(fmt::format("\"{}\" holds {} at {}, {} of \"{}\", which finds {}.", a.name, p.name,
                                        value_of(p, value), inside ? "within the interval" : "outside the interval",
                                        b.name, with_interval(p, best, interval)));
        break;
      }
}

void fresh_against_emulated(const CalibrationJob& job, const CalibrationResult& result,
                            std::vector<std::string>& sentences) {
  for (const HypothesisResult& hypothesis : result.hypotheses) {
    const auto failed =
        std::count_if(hypothesis.fresh.begin(), hypothesis.fresh.end(), [](const auto& r) { return !r.depth; });
    const auto count = static_cast<long>(hypothesis.fresh.size()) - failed;
    if (count == 0) continue;
    const double off = spread(hypothesis.fresh);
    sentences.push_back(fmt::format(
        "\"{}\": {} fresh runs on {} {} lie {:.2g} of the emulator's stated errors from "
        "it (1 is right{}){}{}.",
        job.hypotheses[hypothesis.index].name, count, job.training.verify, mesh_words(job), off,
        off > trusted_spread ? "; this is too much: its errors are larger than stated" : "",
        std::ranges::any_of(hypothesis.fresh, [&](const auto& r) { return r.depth && job.shots[r.shot].is_number(); })
            ? " and " + page::percent(hypothesis.fresh_deviation) + " from the measured depths"
            : "",
        failed > 0 ? fmt::format("; {} did not come to rest", failed) : ""));
  }
}

// Quasi-static E over the hypotheses: what the choices alone are worth.
void spread_over_hypotheses(const CalibrationJob& job, const CalibrationResult& result,
                            std::vector<std::string>& sentences) {
  for (std::size_t m = 0; m < job.materials.size(); ++m) {
    double low = 0, high = 0;
    int count = 0;
    for (const HypothesisResult& hypothesis : result.hypotheses) {
      if (m >= hypothesis.moduli.size() || !hypothesis.moduli[m].youngs_quasi_static_true) continue;
      const double e = hypothesis.moduli[m].youngs_quasi_static_true->value;
      low = count == 0 ? e : std::min(low, e);
      high = count == 0 ? e : std::max(high, e);
      ++count;
    }
    if (count > 1)
      sentences.push_back(fmt::format(
          "{}: the hypotheses put the quasi-static E = 3 mu between {} and {}: a choice that the depths do not settle.",
          job.materials[m].name, page::pressure(low, 3), page::pressure(high, 3)));
  }
}

void closed_form_beside(const CalibrationResult& result, std::vector<std::string>& sentences) {
  if (!result.dehn) return;
  int tasks = 0, better = 0;
  const auto compare = [&](const std::vector<CrossValidationResult>& ours,
                           const std::vector<CrossValidationResult>& closed) {
    for (const CrossValidationResult& one : ours)
      for (const CrossValidationResult& theirs : closed) {
        if (one.name != theirs.name || one.prediction.shots == 0) continue;
        ++tasks;
        better += theirs.prediction.mean_absolute < one.prediction.mean_absolute;
      }
  };
  for (const HypothesisResult& hypothesis : result.hypotheses) {
    compare(hypothesis.cross_validations, result.dehn->cross_validations);
    compare(hypothesis.leave_one_out, result.dehn->leave_one_out);
  }
  if (tasks > 0)
    sentences.push_back(fmt::format(
        "Dehn's closed form, two numbers for a material, predicts better in {} of {} predictions.", better, tasks));
}

// How far the solver knows what it says beside the depth.
void numbers_beside_depth(const CalibrationResult& result, std::vector<std::string>& sentences) {
  for (const BesideReport& beside : result.emulator.beside) {
    if (!(beside.mean > 0) || beside.of.body != 0) continue;
    sentences.push_back(fmt::format(
        "Of {} runs {} told the {}: {} is {:.2g} in their mean, and one run scatters by {} "
        "about it.{}",
        beside.runs + beside.without, beside.runs, kind_of(beside.of.number).words, kind_of(beside.of.number).learnt,
        beside.mean, page::rough_percent(beside.noise), kind_of(beside.of.number).caution));
  }
}

void the_wall(const CalibrationJob& job, const CalibrationResult& result, std::vector<std::string>& sentences) {
  const auto sphere = std::ranges::find(job.shots, 0, place_of_body);
  if (sphere == job.shots.end() || result.hypotheses.empty()) return;
  const double width = sphere->layer_width / sphere->radius;
  const std::string warning = width_warning(width, width_needed(job));
  if (job.width_was_chosen)
    sentences.push_back(fmt::format("The wall is at {:.4g} radii for all shots, far enough for any.", width));
  else if (!warning.empty())
    sentences.push_back("Within the parameters' bounds " + warning + ".");
}

// Erosion judges each element by itself: a strain belongs to a size of elements.
void elements_of_bodies(const CalibrationJob& job, std::vector<std::string>& sentences) {
  std::map<int, std::pair<double, double>> sizes;  // m, of each body on the verifying mesh
  for (const MeasuredShot& shot : job.shots) {
    const double size = shot.radius / mesh_of(shot, LayerMaterial{}, job.training.verify);
    const auto [place, is_new] = sizes.try_emplace(place_of_body(shot), size, size);
    auto& [low, high] = place->second;
    low = std::min(low, size);
    high = std::max(high, size);
  }
  if (job.bodies.empty() || sizes.size() < 2) return;
  std::vector<std::string> all;
  for (const auto& [place, range] : sizes) {
    const auto& [low, high] = range;
    all.push_back(fmt::format("{} of {}",
                              low < high ? page::length(low, 2) + " to " + page::length(high, 2) : page::length(low, 2),
                              place == 0 ? "spheres" : job.bodies[place - 1]->name()));
  }
  sentences.push_back(
      fmt::format("On the mesh of the answer elements measure {}. A material's erosion strain is taken for the "
                  "same on all of them, as on spheres of several sizes.",
                  listed(all)));
}

}  // namespace

std::vector<std::string> overall_findings(const CalibrationJob& job, const CalibrationResult& result) {
  std::vector<std::string> sentences;
  for (const auto& curve : job.curves)
    for (const auto& source : curve.data.sources)
      for (const auto& said : {source.warnings, source.taken})
        sentences.insert(sentences.end(), said.begin(), said.end());
  if (job.solver.contact_stiffness_was_given) sentences.push_back(std::string(contact_stiffness_warning) + ".");
  held_against_free(job, result, sentences);
  spread_over_hypotheses(job, result, sentences);
  fresh_against_emulated(job, result, sentences);
  closed_form_beside(result, sentences);
  numbers_beside_depth(result, sentences);
  the_wall(job, result, sentences);
  elements_of_bodies(job, sentences);
  return sentences;
}

}  // namespace percal
