// The depth of a sphere as a smooth function of the dimensionless problem, learnt from finished runs: one Gaussian process for
// one setting of the solver (strain measure, contact, ...), with the mesh as a variable of its own. docs/theory/emulator.md
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

namespace percal {

// What decides a sphere's depth.
struct SphereInputs {
  double log_pi4 = 0;  // ln(rho_t v^2/mu)
  double log_pi5 = 0;  // ln(rho_t/rho_p)
  double alpha = 0;
  double erosion_strain = 0;      // engineering, the critical stretch less 1: above 0
  double log_layer_depth = 0;     // ln(L/a)
  double log_bulk_ratio = 0;      // ln(K/mu)
  double log_erosion_length = 0;  // ln(l/a); 0 where each element is judged by itself
  // Of layers on top of the one that all of the above is of, which are covers of it; the next to it first. All 0 where there is none.
  double cover_depth = 0;                          // ln(1 + t/a), t its thickness
  double cover_log_density = 0, cover_log_mu = 0;  // ln of either over the covered layer's
  double cover_alpha = 0, cover_strain = 0;        // as alpha and erosion_strain
  double second_depth = 0, second_log_density = 0, second_log_mu = 0, second_alpha = 0, second_strain = 0;
  bool operator==(const SphereInputs&) const = default;
};

// Their order in vectors, lengths and gradients.
inline constexpr std::array sphere_input_order{&SphereInputs::log_pi4,
                                               &SphereInputs::log_pi5,
                                               &SphereInputs::alpha,
                                               &SphereInputs::erosion_strain,
                                               &SphereInputs::log_layer_depth,
                                               &SphereInputs::log_bulk_ratio,
                                               &SphereInputs::log_erosion_length,
                                               &SphereInputs::cover_depth,
                                               &SphereInputs::cover_log_density,
                                               &SphereInputs::cover_log_mu,
                                               &SphereInputs::cover_alpha,
                                               &SphereInputs::cover_strain,
                                               &SphereInputs::second_depth,
                                               &SphereInputs::second_log_density,
                                               &SphereInputs::second_log_mu,
                                               &SphereInputs::second_alpha,
                                               &SphereInputs::second_strain};
inline constexpr int sphere_inputs = sphere_input_order.size();
// The first so many are of every sphere; the others are left out of an emulator none of whose runs varies them.
inline constexpr int inputs_of_all = 6;
inline constexpr int inputs_without_covers = inputs_of_all + 1;

// Where a cover's numbers are.
struct CoverMembers {
  double SphereInputs::*depth, SphereInputs::*log_density, SphereInputs::*log_mu, SphereInputs::*alpha,
      SphereInputs::*strain;
};
inline constexpr std::array cover_members{
    CoverMembers{&SphereInputs::cover_depth, &SphereInputs::cover_log_density, &SphereInputs::cover_log_mu,
                 &SphereInputs::cover_alpha, &SphereInputs::cover_strain},
    CoverMembers{&SphereInputs::second_depth, &SphereInputs::second_log_density, &SphereInputs::second_log_mu,
                 &SphereInputs::second_alpha, &SphereInputs::second_strain}};
inline constexpr int most_covers = cover_members.size();

// A cover of a layer: its thickness in radii, density and modulus over the layer's.
struct CoverNumbers {
  double thickness = 0, density = 1, mu = 1, alpha = 0, erosion_strain = 0;
};
void lay_on(SphereInputs& at, const CoverMembers& place, const CoverNumbers& cover);
constexpr int index_of(double SphereInputs::*input) {
  int k = 0;
  while (sphere_input_order[k] != input) ++k;
  return k;
}
Eigen::VectorXd in_order(const SphereInputs& at);

// A finished run that the emulator learns from.
struct TrainingRun {
  SphereInputs at;
  double h = 0.1;        // element size over radius, or over the erosion length where there is one
  double log_depth = 0;  // ln(depth / radius) of a run that stopped
};

// What the hyperparameter search found. Lengths are in units of the inputs; the first is of ln pi4 at constant alpha and strain,
// see depth_covariance.hpp.
struct EmulatorSettings {
  double amplitude = 1;                        // standard deviation of the smooth part
  std::array<double, sphere_inputs> length{};  // 0 of an input that is left out
  double mesh_amplitude = 0;                   // of the part that the mesh adds, at h = 0.1
  std::array<double, sphere_inputs> mesh_length{};
  double mesh_order = 1;   // it goes as h^order
  double noise = 0.015;    // the solver's own, standard deviation of ln depth (the nugget), at h = 0.1
  double noise_order = 0;  // noise goes as h^order
  double log_likelihood = 0;
  int evaluations = 0;  // of the likelihood

  int inputs() const {
    return static_cast<int>(std::ranges::count_if(length, [](double one) { return one > 0; }));
  }
};

struct EmulatorOptions {
  int most_points_for_search = 500;  // hyperparameters are found on a subset of at most this many
  int most_points_for_starts = 150;  // the search begins on a subset of those
  int most_evaluations = 300;
};

// Of the smooth depth, without the solver's noise.
struct DepthAnswers {
  Eigen::VectorXd log_depth;
  Eigen::MatrixXd gradient;    // points x sphere_inputs; 0 by an input that is left out
  Eigen::MatrixXd covariance;  // points x points; empty where not wanted
};

// Leave-one-out: (prediction - run) of each training point, and over its predicted standard deviation (noise included).
struct LeaveOneOut {
  std::vector<double> error, standardised;
  double root_mean_square = 0;        // of ln depth
  double standardised_deviation = 0;  // 1 where the stated error is right
  double coverage95 = 0;              // share within the stated 95 %
};

// Elements per radius, or per erosion length: runs no further apart are on one mesh, in different phases, and tell nothing of the element size.
inline constexpr double one_mesh_span = 1.7 * (1 + 1e-9);

inline constexpr int fewest_training_runs = 2 * inputs_of_all;

class Emulator {
 public:
  // The same runs in the same order give the same bits. Throws BadInput for fewer than fewest_training_runs.
  Emulator(std::vector<TrainingRun> runs, const EmulatorOptions& options);
  // As before, with settings that are known: no search.
  Emulator(std::vector<TrainingRun> runs, const EmulatorSettings& settings);

  // The depth on a mesh of element size h; 0: extrapolated to none.
  DepthAnswers depth(const std::vector<SphereInputs>& at, double h, bool with_covariance) const;

  LeaveOneOut leave_one_out() const;
  const EmulatorSettings& settings() const;
  const std::vector<TrainingRun>& runs() const;
  // Of one run on a mesh of element size h.
  double noise(double h) const;

  // Chooses `count` of the candidates so that the sum of the variances at `targets` (weights w, on the mesh h_target) falls most
  // for its cost, one after the other, each knowing the ones before. Indices in the order of choice; the same input gives the
  // same choice.
  struct CandidateRun {
    SphereInputs at;
    double h = 0.1;
    double cost = 1;
  };
  std::vector<int> choose(const std::vector<CandidateRun>& candidates, int count,
                          const std::vector<SphereInputs>& targets, const std::vector<double>& weights,
                          double h_target) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace percal
