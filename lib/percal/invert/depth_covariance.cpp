#include "percal/invert/depth_covariance.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "percal/invert/kernel/kernel.hpp"

namespace percal {
namespace {

static_assert(sphere_inputs <= emulator_inputs);

// Below this share of its size an input's range is rounding.
constexpr double smallest_range = 1e-9;

constexpr double vanishing_alpha = 1e-4;  // below it rounding would spoil the general formula

// A cover t thick takes about this many W t/a, over rho_p v^2, off a sphere: 1 where it just stops it.
constexpr double loss = 4;

double square(double x) { return x * x; }

// Of every number of `s`: docs/theory/emulator.md (3) and its derivative.
Eigen::ArrayXXd correlations(const Eigen::ArrayXXd& s) {
  Eigen::ArrayXXd values(s.rows(), s.cols());
  emulator_kernel().matern52(s.data(), s.size(), values.data(), nullptr);
  return values;
}
struct CorrelationsWithSlopes {
  Eigen::ArrayXXd values, slopes;
};
CorrelationsWithSlopes correlations_with_slopes(const Eigen::ArrayXXd& s) {
  CorrelationsWithSlopes both{Eigen::ArrayXXd(s.rows(), s.cols()), Eigen::ArrayXXd(s.rows(), s.cols())};
  emulator_kernel().matern52(s.data(), s.size(), both.values.data(), both.slopes.data());
  return both;
}

// sum_ab W_ab (u_aj - u_bj)^2 for every column j of u; W symmetric.
Eigen::VectorXd weighted_squared_differences(const Eigen::MatrixXd& u, const Eigen::MatrixXd& w) {
  const Eigen::VectorXd row_sums = w.rowwise().sum();
  const Eigen::VectorXd squares = u.cwiseAbs2().transpose() * row_sums;
  const Eigen::VectorXd products = u.cwiseProduct(w * u).colwise().sum().transpose();
  return 2 * (squares - products);
}

}  // namespace

Eigen::ArrayXXd scaled_squared_distances(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                                         const Eigen::VectorXd& length) {
  const Eigen::MatrixXd first = a * length.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd second = b * length.cwiseInverse().asDiagonal();
  Eigen::MatrixXd squares = -2 * first * second.transpose();
  squares.colwise() += first.rowwise().squaredNorm();
  squares.rowwise() += second.rowwise().squaredNorm().transpose();
  return squares.array().max(0.0);
}

LogErosionEnergy log_erosion_energy(double alpha, double strain) {
  const double stretch = 1 + strain, log_stretch = std::log1p(strain);
  if (std::abs(alpha) < vanishing_alpha)  // W/mu = (3/2) ln^2 l + alpha (1/4) ln^3 l
    return {std::log(1.5) + 2 * std::log(log_stretch) + alpha * log_stretch / 6, log_stretch / 6,
            2 / (stretch * log_stretch)};
  const double up = std::exp(alpha * log_stretch), across = std::exp(-0.5 * alpha * log_stretch);
  const double sum = std::expm1(alpha * log_stretch) + 2 * std::expm1(-0.5 * alpha * log_stretch);
  return {std::log(2 / (alpha * alpha) * sum), (up - across) * log_stretch / sum - 2 / alpha,
          alpha * (up - across) / (stretch * sum)};
}

// What a cover does to the features, and what of it is by the inputs.                                                  (2a)
class CoverFeatures {
 public:
  CoverFeatures(const SphereInputs& at, const CoverMembers& cover)
      : at_(at),
        cover_(cover),
        weight_(at.*cover.depth),
        layer_(log_erosion_energy(at.alpha, at.erosion_strain)),
        own_(log_erosion_energy(at.*cover.alpha, at.*cover.strain)) {
    const double log_size = std::log(loss * std::expm1(weight_)) - at.log_pi4 + at.log_pi5;
    own_loss_ = std::exp(log_size + own_.value + at.*cover.log_mu);
    layer_loss_ = std::exp(log_size + layer_.value);
  }

  void write(Eigen::VectorXd& features) const {
    features[index_of(cover_.log_density)] = weight_ * at_.*cover_.log_density;
    features[index_of(cover_.log_mu)] = std::log1p(own_loss_) - std::log1p(layer_loss_);
    features[index_of(cover_.alpha)] = weight_ * (at_.*cover_.alpha - at_.alpha);
    features[index_of(cover_.strain)] = weight_ * (at_.*cover_.strain - at_.erosion_strain);
  }

  void add_gradient(const Eigen::VectorXd& by_features, Eigen::VectorXd& gradient) const {
    const double by_density = by_features[index_of(cover_.log_density)], by_loss = by_features[index_of(cover_.log_mu)],
                 by_alpha = by_features[index_of(cover_.alpha)], by_strain = by_features[index_of(cover_.strain)];
    const double own = by_loss * own_loss_ / (1 + own_loss_), layer = by_loss * layer_loss_ / (1 + layer_loss_);
    gradient[index_of(cover_.depth)] += by_density * at_.*cover_.log_density + (own - layer) / -std::expm1(-weight_) +
                                        by_alpha * (at_.*cover_.alpha - at_.alpha) +
                                        by_strain * (at_.*cover_.strain - at_.erosion_strain);
    gradient[index_of(cover_.log_density)] = weight_ * by_density;
    gradient[index_of(cover_.log_mu)] = own;
    gradient[index_of(cover_.alpha)] = weight_ * by_alpha + own * own_.by_alpha;
    gradient[index_of(cover_.strain)] = weight_ * by_strain + own * own_.by_strain;
    gradient[index_of(&SphereInputs::alpha)] -= weight_ * by_alpha + layer * layer_.by_alpha;
    gradient[index_of(&SphereInputs::erosion_strain)] -= weight_ * by_strain + layer * layer_.by_strain;
    gradient[index_of(&SphereInputs::log_pi4)] -= own - layer;
    gradient[index_of(&SphereInputs::log_pi5)] += own - layer;
  }

 private:
  const SphereInputs& at_;
  const CoverMembers& cover_;
  double weight_;
  LogErosionEnergy layer_, own_;
  double own_loss_ = 0, layer_loss_ = 0;  // over the sphere's energy, of the cover and of as much of the layer
};

Eigen::VectorXd depth_features(const SphereInputs& at) {
  Eigen::VectorXd features = in_order(at);
  features[index_of(&SphereInputs::log_pi4)] -= log_erosion_energy(at.alpha, at.erosion_strain).value;
  for (const CoverMembers& cover : cover_members) {
    for (double SphereInputs::*number : {cover.log_density, cover.log_mu, cover.alpha, cover.strain})
      features[index_of(number)] = 0;
    if (at.*cover.depth > 0) CoverFeatures(at, cover).write(features);
  }
  return features;
}

Eigen::VectorXd by_inputs(const SphereInputs& at, const Eigen::VectorXd& by_features) {
  const LogErosionEnergy energy = log_erosion_energy(at.alpha, at.erosion_strain);
  const double by_log_pi4 = by_features[index_of(&SphereInputs::log_pi4)];
  Eigen::VectorXd gradient = by_features;
  gradient[index_of(&SphereInputs::alpha)] -= by_log_pi4 * energy.by_alpha;
  gradient[index_of(&SphereInputs::erosion_strain)] -= by_log_pi4 * energy.by_strain;
  for (const CoverMembers& cover : cover_members) {
    for (double SphereInputs::*number : {cover.log_density, cover.log_mu, cover.alpha, cover.strain})
      gradient[index_of(number)] = 0;
    if (at.*cover.depth > 0) CoverFeatures(at, cover).add_gradient(by_features, gradient);
  }
  return gradient;
}

Eigen::VectorXd InputScale::scaled(const SphereInputs& at) const {
  return (depth_features(at)(seen) - centre).cwiseQuotient(half_range);
}

Eigen::VectorXd InputScale::unscaled_gradient(const SphereInputs& at, const Eigen::VectorXd& by_scaled) const {
  Eigen::VectorXd by_features = Eigen::VectorXd::Zero(sphere_inputs);
  by_features(seen) = by_scaled.cwiseQuotient(half_range);
  return by_inputs(at, by_features);
}

InputScale scale_of(const std::vector<TrainingRun>& runs) {
  Eigen::VectorXd low = depth_features(runs.front().at), high = low;
  for (const TrainingRun& run : runs) {
    const Eigen::VectorXd features = depth_features(run.at);
    low = low.cwiseMin(features);
    high = high.cwiseMax(features);
  }
  const Eigen::VectorXd centre = 0.5 * (low + high);
  Eigen::VectorXd half_range = 0.5 * (high - low);
  std::vector<int> seen;
  for (int j = 0; j < sphere_inputs; ++j) {
    const bool varies = half_range[j] > smallest_range * (1 + std::abs(centre[j]));
    if (!varies) half_range[j] = 1;
    if (varies || j < inputs_of_all) seen.push_back(j);
  }
  return {seen, centre(seen), half_range(seen)};
}

CovarianceParameters covariance_parameters(const EmulatorSettings& settings, const InputScale& scale) {
  CovarianceParameters parameters;
  parameters.length.resize(scale.inputs());
  parameters.mesh_length.resize(scale.inputs());
  parameters.amplitude = settings.amplitude;
  parameters.mesh_amplitude = settings.mesh_amplitude;
  parameters.mesh_order = settings.mesh_order;
  parameters.noise = settings.noise;
  parameters.noise_order = settings.noise_order;
  for (int j = 0; j < scale.inputs(); ++j) {
    parameters.length[j] = settings.length[scale.seen[j]] / scale.half_range[j];
    parameters.mesh_length[j] = settings.mesh_length[scale.seen[j]] / scale.half_range[j];
  }
  return parameters;
}

DepthCovariance::DepthCovariance(CovarianceParameters parameters, double plane_deviation)
    : parameters_(std::move(parameters)), plane_variance_(square(plane_deviation)) {}

Eigen::VectorXd DepthCovariance::mesh_factors(const Eigen::VectorXd& h) const {
  if (!has_mesh()) return Eigen::VectorXd::Zero(h.size());
  return h.array().pow(parameters_.mesh_order);
}

double DepthCovariance::noise(double h) const { return parameters_.noise * std::pow(h, parameters_.noise_order); }

// docs/theory/emulator.md (4)
Eigen::MatrixXd DepthCovariance::between(const MeshPoints& a, const MeshPoints& b) const {
  const CovarianceParameters& p = parameters_;
  const Eigen::VectorXd mesh_a = mesh_factors(a.h), mesh_b = mesh_factors(b.h);
  const Eigen::ArrayXXd plane = 1 + (a.inputs * b.inputs.transpose() + mesh_a * mesh_b.transpose()).array();
  Eigen::ArrayXXd covariance = plane_variance_ * plane + square(p.amplitude) * correlations(scaled_squared_distances(
                                                                                   a.inputs, b.inputs, p.length));
  if (has_mesh())
    covariance += square(p.mesh_amplitude) * (mesh_a * mesh_b.transpose()).array() *
                  correlations(scaled_squared_distances(a.inputs, b.inputs, p.mesh_length));
  return covariance;
}

Eigen::VectorXd DepthCovariance::variances(const MeshPoints& points) const {
  const Eigen::ArrayXd mesh_squares = mesh_factors(points.h).array().square();
  const Eigen::ArrayXd plane = 1 + points.inputs.rowwise().squaredNorm().array() + mesh_squares;
  return plane_variance_ * plane + square(parameters_.amplitude) + square(parameters_.mesh_amplitude) * mesh_squares;
}

Eigen::MatrixXd DepthCovariance::of_runs(const MeshPoints& runs) const {
  Eigen::MatrixXd covariance = between(runs, runs);
  for (Eigen::Index i = 0; i < runs.h.size(); ++i) covariance(i, i) += square(noise(runs.h[i]));
  return covariance;
}

WeightedCovariance::WeightedCovariance(const DepthCovariance& covariance, const MeshPoints& runs,
                                       const Eigen::VectorXd& weights)
    : mesh_order_(covariance.parameters_.mesh_order),
      plane_variance_(covariance.plane_variance_),
      all_weights_(weights.sum()),
      plane_(runs.inputs.transpose() * weights) {
  const CovarianceParameters& p = covariance.parameters_;
  const auto smooth = [&](double amplitude, const Eigen::VectorXd& w, const Eigen::VectorXd& length) {
    const Eigen::Index rows = w.size(), padded = (rows + emulator_lanes - 1) / emulator_lanes * emulator_lanes;
    Smooth one{square(amplitude), length, Eigen::VectorXd::Zero(padded), Eigen::MatrixXd::Zero(padded, length.size())};
    one.weights.head(rows) = w;
    one.inputs.topRows(rows) = runs.inputs * length.cwiseInverse().asDiagonal();
    return one;
  };
  own_ = smooth(p.amplitude, weights, p.length);
  const Eigen::VectorXd mesh_weights = covariance.mesh_factors(runs.h).cwiseProduct(weights);
  all_mesh_weights_ = mesh_weights.sum();
  if (covariance.has_mesh()) mesh_ = smooth(p.mesh_amplitude, mesh_weights, p.mesh_length);
}

void WeightedCovariance::Smooth::add_to(Sum& sum, const Eigen::VectorXd& at, double times) const {
  const Eigen::VectorXd here = at.cwiseQuotient(length);
  std::array<double, emulator_inputs + 1> sums;
  emulator_kernel().matern52_sums(inputs.data(), weights.data(), static_cast<int>(inputs.rows()),
                                  static_cast<int>(inputs.cols()), here.data(), sums.data());
  sum.value += factor * times * sums[0];
  for (Eigen::Index j = 0; j < at.size(); ++j)
    sum.gradient[j] += factor * times * sums[static_cast<std::size_t>(j) + 1] / length[j];
}

WeightedCovariance::Sum WeightedCovariance::at(const Eigen::VectorXd& inputs, double h) const {
  const double mesh_here = mesh_.factor > 0 ? std::pow(h, mesh_order_) : 0;
  Sum sum{.value = plane_variance_ * (all_weights_ + inputs.dot(plane_) + mesh_here * all_mesh_weights_),
          .gradient = plane_variance_ * plane_};
  own_.add_to(sum, inputs, 1);
  if (mesh_here > 0) mesh_.add_to(sum, inputs, mesh_here);
  return sum;
}

// docs/theory/emulator.md (8)
CovarianceParameters DepthCovariance::contracted_gradient(const MeshPoints& runs, const Eigen::MatrixXd& g) const {
  const CovarianceParameters& p = parameters_;
  CovarianceParameters gradient;
  // Of sum_ab w_ab factor c(s_ab), w symmetric: by ln length.
  const auto by_lengths = [&](const Eigen::MatrixXd& w, const Eigen::ArrayXXd& slopes, const Eigen::VectorXd& length) {
    const Eigen::MatrixXd by_distance = w.array() * slopes;
    return Eigen::VectorXd(-2 *
                           weighted_squared_differences(runs.inputs, by_distance).cwiseQuotient(length.cwiseAbs2()));
  };

  const auto own = correlations_with_slopes(scaled_squared_distances(runs.inputs, runs.inputs, p.length));
  const Eigen::MatrixXd smooth = square(p.amplitude) * g;
  gradient.amplitude = 2 * (smooth.array() * own.values).sum();
  gradient.length = by_lengths(smooth, own.slopes, p.length);

  const Eigen::ArrayXd noise_terms = g.diagonal().array() * (p.noise * runs.h.array().pow(p.noise_order)).square();
  gradient.noise = 2 * noise_terms.sum();
  gradient.noise_order = 2 * (noise_terms * runs.h.array().log()).sum();

  gradient.mesh_amplitude = gradient.mesh_order = 0;
  gradient.mesh_length.setZero(runs.inputs.cols());
  if (!has_mesh()) return gradient;
  const Eigen::VectorXd factors = mesh_factors(runs.h);
  const auto of_mesh = correlations_with_slopes(scaled_squared_distances(runs.inputs, runs.inputs, p.mesh_length));
  const Eigen::MatrixXd with_factors = g.array() * (factors * factors.transpose()).array();
  const Eigen::MatrixXd mesh = square(p.mesh_amplitude) * with_factors;
  const Eigen::MatrixXd mesh_terms = mesh.array() * of_mesh.values;
  gradient.mesh_amplitude = 2 * mesh_terms.sum();
  gradient.mesh_length = by_lengths(mesh, of_mesh.slopes, p.mesh_length);
  const Eigen::VectorXd row_sums = (mesh_terms + plane_variance_ * with_factors).rowwise().sum();
  gradient.mesh_order = 2 * row_sums.dot(runs.h.array().log().matrix());
  return gradient;
}

}  // namespace percal
