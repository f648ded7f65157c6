#include "percal/calibrate/job_fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "percal/base/error.hpp"
#include "percal/base/progress.hpp"
#include "percal/base/threads.hpp"
#include "percal/estimate/scatter.hpp"
#include "percal/invert/reach.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int speed_rounds = 2;  // the exponent hardly moves with the minimum

VectorXd middle(const std::vector<FreeParameter>& parameters) {
  VectorXd at(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t k = 0; k < parameters.size(); ++k) at[k] = parameters[k].middle();
  return at;
}

// Depths of the shots, then stresses: values, Jacobian and, where one of them has it, covariance of all.
ModelAnswer all_answers(const JobModel& model, const VectorXd& at, std::span<const MeasuredShot> shots, Want want) {
  ModelAnswer depths = model.log_depths(at, shots, want);
  if (!model.stresses) return depths;
  const ModelAnswer stresses = model.stresses(at, want);
  const Eigen::Index n = depths.value.size(), m = stresses.value.size();
  ModelAnswer all;
  all.value.resize(n + m);
  all.value << depths.value, stresses.value;
  all.jacobian.resize(n + m, at.size());
  all.jacobian << depths.jacobian, stresses.jacobian;
  if (depths.covariance.size() == 0 && stresses.covariance.size() == 0) return all;
  all.covariance = MatrixXd::Zero(n + m, n + m);
  if (depths.covariance.size() > 0) all.covariance.topLeftCorner(n, n) = depths.covariance;
  if (stresses.covariance.size() > 0) all.covariance.bottomRightCorner(m, m) = stresses.covariance;
  return all;
}

// Parameters that some datum depends on.
std::vector<int> active_parameters(const JobModel& model, std::span<const MeasuredShot> shots) {
  const MatrixXd jacobian = all_answers(model, middle(model.parameters), shots, Want::values).jacobian;
  std::vector<int> active;
  for (Eigen::Index k = 0; k < jacobian.cols(); ++k)
    if (jacobian.col(k).cwiseAbs().maxCoeff() > 0) active.push_back(static_cast<int>(k));
  return active;
}

VectorXd completed(VectorXd all, const std::vector<int>& of_model, const VectorXd& searched) {
  for (std::size_t k = 0; k < of_model.size(); ++k) all[of_model[k]] = searched[static_cast<Eigen::Index>(k)];
  return all;
}

CalibrationModel restricted(const JobModel& model, const std::vector<MeasuredShot>& shots,
                            const std::vector<int>& of_model) {
  return [model, shots, of_model, centre = middle(model.parameters)](const VectorXd& searched, Want want) {
    ModelAnswer answer = all_answers(model, completed(centre, of_model, searched), shots, want);
    answer.jacobian = MatrixXd(answer.jacobian(Eigen::all, of_model));
    return answer;
  };
}

std::vector<Datum> shot_data(std::span<const MeasuredShot> shots, const VectorXd& exponents) {
  std::vector<Datum> data;
  for (std::size_t k = 0; k < shots.size(); ++k)
    data.push_back({.label = shots[k].label,
                    .value = std::log(shots[k].depth),
                    .error = known_log_error(shots[k], exponents[static_cast<Eigen::Index>(k)]),
                    .group = shots[k].group,
                    .seen = seen_of(shots[k].datum)});
  return data;
}

// Covariance of the fitted parameters over all of the model's.
MatrixXd full_covariance(const JobModel& model, const JobFit& fit) {
  const auto p = static_cast<Eigen::Index>(model.parameters.size());
  MatrixXd covariance = MatrixXd::Zero(p, p);
  covariance(fit.of_model, fit.of_model) = fit.best().covariance;
  return covariance;
}

// ln of the deepest depth (the reach) of shots of which `answer` has the numbers.
VectorXd log_deepest(const JobModel& model, const VectorXd& at, std::vector<MeasuredShot> shots,
                     const ModelAnswer& answer) {
  if (std::ranges::all_of(shots, [](const MeasuredShot& shot) { return shot.number == RunNumber::depth; }))
    return answer.value;
  for (MeasuredShot& shot : shots) shot.number = RunNumber::depth;
  return model.log_depths(at, shots, Want::values).value;
}

// Of a prediction that scatters as the data of a group do.
double prediction_quantile(const JobFit& fit, int group, double level) {
  const double upper = 0.5 + level / 2, freedom = scatter_freedom(fit, group);
  return freedom > 0 ? student_quantile(upper, freedom) : normal_quantile(upper);
}

}  // namespace

SearchOptions quick_search(int threads) { return {.global_evaluations = 800, .starts = 4, .threads = threads}; }
SearchOptions thorough_search() { return {.global_evaluations = 4000, .starts = 8}; }

double known_log_error(const MeasuredShot& shot, double speed_exponent) {
  double by_speed = speed_exponent;
  if (shot.datum == ShotDatum::speed_left) by_speed -= reach_speed_slope(shot.speed_left / shot.speed);
  return std::hypot(shot.depth_error / shot.depth, by_speed * shot.speed_error / shot.speed);
}

double scatter_freedom(const JobFit& fit, int group) {
  if (!fit.problem.groups[group].estimated) return 0;
  const auto told = std::count_if(fit.problem.data.begin(), fit.problem.data.end(),
                                  [&](const Datum& d) { return d.group == group && d.is_number(); });
  if (told > 0) return std::max(1.0, static_cast<double>(told) - static_cast<double>(fit.of_model.size()));
  // Sides alone: what they tell of the scatter's square, as numbers that told as much would.
  const ModelAnswer answer = fit.problem.model(fit.best().searched, Want::values_and_covariance);
  std::vector<int> free(fit.problem.parameters.size());
  std::iota(free.begin(), free.end(), 0);
  const auto likelihood = restricted_likelihood(fit.problem, answer, fit.best().searched, fit.best().scatter, free);
  return std::max(1.0, 2 * likelihood.fisher(group, group) * std::pow(fit.best().scatter[group], 4));
}

JobFit fit_job(const CalibrationJob& job, const JobModel& model, const std::vector<int>& shots,
               const SearchOptions& options, const std::optional<VectorXd>& start) {
  if (shots.empty() && !model.stresses) throw BadInput("no shot and no curve is left to fit");
  JobFit fit;
  fit.shots = shots;
  const std::vector<MeasuredShot> measured = shots_of(job, shots);
  fit.of_model = active_parameters(model, measured);
  for (int k : fit.of_model) fit.problem.parameters.push_back(model.parameters[k]);
  fit.problem.groups = job.groups;
  fit.problem.model = restricted(model, measured, fit.of_model);
  fit.at = start.value_or(middle(model.parameters));
  const std::vector<Datum> curves = model.stresses ? curve_data(job) : std::vector<Datum>{};
  for (int round = 0; round < speed_rounds; ++round) {
    fit.problem.data = shot_data(measured, model.speed_exponents(fit.at, measured));
    fit.problem.data.insert(fit.problem.data.end(), curves.begin(), curves.end());
    if (round == 0 && !start)
      fit.minima = find_minima(fit.problem, options);
    else
      fit.minima.insert(
          fit.minima.begin(),
          refine(fit.problem, round == 0 ? VectorXd(fit.at(fit.of_model)) : fit.minima[0].searched, {}, options));
    if (round > 0) fit.minima.erase(fit.minima.begin() + 1);
    fit.at = completed(middle(model.parameters), fit.of_model, fit.best().searched);
  }
  return fit;
}

std::vector<ShotDepth> shot_depths(const CalibrationJob& job, const JobModel& model, const JobFit& fit,
                                   const std::vector<int>& shots) {
  const std::vector<MeasuredShot> measured = shots_of(job, shots);
  const ModelAnswer answer = model.log_depths(fit.at, measured, Want::values_and_covariance);
  const VectorXd exponents = model.speed_exponents(fit.at, measured);
  const MatrixXd of_parameters = answer.jacobian * full_covariance(model, fit) * answer.jacobian.transpose();
  const VectorXd log_reach = log_deepest(model, fit.at, measured, answer);
  std::map<int, double> quantiles;  // of each group: what sides alone tell is a likelihood of its own
  std::vector<ShotDepth> depths;
  for (std::size_t k = 0; k < shots.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const MeasuredShot& shot = measured[k];
    const double own = answer.covariance.size() > 0 ? std::max(0.0, answer.covariance(i, i)) : 0;
    const double scatter = fit.best().scatter[shot.group], known = known_log_error(shot, exponents[i]);
    const double deviation = std::sqrt(of_parameters(i, i) + own + scatter * scatter + known * known);
    if (!quantiles.contains(shot.group)) quantiles[shot.group] = prediction_quantile(fit, shot.group, job.level);
    const double quantile = quantiles[shot.group];
    ShotDepth depth{
        .shot = shots[k], .depth = std::exp(answer.value[i]), .model_error = std::sqrt(own), .deviation = {}};
    depth.low = depth.depth * std::exp(-quantile * deviation);
    depth.high = depth.depth * std::exp(quantile * deviation);
    depth.fitted = std::find(fit.shots.begin(), fit.shots.end(), shots[k]) != fit.shots.end();
    constexpr double least_deviation = 1e-9;
    depth.passes =
        std::exp(log_normal_cdf((log_reach[i] - std::log(shot.layer_depth)) / std::max(deviation, least_deviation)));
    if (shot.is_number()) depth.deviation = depth.depth / shot.depth - 1;
    if (shot.number != RunNumber::depth) depth.deepest = std::exp(log_reach[i]);
    depths.push_back(depth);
  }
  return depths;
}

std::vector<CurveStresses> curve_stresses(const CalibrationJob& job, const JobModel& model, const JobFit& fit) {
  std::vector<CurveStresses> curves;
  if (!model.stresses) return curves;
  const ModelAnswer answer = model.stresses(fit.at, Want::values_and_covariance);
  const MatrixXd of_parameters = answer.jacobian * full_covariance(model, fit) * answer.jacobian.transpose();
  const std::vector<Datum> data = curve_data(job);
  Eigen::Index row = 0;
  for (std::size_t c = 0; c < job.curves.size(); ++c) {
    const int group = job.curves[c].group;
    const double quantile = prediction_quantile(fit, group, job.level), scatter = fit.best().scatter[group];
    CurveStresses curve{.curve = static_cast<int>(c)};
    for (const double scale : stress_scales(job.curves[c])) {
      const double common = answer.covariance.size() > 0 ? answer.covariance(row, row) : 0;
      const double error = data[static_cast<std::size_t>(row)].error;
      const double deviation = std::sqrt(of_parameters(row, row) + common + scatter * scatter + error * error);
      curve.stress.push_back(scale * answer.value[row]);
      curve.low.push_back(scale * (answer.value[row] - quantile * deviation));
      curve.high.push_back(scale * (answer.value[row] + quantile * deviation));
      ++row;
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

Deviation deviation(const std::string& name, const CalibrationJob& job, const std::vector<ShotDepth>& depths) {
  Deviation result{.name = name};
  for (const ShotDepth& depth : depths) {
    if (!depth.deviation) continue;
    ++result.shots;
    result.mean_absolute += std::abs(*depth.deviation);
    result.mean_signed += *depth.deviation;
    const double measured = job.shots[depth.shot].depth;
    result.within += depth.low <= measured && measured <= depth.high;
  }
  if (result.shots > 0) {
    result.mean_absolute /= result.shots;
    result.mean_signed /= result.shots;
  }
  return result;
}

std::vector<Deviation> set_deviations(const CalibrationJob& job, const std::vector<ShotDepth>& shots) {
  std::vector<Deviation> sets;
  for (std::size_t s = 0; s < job.sets.size(); ++s)
    for (const bool fitted : {true, false}) {
      std::vector<ShotDepth> of_set;
      for (const ShotDepth& depth : shots)
        if (job.shots[depth.shot].set == static_cast<int>(s) && depth.fitted == fitted) of_set.push_back(depth);
      if (!of_set.empty())
        sets.push_back(deviation(job.sets[s].name + (fitted ? ", fitted" : ", predicted"), job, of_set));
    }
  return sets;
}

std::vector<int> chosen(const CalibrationJob& job, const ShotFilter& filter) {
  std::vector<int> shots;
  for (std::size_t i = 0; i < job.shots.size(); ++i) {
    const MeasuredShot& shot = job.shots[i];
    const bool all = std::all_of(filter.begin(), filter.end(), [&](const std::string& condition) {
      const auto equals = condition.find('=');
      const std::string column = condition.substr(0, equals), value = condition.substr(equals + 1);
      if (column == "set") return job.sets[shot.set].name == value;
      const auto cell = shot.row.find(column);
      return cell != shot.row.end() && cell->second == value;
    });
    if (all) shots.push_back(static_cast<int>(i));
  }
  return shots;
}

std::vector<int> used_shots(const CalibrationJob& job) {
  std::vector<int> used;
  for (std::size_t i = 0; i < job.shots.size(); ++i)
    if (job.shots[i].used) used.push_back(static_cast<int>(i));
  return used;
}

std::vector<int> all_shots(const CalibrationJob& job) {
  std::vector<int> all(job.shots.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::vector<MeasuredShot> shots_of(const CalibrationJob& job, const std::vector<int>& indices) {
  std::vector<MeasuredShot> shots;
  for (const int i : indices) shots.push_back(job.shots[i]);
  return shots;
}

CrossValidationResult cross_validate(const CalibrationJob& job, const JobModel& model, const CrossValidation& wanted,
                                     const SearchOptions& options) {
  const JobFit fit = fit_job(job, model, chosen(job, wanted.fit), options);
  CrossValidationResult result{.name = wanted.name, .fitted = static_cast<int>(fit.shots.size()), .goal = wanted.goal};
  result.shots = shot_depths(job, model, fit, chosen(job, wanted.predict));
  result.fit = deviation("fitted", job, shot_depths(job, model, fit, fit.shots));
  result.prediction = deviation("predicted", job, result.shots);
  return result;
}

CrossValidationResult leave_one_out(const CalibrationJob& job, const JobModel& model, int set, const JobFit& full,
                                    const SearchOptions& options) {
  CrossValidationResult result{.name = "leave one out: " + job.sets[set].name};
  std::vector<int> left_out;
  for (const int i : all_shots(job))
    if (job.shots[i].set == set) left_out.push_back(i);
  const auto count = static_cast<int>(left_out.size());
  result.shots.resize(left_out.size());
  Progress progress(result.name, count);
  const auto others_than = [&](int i) {
    std::vector<int> others;
    for (const int k : all_shots(job))
      if (k != i && (job.shots[k].used || job.shots[k].set == set)) others.push_back(k);
    return others;
  };
  if (count > 0) result.fitted = static_cast<int>(others_than(left_out.back()).size());
  side_by_side(options.threads, count, [&](int n) {
    const JobFit fit = fit_job(job, model, others_than(left_out[n]), options, full.at);
    result.shots[n] = shot_depths(job, model, fit, {left_out[n]})[0];
    progress.add();
  });
  result.prediction = deviation("predicted", job, result.shots);
  return result;
}

}  // namespace percal
