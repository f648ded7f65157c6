#include "percal/invert/emulator_search.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlopt.hpp>

#include "percal/math/gaussian_process.hpp"

namespace percal {
namespace {

constexpr double plane_over_spread = 5;   // prior deviation of the plane's slopes, in standard deviations of the values
constexpr double smallest_spread = 1e-6;  // of ln depth, where all runs say the same
constexpr double smallest_roughness = 1e-3;  // scatter about the plane, over the spread
constexpr double smallest_noise = 1e-4;      // over the spread: keeps the covariance positive definite
constexpr int evaluations_of_a_start = 40;
constexpr double tolerance = 5e-3;  // of ln likelihood

double spread(const Eigen::VectorXd& centred) {
  return std::max(std::sqrt(centred.squaredNorm() / std::max<double>(1, centred.size() - 1)), smallest_spread);
}

bool has_several_meshes(const std::vector<TrainingRun>& runs) {
  const auto [finest, coarsest] = std::ranges::minmax(runs, {}, &TrainingRun::h);
  return 1 / finest.h - 1 / coarsest.h > one_mesh_span;
}

// What a hyperparameter is before the runs are seen: normal, between bounds.
struct Belief {
  double centre, deviation, low, high;
};

// Where a search over so many inputs has what: logarithms of amplitudes, lengths (of scaled inputs) and noise, and the two orders
// as they are. Those from noise_order on are looked for on several meshes alone.
struct SearchOrder {
  int inputs;
  static constexpr int amplitude = 0, length = 1;
  int noise = length + inputs, noise_order = noise + 1, mesh_amplitude = noise_order + 1,
      mesh_length = mesh_amplitude + 1, mesh_order = mesh_length + inputs;

  int size(bool several_meshes) const { return (several_meshes ? mesh_order : noise) + 1; }
};

// docs/theory/emulator.md (9)
std::vector<Belief> beliefs(const SearchOrder& o, double roughness, double whole_spread, bool several_meshes) {
  const double size = std::log(roughness);
  const auto by_size = [&](double factor, double deviation) {
    return Belief{size + std::log(factor), deviation, size + std::log(1e-2), size + std::log(1e2)};
  };
  std::vector<Belief> all(o.size(several_meshes));
  all[o.amplitude] = by_size(2, 1.5);
  all[o.noise] = {size + std::log(0.3), 2, std::log(smallest_noise * whole_spread), size + std::log(2)};
  for (int j = 0; j < o.inputs; ++j) all[o.length + j] = {std::log(2), 1, std::log(0.1), std::log(50)};
  if (!several_meshes) return all;
  all[o.noise_order] = {0.5, 0.5, 0, 2};
  all[o.mesh_amplitude] = by_size(0.3, 1.5);
  for (int j = 0; j < o.inputs; ++j) all[o.mesh_length + j] = {std::log(3), 0.7, std::log(0.3), std::log(50)};
  all[o.mesh_order] = {1, 0.3, 0.3, 2.5};
  return all;
}

CovarianceParameters parameters_at(const SearchOrder& o, const std::vector<double>& searched) {
  const Eigen::Map<const Eigen::VectorXd> x(searched.data(), static_cast<Eigen::Index>(searched.size()));
  CovarianceParameters p;
  p.amplitude = std::exp(x[o.amplitude]);
  p.length = x.segment(o.length, o.inputs).array().exp();
  p.noise = std::exp(x[o.noise]);
  if (x.size() == o.size(false)) return p;
  p.noise_order = x[o.noise_order];
  p.mesh_amplitude = std::exp(x[o.mesh_amplitude]);
  p.mesh_length = x.segment(o.mesh_length, o.inputs).array().exp();
  p.mesh_order = x[o.mesh_order];
  return p;
}

Eigen::VectorXd in_search_order(const SearchOrder& o, const CovarianceParameters& gradient, Eigen::Index size) {
  Eigen::VectorXd g(size);
  g[o.amplitude] = gradient.amplitude;
  g.segment(o.length, o.inputs) = gradient.length;
  g[o.noise] = gradient.noise;
  if (size == o.size(false)) return g;
  g[o.noise_order] = gradient.noise_order;
  g[o.mesh_amplitude] = gradient.mesh_amplitude;
  g.segment(o.mesh_length, o.inputs) = gradient.mesh_length;
  g[o.mesh_order] = gradient.mesh_order;
  return g;
}

// ln likelihood of some runs, and what the beliefs add to it.
class Posterior {
 public:
  Posterior(const MeshPoints& points, const Eigen::VectorXd& values, double plane_deviation,
            const std::vector<Belief>& beliefs)
      : order_{static_cast<int>(points.inputs.cols())},
        points_(points),
        values_(values),
        plane_deviation_(plane_deviation),
        beliefs_(beliefs) {}

  // Climbs from `start`; what was best is best().
  void climb(const std::vector<double>& start, int evaluations) {
    nlopt::opt search(nlopt::LD_SLSQP, static_cast<unsigned>(start.size()));
    std::vector<double> low, high, from = start;
    for (std::size_t k = 0; k < start.size(); ++k) {
      low.push_back(beliefs_[k].low);
      high.push_back(beliefs_[k].high);
      from[k] = std::clamp(from[k], low[k], high[k]);
    }
    search.set_lower_bounds(low);
    search.set_upper_bounds(high);
    search.set_max_objective([](const std::vector<double>& at, std::vector<double>& gradient,
                                void* self) { return static_cast<Posterior*>(self)->value(at, gradient); },
                             this);
    search.set_ftol_abs(tolerance);
    search.set_xtol_abs(1e-4);
    search.set_maxeval(evaluations);
    double reached = 0;
    try {
      search.optimize(from, reached);
    } catch (const std::runtime_error&) {  // rounding, or no step that is better: the best so far stands
    }
  }

  const std::vector<double>& best() const { return best_; }
  double best_value() const { return best_value_; }
  double best_likelihood() const { return best_likelihood_; }
  int evaluations() const { return evaluations_; }

 private:
  double value(const std::vector<double>& at, std::vector<double>& gradient) {
    ++evaluations_;
    const DepthCovariance covariance(parameters_at(order_, at), plane_deviation_);
    const auto process = GaussianProcess::conditioned(covariance.of_runs(points_), values_);
    if (!process) {
      std::ranges::fill(gradient, 0.0);
      return -1e10;
    }
    const double likelihood = process->log_likelihood();
    double sum = likelihood;
    for (std::size_t k = 0; k < at.size(); ++k) {
      const double away = (at[k] - beliefs_[k].centre) / beliefs_[k].deviation;
      sum -= 0.5 * away * away;
      if (!gradient.empty()) gradient[k] = -away / beliefs_[k].deviation;
    }
    if (!gradient.empty()) {
      const auto by_parameters = covariance.contracted_gradient(points_, process->likelihood_gradient());
      Eigen::Map<Eigen::VectorXd>(gradient.data(), static_cast<Eigen::Index>(gradient.size())) +=
          in_search_order(order_, by_parameters, static_cast<Eigen::Index>(gradient.size()));
    }
    if (sum > best_value_) {
      best_value_ = sum;
      best_likelihood_ = likelihood;
      best_ = at;
    }
    return sum;
  }

  SearchOrder order_;
  MeshPoints points_;
  Eigen::VectorXd values_;
  double plane_deviation_;
  std::vector<Belief> beliefs_;
  std::vector<double> best_;
  double best_value_ = -std::numeric_limits<double>::infinity(), best_likelihood_ = 0;
  int evaluations_ = 0;
};

// The scatter about the plane through the runs.
double roughness_of(const TrainingData& data) {
  const Eigen::Index n = data.values.size();
  Eigen::MatrixXd plane(n, data.scale.inputs() + 2);
  plane << Eigen::VectorXd::Ones(n), data.points.inputs, data.points.h;
  const Eigen::VectorXd rest = data.values - plane * plane.completeOrthogonalDecomposition().solve(data.values);
  return std::max(spread(rest), smallest_roughness * spread(data.values));
}

// Smooth and little noise; wavy and little noise; nearly a plane with much noise.
std::vector<std::vector<double>> starts(const SearchOrder& o, const std::vector<Belief>& beliefs) {
  std::vector<double> middle;
  for (const Belief& belief : beliefs) middle.push_back(belief.centre);
  std::vector<double> wavy = middle, plain = middle;
  for (int j = 0; j < o.inputs; ++j) wavy[o.length + j] -= std::log(3), plain[o.length + j] += std::log(2);
  plain[o.noise] += std::log(2.5);
  plain[o.amplitude] -= std::log(4);
  return {middle, wavy, plain};
}

EmulatorSettings in_input_units(const CovarianceParameters& p, const InputScale& scale) {
  EmulatorSettings settings;
  settings.amplitude = p.amplitude;
  settings.mesh_amplitude = p.mesh_amplitude;
  settings.mesh_order = p.mesh_order;
  settings.noise = p.noise;
  settings.noise_order = p.noise_order;
  for (int j = 0; j < scale.inputs(); ++j) {
    settings.length[scale.seen[j]] = p.length[j] * scale.half_range[j];
    settings.mesh_length[scale.seen[j]] = p.mesh_length[j] * scale.half_range[j];
  }
  return settings;
}

// Evenly spaced members of a list, all of it where it is short.
std::vector<int> evenly(const std::vector<int>& all, int most) {
  const int count = static_cast<int>(all.size());
  if (count <= most) return all;
  std::vector<int> some;
  for (long k = 0; k < most; ++k) some.push_back(all[k * count / most]);
  return some;
}

Posterior posterior_of(const TrainingData& data, const std::vector<int>& chosen, const std::vector<Belief>& beliefs) {
  return Posterior({data.points.inputs(chosen, Eigen::all), data.points.h(chosen)}, data.values(chosen),
                   data.plane_deviation, beliefs);
}

}  // namespace

TrainingData::TrainingData(const std::vector<TrainingRun>& runs) : scale(scale_of(runs)) {
  const auto n = static_cast<Eigen::Index>(runs.size());
  points = {Eigen::MatrixXd(n, scale.inputs()), Eigen::VectorXd(n)};
  values.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    points.inputs.row(i) = scale.scaled(runs[i].at).transpose();
    points.h[i] = runs[i].h / reference_h;
    values[i] = runs[i].log_depth;
  }
  mean = values.mean();
  values.array() -= mean;
  plane_deviation = plane_over_spread * spread(values);
}

std::vector<int> runs_for_search(const std::vector<TrainingRun>& runs, int most) {
  const double coarsest = std::ranges::max_element(runs, {}, &TrainingRun::h)->h;
  std::vector<int> coarse, fine;
  for (int i = 0; i < static_cast<int>(runs.size()); ++i) (runs[i].h < coarsest ? fine : coarse).push_back(i);
  const int fine_places = std::max(most / 2, most - static_cast<int>(coarse.size()));
  std::vector<int> chosen = evenly(fine, fine_places);
  const std::vector<int> rest = evenly(coarse, most - static_cast<int>(chosen.size()));
  chosen.insert(chosen.end(), rest.begin(), rest.end());
  std::ranges::sort(chosen);
  return chosen;
}

EmulatorSettings find_settings(const std::vector<TrainingRun>& runs, const EmulatorOptions& options) {
  const TrainingData data(runs);
  const std::vector<int> chosen = runs_for_search(runs, options.most_points_for_search);
  const SearchOrder order{data.scale.inputs()};
  const auto believed = beliefs(order, roughness_of(data), spread(data.values), has_several_meshes(runs));

  Posterior first =
      posterior_of(data, runs_for_search(runs, std::min<int>(options.most_points_for_starts, chosen.size())), believed);
  for (const auto& start : starts(order, believed))
    first.climb(start, std::min(evaluations_of_a_start, options.most_evaluations));
  Posterior second = posterior_of(data, chosen, believed);
  second.climb(first.best(), std::max(1, options.most_evaluations - first.evaluations()));

  EmulatorSettings settings = in_input_units(parameters_at(order, second.best()), data.scale);
  settings.log_likelihood = second.best_likelihood();
  settings.evaluations = first.evaluations() + second.evaluations();
  return settings;
}

}  // namespace percal
