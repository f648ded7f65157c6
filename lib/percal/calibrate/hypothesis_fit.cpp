#include "percal/calibrate/hypothesis_fit.hpp"

#include <algorithm>
#include <cmath>

#include "percal/calibrate/error_budget.hpp"
#include "percal/calibrate/hypothesis_findings.hpp"
#include "percal/calibrate/kept_model.hpp"
#include "percal/calibrate/shot_problem.hpp"
#include "percal/calibrate/verdict.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

using Eigen::VectorXd;

constexpr int ridge_grid = 9;  // points along each axis

// Place of a material's number among the fitted parameters; -1 where it is not fitted.
int fitted_place(const JobModel& model, const JobFit& fit, const MaterialNumber& number) {
  const auto* shared = std::get_if<SharedParameter>(&number);
  if (!shared) return -1;
  for (std::size_t k = 0; k < fit.of_model.size(); ++k)
    if (model.of_job[fit.of_model[k]] == shared->index) return static_cast<int>(k);
  return -1;
}

// A fitted shot says how deep it went into this material, and nothing is lost by reporting on it: the first material, and those whose
// quasi-static modulus is asked for.
bool told_about(const CalibrationJob& job, const JobFit& fit, std::size_t material) {
  const bool measured = std::any_of(fit.shots.begin(), fit.shots.end(), [&](int i) {
    return meets(job, job.shots[i], static_cast<int>(material)) && job.shots[i].is_number();
  });
  return measured && (material == 0 || job.materials[material].rate_factor);
}

std::vector<RidgeMap> ridges(const CalibrationJob& job, const JobModel& model, const JobFit& fit,
                             const SearchOptions& search) {
  std::vector<RidgeMap> maps;
  for (std::size_t m = 0; m < job.materials.size(); ++m) {
    const int mu = fitted_place(model, fit, job.materials[m].mu);
    const int strain = fitted_place(model, fit, job.materials[m].erosion_strain);
    if (told_about(job, fit, m) && mu >= 0 && strain >= 0)
      maps.push_back(ridge_map(fit.problem, fit.best(), strain, mu, ridge_grid, search));
  }
  return maps;
}

// Each shot from the fit to others.
void add_predictions(const CalibrationJob& job, int hypothesis, const JobModel& model, const JobFit& fit,
                     const SearchOptions& search, HypothesisResult& result) {
  for (const CrossValidation& wanted : job.cross_validations)
    if (wanted.hypotheses.empty() || std::count(wanted.hypotheses.begin(), wanted.hypotheses.end(), hypothesis))
      result.cross_validations.push_back(cross_validate(job, model, wanted, search));
  for (std::size_t s = 0; s < job.sets.size(); ++s)
    if (job.sets[s].leave_one_out)
      result.leave_one_out.push_back(leave_one_out(job, model, static_cast<int>(s), fit, search));
}

// Akaike's criterion for small samples (Hurvich and Tsai 1989): -2 ln L + 2 k + 2 k (k + 1)/(n - k - 1), k parameters and estimated
// scatters.
std::optional<double> aicc_of(const JobFit& fit) {
  std::size_t scatters = 0;
  for (std::size_t g = 0; g < fit.problem.groups.size(); ++g)
    scatters += fit.problem.groups[g].estimated && std::ranges::any_of(fit.problem.data, [g](const Datum& datum) {
                  return datum.group == static_cast<int>(g);
                });
  const auto n = static_cast<double>(fit.problem.data.size()), k = static_cast<double>(fit.of_model.size() + scatters);
  if (n - k - 1 <= 0) return std::nullopt;
  return fit.best().deviance + 2 * k + 2 * k * (k + 1) / (n - k - 1);
}

}  // namespace

ErrorSizes error_sizes(const CalibrationJob& job, const JobModel& model, const JobFit& fit, int body) {
  std::vector<MeasuredShot> shots = shots_of(job, fit.shots);
  std::erase_if(shots, [body](const MeasuredShot& shot) { return place_of_body(shot) != body; });
  if (shots.empty()) return {};
  const ModelAnswer answer = model.log_depths(fit.at, shots, Want::values_and_covariance);
  const VectorXd exponents = model.speed_exponents(fit.at, shots);
  ErrorSizes sizes;
  for (std::size_t k = 0; k < shots.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const MeasuredShot& shot = shots[k];
    const auto n = static_cast<double>(shots.size());
    sizes.emulator += std::sqrt(std::max(0.0, answer.covariance(i, i))) / n;
    sizes.data += std::hypot(known_log_error(shot, exponents[i]), fit.best().scatter[shot.group]) / n;
  }
  return sizes;
}

HypothesisResult read_out(const CalibrationJob& job, int hypothesis, const JobModel& model,
                          const JobModel& without_mesh, const JobFit& fit, const CalibrationLimits& limits,
                          int threads) {
  const SearchOptions search = quick_search(threads);
  const Hypothesis& read = job.hypotheses[hypothesis];
  HypothesisResult result;
  result.index = hypothesis;
  result.minima = fit.minima;
  for (int k : fit.of_model) result.parameters.push_back(model.of_job[k]);
  result.intervals = region_intervals(fit.problem, fit.minima, job.level, search);
  result.combinations = combinations(fit.problem, fit.best());
  result.aicc = aicc_of(fit);
  result.verdict = verdict_of(job, hypothesis, model, fit);
  result.shots = shot_depths(job, model, fit, all_shots(job));
  result.curves = curve_stresses(job, model, fit);
  result.sets = set_deviations(job, result.shots);
  result.moduli = material_moduli(job, read, model, fit, result.intervals);

  const std::vector<MeasuredShot> fitted = shots_of(job, fit.shots);
  const VectorXd mesh_shift = without_mesh.log_depths(fit.at, fitted, Want::values).value -
                              model.log_depths(fit.at, fitted, Want::values).value;
  result.mesh_error = mesh_shift.size() > 0 ? mesh_shift.mean() : 0;
  if (!job.shots.empty()) result.for_shots = for_shots(job, hypothesis, model, fit);
  std::vector<LogQuantity> quantities;
  for (std::size_t m = 0; m < job.materials.size(); ++m) {
    LogQuantity quantity = stiffness_quantity(job, read, model, fit, static_cast<int>(m));
    if (quantity.gradient.cwiseAbs().maxCoeff() > 0 && told_about(job, fit, m)) quantities.push_back(quantity);
  }
  for (const LogQuantity& quantity : quantities)
    result.budgets.push_back(error_budget(job, model, fit, quantity, mesh_shift));
  result.advice = advise(job, model, fit, quantities);
  result.findings = hypothesis_findings(job, fit, result);
  std::vector<std::string> left_out;
  const auto in_time = [&](const char* what) {
    const bool late = limits.spent(share_for_reading);
    if (late) left_out.push_back(what);
    return !late;
  };
  if (in_time("cross-validation")) add_predictions(job, hypothesis, model, fit, search, result);
  if (job.bootstrap > 0 && in_time("bootstrap"))
    result.bootstrap = bootstrap(fit.problem, fit.best(), BootstrapKind::parametric, job.bootstrap, job.level,
                                 job.training.seed, search);
  if (in_time("ridge")) result.ridges = ridges(job, model, fit, search);
  if (!left_out.empty()) result.findings.push_back("The budget left no time for: " + listed(left_out) + ".");
  return result;
}

}  // namespace percal
