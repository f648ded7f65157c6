#include "percal/calibrate/training.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/calibrate/job_fit.hpp"
#include "percal/calibrate/shot_problem.hpp"
#include "percal/campaign/sphere_runs.hpp"
#include "percal/invert/depth_covariance.hpp"
#include "percal/math/draws.hpp"
#include "percal/problem/particle.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

constexpr int first_round = 64;       // runs before there is an emulator to choose by
constexpr int points_looked_at = 25;  // for each run of a space-filling round
constexpr double near_enough = 0.7;   // of ln depth from the measured one
constexpr double search_again = 1.3;  // hyperparameters are found anew when the runs have grown by this
constexpr int enough_beside = 60;     // runs that tell a number beside the depth, of the first design
constexpr int most_without = 4;       // of those that do not, for each that is wanted
constexpr double too_shallow =
    1;  // ln depth short of the shallowest measured one: under covers, such a sphere sticks in one
constexpr double near_by_energy = 1.8;  // of ln depth: how far a guess by energies may be off
constexpr double cubes_end = 1e-9;      // relative

// What a body's depth is expected to be within a factor of 6 before any run: its energy makes a hole of its shadow, at the energy density
// that uniaxial tension puts into the material until it erodes. m                                    docs/theory/emulator.md (15)
double depth_by_energy(const MeasuredShot& shot, const LayerMaterial& material, const Problem& problem) {
  const double pi4 = material.density * shot.speed * shot.speed / material.mu_true;
  const double work = std::exp(log_erosion_energy(material.alpha, material.erosion_strain).value) / pi4;
  const Scales scales{.radius = shot.radius, .speed = shot.speed, .target_density = material.density};
  return 0.5 * sectional_density(problem, scales) / material.density / work;
}

// A run that went beyond the cubes of its block tells of its coarse rest.
bool is_beyond_the_cubes(const Problem& problem, double reach) {
  return problem.geometry == Geometry::block && reach > problem.block.fine_depth * (1 + cubes_end);
}

// Spheres that stick in a cover scatter far more than those that pass it, and tell nothing of data that all have passed.
double least_learnt(const CalibrationJob& job) {
  double least = INFINITY;
  for (const MeasuredShot& shot : job.shots)
    if (tells_depth(shot) && !shot.body) least = std::min(least, std::log(shot.depth / shot.radius) - too_shallow);
  return covers_of(job) > 0 && std::isfinite(least) ? least : -INFINITY;
}

}  // namespace

Training::Training(const CalibrationJob& job, Store* store, Campaign& campaign, const CalibrationLimits& limits)
    : job_(job),
      hypothesis_(job.hypotheses.front()),
      store_(store),
      campaign_(campaign),
      limits_(limits),
      least_learnt_(least_learnt(job)) {
  for (const int body : bodies_of(job)) {
    learnt_[{body}];
    designs_[body];
  }
  if (designs_.contains(0)) {
    for (const RunNumber number : numbers_of(job)) learnt_[{0, number}];
    take_runs_of_atlas();
    take_foreign_runs();
  }
  learn();
}

// The material numbers at a point of the unit cube: of the parameters' boxes.
std::vector<double> Training::numbers_at(const Eigen::RowVectorXd& shares) const {
  std::vector<double> natural;
  for (std::size_t j = 0; j < job_.parameters.size(); ++j) {
    const FreeParameter& p = job_.parameters[j].free;
    const double low = p.searched(p.low), high = p.searched(p.high);
    natural.push_back(p.natural(low + (high - low) * shares[static_cast<Eigen::Index>(j)]));
  }
  return natural;
}

RunCounts Training::counts_of(int body) const {
  const TrainingSettings& t = job_.training;
  return body == 0 ? RunCounts{t.initial, t.batch, t.most} : t.body;
}

int Training::runs_of_design() const {
  int runs = 0;
  for (const auto& [body, design] : designs_) runs += design.runs;
  return runs;
}

std::vector<int> Training::shots_of_body(int body) const {
  std::vector<int> shots;
  for (const int shot : all_shots(job_))
    if (place_of_body(job_.shots[shot]) == body) shots.push_back(shot);
  return shots;
}

// Whether the run may end anywhere near where the shot did, as far as is known: by the emulator; of a body without one, whose runs are dear,
// by its energy.
bool Training::is_near(const MeasuredShot& shot, const CoveredMaterial& material, const Problem& problem) const {
  if (!tells_depth(shot)) return true;
  const std::optional<Emulator>& emulator = learnt_.at({place_of_body(shot)}).emulator;
  if (emulator) {
    const DepthAnswers answer = emulator->depth({shot_inputs(shot, material).at}, element_size(problem), true);
    const double off = std::abs(answer.log_depth[0] - std::log(shot.depth / shot.radius));
    return off <= near_enough + 2 * std::sqrt(answer.covariance(0, 0));
  }
  return !shot.body || std::abs(std::log(depth_by_energy(shot, material, problem) / shot.depth)) <= near_by_energy;
}

// A Sobol point's last coordinate chooses among the shots.
std::vector<Problem> Training::space_filling_batch(int body, int count, const std::vector<int>& shots) {
  int& next_point = designs_.at(body).next_point;
  const auto dimensions = static_cast<int>(job_.parameters.size()) + 1;
  const int looked_at = count * points_looked_at;
  const Eigen::MatrixXd points = sobol_points(looked_at, dimensions, next_point);
  std::vector<Problem> batch;
  int k = 0;
  for (; k < looked_at && static_cast<int>(batch.size()) < count; ++k) {
    const std::vector<double> natural = numbers_at(points.row(k));
    const auto chosen = static_cast<std::size_t>(points(k, dimensions - 1) * static_cast<double>(shots.size()));
    const MeasuredShot& shot = job_.shots[shots[chosen]];
    const CoveredMaterial material = target_at(job_, hypothesis_, job_.targets[shot.target], natural);
    const bool fine = (next_point + k) % std::max(2, static_cast<int>(std::lround(1 / job_.training.fine_share))) == 0;
    const double mesh = mesh_of(shot, material, fine ? job_.training.fine : job_.training.coarse);
    Problem problem = shot_problem(job_, shot, material, drawn_mesh(mesh, job_.training.seed, next_point + k));
    if (is_near(shot, material, problem)) batch.push_back(std::move(problem));
  }
  next_point += k;
  return batch;
}

void Training::fill_space() {
  for (const auto& [body, design] : designs_) {
    fill_space(body);
    if (failures()) return;
  }
}

void Training::fill_space(int body) {
  const RunCounts counts = counts_of(body);
  const Design& design = designs_.at(body);
  // What the atlas knows, which has no covers and no bodies but spheres.
  const int known = covers_of(job_) > 0 || body != 0 ? 0 : report_.from_atlas;
  const int initial = std::min(counts.initial, counts.most) - known;
  while (design.runs < initial && !out_of_time()) {
    const int first = body == 0 ? first_round : smallest_training;
    const int wanted = learnt_.at({body}).emulator ? counts.batch : first;
    const auto batch = space_filling_batch(body, std::min(wanted, initial - design.runs), shots_of_body(body));
    if (batch.empty()) break;
    run(body, batch);
    learn();
    if (failures()) return;
  }
  for (const auto& [of, learnt] : learnt_) {
    if (of.body != body || of.number == RunNumber::depth) continue;
    std::vector<int> telling;
    for (const int shot : shots_of_body(body))
      if (job_.shots[shot].number == of.number || job_.training.learn.contains(of.number)) telling.push_back(shot);
    while (lacks(learnt) && !full(body) && !out_of_time()) {
      const auto batch = space_filling_batch(body, std::min(counts.batch, counts.most - design.runs), telling);
      if (batch.empty()) break;
      run(body, batch);
      learn();
      if (failures()) return;
    }
  }
}

bool Training::lacks(const Learnt& learnt) const {
  return std::ssize(learnt.runs) < enough_beside && learnt.without < most_without * enough_beside;
}

Emulators Training::emulators() const {
  Emulators all;
  for (const auto& [of, learnt] : learnt_) all.of.emplace(of, *learnt.emulator);
  return all;
}

bool Training::has_emulator() const {
  return std::ranges::all_of(learnt_, [](const auto& one) { return one.second.emulator.has_value(); });
}

// The fine runs first, then the coarse: what the mesh adds varies from point to point, and coarse runs alone would look cheaper. Each
// emulator chooses as many.
void Training::add_round(int body, const std::vector<Target>& targets, const std::vector<Candidate>& candidates) {
  std::vector<Problem> batch;
  const auto choose = [&](RunNumber number, const Emulator& emulator, int count) {
    const auto is_for = [&](const auto& one) { return number == RunNumber::depth || one.number == number; };
    std::vector<SphereInputs> at;
    std::vector<double> weights;
    for (const Target& target : targets) {
      if (!is_for(target)) continue;
      at.push_back(target.at);
      weights.push_back(target.weight);
    }
    const auto on = [&](Problem Candidate::*mesh, int runs) {
      std::vector<Emulator::CandidateRun> on_mesh;
      std::vector<const Problem*> problems;
      for (const Candidate& candidate : candidates) {
        if (!is_for(candidate)) continue;
        problems.push_back(&(candidate.*mesh));
        on_mesh.push_back({inputs_of(*problems.back()), element_size(*problems.back()), 1});
      }
      for (const int k : emulator.choose(on_mesh, runs, at, weights, 1 / job_.training.verify))
        batch.push_back(*problems[static_cast<std::size_t>(k)]);
    };
    const int fine = static_cast<int>(std::lround(job_.training.fine_share * count));
    on(&Candidate::fine, fine);
    on(&Candidate::coarse, count - fine);
  };
  const RunCounts counts = counts_of(body);
  const int count = std::min(counts.batch, counts.most - designs_.at(body).runs);
  std::set<RunNumber> wanted;  // those that a datum is of: others learn from what is run for them
  for (const Target& target : targets)
    if (target.number != RunNumber::depth) wanted.insert(target.number);
  const int of_each = count / (1 + static_cast<int>(wanted.size()));
  choose(RunNumber::depth, *learnt_.at({body}).emulator, count - of_each * static_cast<int>(wanted.size()));
  for (const RunNumber number : wanted) choose(number, *learnt_.at({body, number}).emulator, of_each);
  run(body, batch);
  learn();
}

void Training::add_runs(int body, const std::vector<Problem>& problems,
                        const std::vector<std::optional<Evaluation>>& evaluations) {
  count(body, problems, evaluations);
  learn();
}

void Training::run(int body, const std::vector<Problem>& problems) {
  const auto deadline = limits_.deadline(share_for_training);
  Progress progress("runs for the emulator", static_cast<long>(problems.size()), deadline);
  const CampaignCost before = campaign_.cost();
  count(body, problems, campaign_.evaluate_by(deadline, problems, &progress));
  const CampaignCost after = campaign_.cost();
  report_.runs += static_cast<int>(after.runs - before.runs);
  report_.reused += static_cast<int>(after.reused - before.reused);
}

void Training::count(int body, const std::vector<Problem>& problems,
                     const std::vector<std::optional<Evaluation>>& evaluations) {
  const double least = body == 0 ? least_learnt_ : -INFINITY;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    if (!evaluations[i]) {
      out_of_time_ = true;
      continue;
    }
    ++designs_.at(body).runs;
    const Evaluation& evaluation = *evaluations[i];
    cpu_seconds_ += evaluation.cpu_seconds;
    ++report_.outcomes[word(evaluation.result.outcome)];
    const std::string key = evaluation_key(problems[i], evaluation.instruction_level);
    if (body == 0 && told_.insert(key).second) take_numbers(problems[i], evaluation.result);
    if (std::find(taken_.begin(), taken_.end(), key) != taken_.end()) continue;
    taken_.push_back(key);
    const auto reach = reach_of(problems[i], evaluation.result);
    if (reach && std::log(*reach) >= least && !is_beyond_the_cubes(problems[i], *reach))
      learnt_.at({body}).runs.push_back(training_run(problems[i], *reach));
  }
}

// Of a run of a sphere that was asked for them.
void Training::take_numbers(const Problem& problem, const ImpactResult& result) {
  for (auto& [of, learnt] : learnt_) {
    if (of.body != 0 || of.number == RunNumber::depth || !kind_of(of.number).asked(problem)) continue;
    const auto log_share = kind_of(of.number).log_of(result);
    learnt.without += !log_share;
    if (log_share) learnt.runs.push_back(training_run(problem, std::exp(*log_share)));
  }
}

namespace {

void learn_from(const std::vector<TrainingRun>& runs, std::optional<Emulator>& emulator, int& searched_at) {
  if (runs.size() < smallest_training) return;
  const bool search = !emulator || static_cast<double>(runs.size()) >= search_again * searched_at ||
                      emulator->settings().inputs() != scale_of(runs).inputs();
  if (search) searched_at = static_cast<int>(runs.size());
  EmulatorOptions options;
  emulator.emplace(search ? Emulator(runs, options) : Emulator(runs, emulator->settings()));
}

}  // namespace

void Training::learn() {
  const auto can_learn = [](const auto& one) {
    return one.first.number == RunNumber::depth && one.second.runs.size() >= smallest_training;
  };
  if (std::ranges::none_of(learnt_, can_learn)) return;
  report_.beside.clear();
  int runs = 0;
  for (auto& [of, learnt] : learnt_) {
    learn_from(learnt.runs, learnt.emulator, learnt.searched_at);
    if (of == EmulatorOf{}) {
      runs += static_cast<int>(learnt.runs.size());
      continue;
    }
    if (of.number == RunNumber::depth) runs += static_cast<int>(learnt.runs.size());
    report_.beside.push_back({.of = of,
                              .body = of.body == 0 ? "" : job_.bodies[of.body - 1]->name(),
                              .runs = static_cast<int>(learnt.runs.size()),
                              .without = learnt.without});
  }
  report_.rounds.push_back({.runs = runs, .cpu_seconds = cpu_seconds_});
}

std::string Training::untold() const {
  for (const auto& [of, learnt] : learnt_) {
    if (learnt.emulator) continue;
    if (of.number != RunNumber::depth && learnt_.at({of.body}).emulator)
      return fmt::format("{} of {} runs told the {}, too few for an emulator", learnt.runs.size(),
                         std::ssize(learnt.runs) + learnt.without, kind_of(of.number).words);
    if (of.body != 0)
      return fmt::format("{} of {} runs of {} came to rest where they tell a depth, too few for an emulator",
                         learnt.runs.size(), designs_.at(of.body).runs, job_.bodies[of.body - 1]->name());
  }
  return "";
}

std::optional<std::string> Training::failures() const {
  int failed = 0;
  std::string counts;
  for (const auto& [outcome, count] : report_.outcomes) {
    counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, outcome);
    if (outcome != word(Outcome::stopped) && outcome != word(Outcome::passed_through)) failed += count;
  }
  const int runs = runs_of_design();
  if (runs < first_round || failed <= job_.training.failures_tolerated * runs) return std::nullopt;
  return fmt::format("of {} runs {}: more failed than the job tolerates ({:g} %)", runs, counts,
                     100 * job_.training.failures_tolerated);
}

}  // namespace percal
