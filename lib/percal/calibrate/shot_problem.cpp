#include "percal/calibrate/shot_problem.hpp"

#include <utility>

namespace percal {
namespace {

double number_at(const MaterialNumber& number, const std::vector<double>& natural) {
  if (const auto* shared = std::get_if<SharedParameter>(&number)) return natural[shared->index];
  return std::get<double>(number);
}

}  // namespace

std::vector<double> natural_values(const CalibrationJob& job, const Hypothesis& hypothesis,
                                   const std::vector<int>& fitted, const Eigen::VectorXd& searched) {
  std::vector<double> natural(job.parameters.size(), 0.0);
  for (const auto& [parameter, value] : hypothesis.held) natural[parameter] = value;
  for (std::size_t k = 0; k < fitted.size(); ++k)
    natural[fitted[k]] = job.parameters[fitted[k]].free.natural(searched[static_cast<Eigen::Index>(k)]);
  return natural;
}

MaterialAt material_at(const CalibrationJob& job, const Hypothesis& hypothesis, int material,
                       const std::vector<double>& natural) {
  const CalibrationMaterial& m = job.materials[material];
  MaterialAt at;
  at.density = m.density;
  at.mu_as_given = number_at(m.mu, natural);
  at.alpha = number_at(m.alpha, natural);
  at.erosion_strain = number_at(m.erosion_strain, natural);
  if (m.erosion_length) at.erosion_length = number_at(*m.erosion_length, natural);
  at.laws = {.rate_exponent = number_at(m.rate_exponent, natural),
             .reference_rate = m.reference_rate,
             .size_exponent = number_at(m.size_exponent, natural),
             .reference_radius = m.reference_radius,
             .cell = m.cell,
             .erosion_strain_below = number_at(m.erosion_strain_below, natural)};
  for (const auto& [share, time] : m.relaxation)
    at.laws.relaxation.terms.push_back({number_at(share, natural), number_at(time, natural)});
  at.mu_true = true_modulus(at.mu_as_given, at.alpha, hypothesis.convention);
  return at;
}

CoveredMaterial target_at(const CalibrationJob& job, const Hypothesis& hypothesis, const CalibrationTarget& target,
                          const std::vector<double>& natural) {
  CoveredMaterial at{material_at(job, hypothesis, target.material, natural)};
  for (const TargetCover& cover : target.covers)
    at.covers.push_back({material_at(job, hypothesis, cover.material, natural), cover.thickness});
  return at;
}

Scene shot_scene(const CalibrationJob& job, const MeasuredShot& shot, const CoveredMaterial& material,
                 double elements_per_radius) {
  Scene scene;
  scene.source = job.file;
  scene.mesh.elements_per_radius = elements_per_radius;
  scene.solver = job.solver;
  if (learns_passage(job)) scene.output.after = RunUntil::passage;
  kind_of(shot.number).ask(scene.output);
  if (!shot.body)
    for (const RunNumber number : job.training.learn) kind_of(number).ask(scene.output);
  return scene_of_shot(std::move(scene), shot, material);
}

Problem shot_problem(const CalibrationJob& job, const MeasuredShot& shot, const CoveredMaterial& material,
                     double elements_per_radius) {
  return reduce(shot_scene(job, shot, material, elements_per_radius)).problem;
}

}  // namespace percal
