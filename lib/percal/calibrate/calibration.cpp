#include "percal/calibrate/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "percal/calibrate/fresh_runs.hpp"
#include "percal/calibrate/hypothesis_findings.hpp"
#include "percal/calibrate/hypothesis_fit.hpp"
#include "percal/calibrate/kept_model.hpp"
#include "percal/calibrate/run_sizes.hpp"
#include "percal/calibrate/shot_problem.hpp"
#include "percal/calibrate/training.hpp"
#include "percal/page/numbers.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

using Eigen::VectorXd;
using Announce = std::function<void(const std::string&)>;

constexpr int plausible_for_each = 10;  // points of parameter space a round looks at, for each hypothesis
constexpr double temperature = 1.5;     // a little wider than the data allow
constexpr int most_checks = 2;          // of the best points
constexpr std::size_t most_targets = 160, most_candidates = 160;

template <class T>
std::vector<T> evenly(const std::vector<T>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<T> some;
  for (std::size_t k = 0; k < most; ++k) some.push_back(all[k * all.size() / most]);
  return some;
}

// Of one body: depths to be known, and runs to choose from.
struct Round {
  std::vector<Training::Target> targets;
  std::vector<Training::Candidate> candidates;
};

// What is plausible under a hypothesis.
void add_targets(const CalibrationJob& job, int hypothesis, const JobModel& model, const JobFit& fit, unsigned seed,
                 std::map<int, Round>& rounds) {
  const Hypothesis& read = job.hypotheses[hypothesis];
  const VectorXd exponents = model.speed_exponents(fit.at, shots_of(job, fit.shots));
  for (const VectorXd& at : plausible_points(fit, plausible_for_each, temperature, seed)) {
    const auto natural = natural_values(job, read, model.of_job, at);
    for (std::size_t i = 0; i < job.shots.size(); ++i) {
      const MeasuredShot& shot = job.shots[i];
      const CoveredMaterial material = target_at(job, read, job.targets[shot.target], natural);
      const double scatter = fit.best().scatter[shot.group];
      const double known = known_log_error(shot, exponents.size() > 0 ? exponents.mean() : 1);
      auto& [targets, candidates] = rounds[place_of_body(shot)];
      targets.push_back({shot_inputs(shot, material).at, 1 / (scatter * scatter + known * known + 1e-6), shot.number});
      const auto drawn = static_cast<int>(candidates.size());
      const auto on_mesh = [&](double mesh) {
        return shot_problem(job, shot, material, drawn_mesh(mesh_of(shot, material, mesh), seed, drawn));
      };
      candidates.push_back({on_mesh(job.training.coarse), on_mesh(job.training.fine), shot.number});
    }
  }
}

struct Trained {
  FittedHypotheses fitted;         // without fits where too many runs failed
  std::optional<FreshRuns> fresh;  // at the best points of thorough fits, which hold there
  std::string why;                 // no more runs
};

int count_of(const std::vector<Hypothesis>& hypotheses) { return static_cast<int>(hypotheses.size()); }

double element_size(const CalibrationJob& job) { return 1.0 / job.training.verify; }

// The fitted shots of each body, under the hypothesis where its emulator's error is largest beside the data's.
using WorstErrors = std::map<int, ErrorSizes>;

double ratio_of(const ErrorSizes& sizes) { return sizes.data > 0 ? sizes.emulator / sizes.data : 0; }

bool is_sure(const CalibrationJob& job, const ErrorSizes& sizes) { return ratio_of(sizes) <= job.training.accuracy; }

// Why no more runs are needed, or to be had; empty where they are.
std::string why_enough(const CalibrationJob& job, const Training& training, const WorstErrors& worst) {
  if (std::ranges::all_of(worst, [&](const auto& one) { return is_sure(job, one.second); }))
    return fmt::format("the emulator's error is below {:g} of the data's", job.training.accuracy);
  if (std::ranges::all_of(worst, [&](const auto& one) { return is_sure(job, one.second) || training.full(one.first); }))
    return fmt::format("{} runs were made, as many as the job allows", training.runs_of_design());
  if (training.out_of_time()) return "the budget for runs was spent";
  return "";
}

// Every hypothesis searched anew, side by side.
void fit_thoroughly(const CalibrationJob& job, FittedHypotheses& fitted, const Campaign& campaign) {
  campaign.side_by_side(count_of(job.hypotheses), [&](int k) {
    fitted.fits[k] = fit_job(job, fitted.models[k], used_shots(job), thorough_search());
  });
}

// Why there is nothing to fit with; empty where there is.
std::string why_hopeless(const Training& training) {
  if (training.failures()) return *training.failures();
  if (training.has_emulator()) return "";
  if (training.out_of_time()) return "the budget ended before there were enough runs for an emulator";
  const std::string untold = training.untold();
  return untold.empty() ? "too few runs came to rest for an emulator: wider bounds or more runs" : untold;
}

// Rounds of fitting and running until the emulator is surer than the data, in all the hypotheses. Then the best points of all are run
// anew on the verifying mesh: where the runs lie further from the emulator than it says, it learns from them, and says true.
Trained train(const CalibrationJob& job, Training& training, Campaign& campaign, const CalibrationLimits& limits,
              const Announce& announce) {
  training.fill_space();
  int checks = 0;
  std::vector<std::optional<VectorXd>> starts(job.hypotheses.size());
  for (int round = 0;; ++round) {
    Trained trained;
    trained.why = why_hopeless(training);
    if (!trained.why.empty()) return trained;
    std::map<int, Round> rounds;
    WorstErrors errors;
    for (int k = 0; k < count_of(job.hypotheses); ++k) {
      JobModel model = finite_element_model(job, job.hypotheses[k], training.emulators(), element_size(job));
      JobFit fit = fit_job(job, model, used_shots(job), quick_search(), starts[k]);
      if (round % 3 != 2)
        starts[k] = fit.at;  // now and then from everywhere
      else
        starts[k].reset();
      for (const int body : bodies_of(job)) {
        const ErrorSizes sizes = error_sizes(job, model, fit, body);
        ErrorSizes& worst = errors[body];
        if (sizes.data > 0 && ratio_of(sizes) >= ratio_of(worst)) worst = sizes;
      }
      add_targets(job, k, model, fit, job.training.seed + static_cast<unsigned>(round), rounds);
      trained.fitted.models.push_back(std::move(model));
      trained.fitted.fits.push_back(std::move(fit));
    }
    EmulatorReport& report = training.report();
    const auto& [worst_body, worst] =
        *std::ranges::max_element(errors, {}, [](const auto& one) { return ratio_of(one.second); });
    report.error_at_optimum = worst.emulator;
    report.data_error = worst.data;
    if (!report.rounds.empty()) report.rounds.back().error = worst.emulator;
    announce(fmt::format("{} runs{}, emulator's error at the optimum {}, data's {}",
                         training.emulators().depth(worst_body).runs().size(),
                         worst_body == 0 ? "" : " of " + job.bodies[worst_body - 1]->name(),
                         page::rough_percent(worst.emulator), page::rough_percent(worst.data)));
    trained.why = why_enough(job, training, errors);
    if (!trained.why.empty()) {
      if (training.out_of_time() || checks++ == most_checks) return trained;
      fit_thoroughly(job, trained.fitted, campaign);
      FreshRuns fresh =
          fresh_runs(job, trained.fitted, training.emulators(), campaign, limits.deadline(share_for_training));
      announce(fmt::format("fresh runs at the best points lie {:.2g} of the emulator's stated errors from it",
                           fresh.worst_spread()));
      if (!fresh.complete()) return trained;
      if (fresh.worst_spread() <= trusted_spread) {
        trained.fresh = std::move(fresh);
        return trained;
      }
      for (const auto& [body, made] : fresh.of_body) training.add_runs(body, made.problems, made.evaluations);
      continue;
    }
    for (const auto& [body, at] : rounds)
      if (!is_sure(job, errors[body]) && !training.full(body) && !training.out_of_time())
        training.add_round(body, evenly(at.targets, most_targets), evenly(at.candidates, most_candidates));
  }
}

void finish_report(EmulatorReport& report, const Emulators& emulators, double verify) {
  const Emulator& first = emulators.of.begin()->second;  // spheres' depths where there are spheres
  const LeaveOneOut check = first.leave_one_out();
  report.settings = first.settings();
  report.leave_one_out = check.root_mean_square;
  report.standardised_deviation = check.standardised_deviation;
  report.coverage95 = check.coverage95;
  for (BesideReport& beside : report.beside) {
    const Emulator& emulator = emulators.of.at(beside.of);
    for (const TrainingRun& run : emulator.runs()) beside.mean += std::exp(run.log_depth) / beside.runs;
    beside.noise = emulator.noise(1 / verify);
    beside.leave_one_out = emulator.leave_one_out().root_mean_square;
  }
}

void add_fresh_runs(const CalibrationJob& job, HypothesisResult& result, std::vector<FreshRun> fresh) {
  result.fresh = std::move(fresh);
  int count = 0;
  for (const FreshRun& run : result.fresh)
    if (run.depth && job.shots[run.shot].is_number()) {
      result.fresh_deviation += std::abs(*run.depth / job.shots[run.shot].depth - 1);
      ++count;
    }
  if (count > 0) result.fresh_deviation /= count;
}

// Every hypothesis, side by side; then the fresh runs of all, where training did not end with them. No emulator: no shots.
std::vector<HypothesisResult> read_all(const CalibrationJob& job, const std::optional<Emulators>& emulators,
                                       Trained trained, Campaign& campaign, const CalibrationLimits& limits,
                                       const Announce& announce) {
  FittedHypotheses& fitted = trained.fitted;
  if (!trained.fresh) {
    fitted.models.clear();
    for (const Hypothesis& hypothesis : job.hypotheses)
      fitted.models.push_back(finite_element_model(job, hypothesis, emulators, element_size(job)));
    fitted.fits.resize(job.hypotheses.size());
    fit_thoroughly(job, fitted, campaign);
  }
  std::vector<HypothesisResult> results(job.hypotheses.size());
  campaign.side_by_side(count_of(job.hypotheses), [&](int k) {
    const JobModel without_mesh = finite_element_model(job, job.hypotheses[k], emulators, 0);
    results[k] = read_out(job, k, fitted.models[k], without_mesh, fitted.fits[k], limits, campaign.threads());
  });
  for (const Hypothesis& hypothesis : job.hypotheses) announce(fmt::format("\"{}\" is fitted", hypothesis.name));
  if (!emulators) return results;
  if (!trained.fresh)
    trained.fresh = fresh_runs(job, fitted, *emulators, campaign, limits.deadline(share_for_fresh_runs));
  auto& fresh = trained.fresh->of;
  for (int k = 0; k < count_of(job.hypotheses); ++k) {
    const std::size_t missing = fitted.fits[k].shots.size() - fresh[k].size();
    if (missing > 0)
      results[k].findings.push_back(
          fmt::format("{} of {} fitted shots were not checked by fresh runs: the budget ended.", missing,
                      fitted.fits[k].shots.size()));
    add_fresh_runs(job, results[k], std::move(fresh[k]));
  }
  return results;
}

// How the error at the optimum fell with the time spent, carried on: error ~ 1/sqrt(runs).
std::string what_more_time_buys(const EmulatorReport& report) {
  if (report.rounds.empty() || report.error_at_optimum <= 0) return "";
  const double total = std::hypot(report.error_at_optimum, report.data_error);
  const double better = std::hypot(report.error_at_optimum / std::sqrt(2.0), report.data_error);
  return fmt::format(
      "Twice the runs ({:.0f} s more of processor time) would bring the emulator's error from {} to about {}; beside "
      "the data's {} that makes intervals {} narrower.",
      report.rounds.back().cpu_seconds, page::rough_percent(report.error_at_optimum),
      page::rough_percent(report.error_at_optimum / std::sqrt(2.0)), page::rough_percent(report.data_error),
      page::rough_percent(1 - better / total));
}

}  // namespace

CalibrationResult calibrate(const CalibrationJob& job, Store& store, Campaign& campaign,
                            const CalibrationLimits& limits, const Announce& announce) {
  largest_run(job);  // throws where it cannot be run
  CalibrationResult result;
  std::optional<Training> training;
  std::string hopeless;
  Trained trained;
  if (!job.shots.empty()) {
    training.emplace(job, &store, campaign, limits);
    trained = train(job, *training, campaign, limits, announce);
    training->report().stopped = trained.why;
    if (training->has_emulator()) finish_report(training->report(), training->emulators(), job.training.verify);
    result.emulator = training->report();
    if (trained.fitted.fits.empty()) hopeless = trained.why;
  }
  if (hopeless.empty())
    result.hypotheses = read_all(job, training ? std::optional(training->emulators()) : std::nullopt,
                                 std::move(trained), campaign, limits, announce);
  else
    result.findings.push_back("No hypothesis was fitted: " + hopeless + ".");
  if (training && training->has_emulator()) result.shot_model = kept_model(job, training->emulators(), result);
  const bool any_depth = std::ranges::any_of(
      job.shots, [](const MeasuredShot& shot) { return shot.used && !shot.body && shot.number == RunNumber::depth; });
  if (job.dehn && any_depth) result.dehn = fit_dehn(job);
  const auto findings = overall_findings(job, result);
  result.findings.insert(result.findings.end(), findings.begin(), findings.end());
  const CampaignCost cost = campaign.cost();
  result.cost.runs = cost.runs;
  result.cost.reused = cost.reused;
  result.cost.cpu_seconds = cost.cpu_seconds;
  result.cost.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - limits.start).count();
  result.cost.budget_seconds = limits.budget_seconds;
  result.cost.advice = what_more_time_buys(result.emulator);
  return result;
}

}  // namespace percal
