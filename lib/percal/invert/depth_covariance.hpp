// The covariance of ln depth at points of the input space and mesh sizes: a plane with slopes that nobody knows beforehand, a smooth
// part, and a part that the mesh adds.                                                         docs/theory/emulator.md
#pragma once
#include <Eigen/Core>
#include <vector>

#include "percal/invert/emulator.hpp"

namespace percal {

// W/mu of a uniaxial tension test at an engineering strain > 0, (2/alpha^2) (l^alpha + 2 l^(-alpha/2) - 3) with l = 1 + strain:
// its logarithm, and that one's derivatives.
struct LogErosionEnergy {
  double value, by_alpha, by_strain;
};
LogErosionEnergy log_erosion_energy(double alpha, double strain);

// What the covariance sees of the inputs: the first, ln pi4, becomes the logarithm of the impact's energy density over that which a
// tension test puts into the material until it erodes, ln pi4 - ln(W/mu). Depths depend on that number most.            (2)
// A cover's numbers become its differences to the covered layer, times ln(1 + t/a), and its modulus the energy density until it erodes: a
// thin cover is as good as none, and one of the same material, too.                                                     (2a)
Eigen::VectorXd depth_features(const SphereInputs& at);

// Of a function with this gradient with respect to the features.
Eigen::VectorXd by_inputs(const SphereInputs& at, const Eigen::VectorXd& by_features);

// sum_j ((x_j - y_j)/length_j)^2 of every row x of `a` (n x d) with every row y of `b` (m x d): n x m. Lengths not 0.
Eigen::ArrayXXd scaled_squared_distances(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                                         const Eigen::VectorXd& length);

// The features are shifted and scaled so that those of the runs lie in [-1, 1]. Of those that never vary the first inputs_of_all keep
// their own unit, and the others are left out. "Inputs" below are these scaled features.
struct InputScale {
  std::vector<int> seen;               // which features
  Eigen::VectorXd centre, half_range;  // of inputs()

  int inputs() const { return static_cast<int>(centre.size()); }

  Eigen::VectorXd scaled(const SphereInputs& at) const;
  // With respect to the sphere_inputs themselves.
  Eigen::VectorXd unscaled_gradient(const SphereInputs& at, const Eigen::VectorXd& by_scaled) const;
};
InputScale scale_of(const std::vector<TrainingRun>& runs);

// Points with the meshes they are seen on: scaled inputs (points x inputs), and h / 0.1.
struct MeshPoints {
  Eigen::MatrixXd inputs;
  Eigen::VectorXd h;
};

inline constexpr double reference_h = 0.1;

// The hyperparameters, for scaled inputs. mesh_amplitude = 0: no mesh part.
struct CovarianceParameters {
  double amplitude = 1;
  Eigen::VectorXd length = Eigen::VectorXd::Ones(sphere_inputs);
  double mesh_amplitude = 0;
  Eigen::VectorXd mesh_length = Eigen::VectorXd::Ones(sphere_inputs);
  double mesh_order = 1;
  double noise = 0.015;
  double noise_order = 0;
};
CovarianceParameters covariance_parameters(const EmulatorSettings& settings, const InputScale& scale);

class DepthCovariance {
 public:
  // `plane_deviation`: prior standard deviation of the plane's constant and slopes, large beside what the runs show.
  DepthCovariance(CovarianceParameters parameters, double plane_deviation);

  // Of the smooth depth at every point of `a` with every one of `b`.
  Eigen::MatrixXd between(const MeshPoints& a, const MeshPoints& b) const;
  // Of the smooth depth of each point with itself.
  Eigen::VectorXd variances(const MeshPoints& points) const;
  // Of runs: the smooth depth, and each run's own noise.
  Eigen::MatrixXd of_runs(const MeshPoints& runs) const;
  double noise(double h) const;                                  // standard deviation; h over 0.1
  Eigen::VectorXd mesh_factors(const Eigen::VectorXd& h) const;  // h^q; 0 where there is no mesh part

  // Of sum_ab G_ab K_ab (K as of_runs says, G symmetric) with respect to the parameters. Amplitudes, lengths and noise stand for
  // their logarithms.
  CovarianceParameters contracted_gradient(const MeshPoints& runs, const Eigen::MatrixXd& g) const;

 private:
  bool has_mesh() const { return parameters_.mesh_amplitude > 0; }

  friend class WeightedCovariance;
  CovarianceParameters parameters_;
  double plane_variance_;
};

// sum_i weights_i cov(at, run_i) for many `at`, with its derivative: the mean of a process, (6) and (7). What does not hang on `at` is
// computed once.
class WeightedCovariance {
 public:
  WeightedCovariance(const DepthCovariance& covariance, const MeshPoints& runs, const Eigen::VectorXd& weights);

  struct Sum {
    double value = 0;
    Eigen::VectorXd gradient;  // with respect to the scaled inputs of `at`
  };
  Sum at(const Eigen::VectorXd& inputs, double h) const;

 private:
  // factor sum_i w_i c(s_i) with s_i the squared distance in lengths; runs are padded for the kernel
  struct Smooth {
    double factor = 0;
    Eigen::VectorXd length, weights;
    Eigen::MatrixXd inputs;  // of the runs, in lengths: runs x inputs
    void add_to(Sum& sum, const Eigen::VectorXd& at, double times) const;
  };
  Smooth own_, mesh_;
  double mesh_order_, plane_variance_;
  double all_weights_, all_mesh_weights_;
  Eigen::VectorXd plane_;  // sum of weights times inputs
};

}  // namespace percal
