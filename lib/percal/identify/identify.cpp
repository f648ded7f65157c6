// The chain: gelatin law -> ridge -> similar model system -> formulation -> tissue -> check and predictions -> card.
#include <fmt/core.h>

#include <cmath>

#include "percal/identify/identification.hpp"
#include "percal/identify/run_sizes.hpp"
#include "percal/scene/solver_words.hpp"

namespace percal {
namespace {

GelatinFinding find_law(const ModelMaterial& gelatin) {
  std::vector<double> concentration, modulus;
  for (const Formulation& f : gelatin.formulations)
    if (f.measured) {
      concentration.push_back(f.concentration);
      modulus.push_back(f.mu_quasi_static);
    }
  GelatinFinding finding;
  finding.law = gelatin.exponent ? fit_gelatin_law(concentration, modulus, *gelatin.exponent, Misfit::absolute)
                                 : fit_gelatin_law(concentration, modulus, Misfit::absolute);
  for (const Formulation& f : gelatin.formulations)
    finding.high_rate.push_back(f.measured && f.mu_high_rate
                                    ? *f.mu_high_rate
                                    : high_rate_modulus(finding.law.at(f.concentration), gelatin.rate_factor));
  return finding;
}

System system_of(const ParticleScene& sphere, const std::string& target) {
  System system;
  system.particle = sphere.name;
  system.target = target;
  system.radius = sphere.radius;
  system.particle_density = sphere.density;
  system.speed = sphere.speed;
  return system;
}

SimilarityFinding find_similar_system(const IdentifyJob& job) {
  SimilarityFinding finding;
  finding.prototype = system_of(job.calibration, job.tissue.name);
  finding.prototype.target_density = job.tissue.density;
  finding.prototype.depth = job.layer.depth * job.calibration.radius;
  finding.prototype.width = job.layer.width * job.calibration.radius;
  finding.prototype.penetration = job.penetration;
  finding.model = complete(finding.prototype, system_of(job.model, job.gelatin.name)).model;
  finding.modulus_ratio = modulus_ratio(finding.prototype, finding.model);
  finding.penetration = map_penetration(job.penetration, finding.prototype, finding.model);
  double nearest = INFINITY;
  for (std::size_t i = 0; i < job.gelatin.formulations.size(); ++i) {
    const double mismatch = job.gelatin.formulations[i].penetration / finding.penetration - 1;
    if (std::abs(mismatch) < nearest) {
      nearest = std::abs(mismatch);
      finding.formulation = static_cast<int>(i);
      finding.mismatch = mismatch;
    }
  }
  return finding;
}

TissueFinding find_tissue(const IdentifyJob& job, const Identification& so_far) {
  TissueFinding tissue;
  tissue.mu = so_far.gelatin.high_rate[so_far.similarity.formulation] / so_far.similarity.modulus_ratio;
  tissue.erosion = strain_at(so_far.ridge, tissue.mu);
  tissue.mu_quasi_static = quasi_static_modulus(tissue.mu, job.tissue.rate_factor);
  tissue.youngs_quasi_static = youngs_modulus_incompressible(tissue.mu_quasi_static);
  return tissue;
}

Shooting check_model_system(Campaign& campaign, const IdentifyJob& job, const Identification& found) {
  const TargetMaterial target{*found.similarity.model.target_density,
                              found.gelatin.high_rate[found.similarity.formulation], found.alpha,
                              found.tissue.erosion->strain};
  const Scene scene = impact_scene(job, job.model, target, job.volumetric, job.check_elements_per_radius);
  return shoot(campaign, {scene}, job.check_replicates, "model check").front();
}

// The calibration impact at the identified pair, on one mesh after the other: what the ridge's mesh is worth.
std::vector<Shooting> study_mesh(Campaign& campaign, const IdentifyJob& job, const Identification& found) {
  const TargetMaterial target{job.tissue.density, found.tissue.mu, found.alpha, found.tissue.erosion->strain};
  std::vector<Scene> scenes;
  for (const double elements : job.mesh_study)
    scenes.push_back(impact_scene(job, job.calibration, target, job.volumetric, elements));
  return shoot(campaign, scenes, job.check_replicates, "mesh study");
}

// The modulus and strain of a prediction set; nullopt where the chain did not get that far.
std::optional<TargetMaterial> material_of(const PredictionSet& set, const Identification& found) {
  TargetMaterial target{.density = set.target_density, .mu = 0, .alpha = found.alpha, .erosion_strain = 0};
  if (const auto* given = std::get_if<PairGiven>(&set.material)) {
    target.mu = given->mu;
    target.erosion_strain = given->erosion_strain;
    return target;
  }
  if (!found.tissue.erosion) return std::nullopt;
  target.erosion_strain = found.tissue.erosion->strain;
  target.mu = std::holds_alternative<IdentifiedTissue>(set.material)
                  ? found.tissue.mu
                  : found.gelatin.high_rate[found.similarity.formulation];
  return target;
}

std::optional<PredictionResult> predict(Campaign& campaign, const IdentifyJob& job, const PredictionSet& set,
                                        const Identification& found) {
  const auto target = material_of(set, found);
  if (!target) return std::nullopt;
  std::vector<Scene> scenes;
  for (const PredictedShot& shot : set.shots) {
    const ParticleScene sphere{.name = shot.particle,
                               .radius = shot.radius,
                               .density = shot.density,
                               .speed = shot.speed,
                               .youngs_modulus = {}};
    scenes.push_back(impact_scene(job, sphere, *target, set.volumetric, set.elements_per_radius));
  }
  PredictionResult result{.set = &set,
                          .shots = shoot_beside_atlas(campaign, scenes, set.replicates, set.system.c_str()),
                          .mean_deviation_from_measured = {},
                          .mean_deviation_from_reference = {}};
  const auto mean_deviation = [&](std::optional<double> PredictedShot::*other) -> std::optional<double> {
    std::vector<double> computed, published;
    for (std::size_t i = 0; i < set.shots.size(); ++i)
      if (set.shots[i].*other && result.shots[i].penetration.depth) {
        computed.push_back(*result.shots[i].penetration.depth);
        published.push_back(*(set.shots[i].*other));
      }
    return computed.empty() ? std::nullopt : std::optional(mean_relative_error(computed, published));
  };
  result.mean_deviation_from_measured = mean_deviation(&PredictedShot::measured);
  result.mean_deviation_from_reference = mean_deviation(&PredictedShot::reference);
  return result;
}

// The files that the card's numbers come from: the job, its formulations, the known pairs of the scan.
std::vector<CardData> data_of(const IdentifyJob& job) {
  std::vector<std::string> files = {job.file, job.gelatin.file};
  if (const auto* scan = std::get_if<AlphaScan>(&job.alpha)) files.push_back(scan->file);
  return card_data(files);
}

// The chain has an error of the erosion strain alone: one formulation stands for the modulus, and alpha's range is a comment.
std::optional<CardIntervals> intervals_of(const StrainOnRidge& erosion) {
  if (!(erosion.error > 0)) return std::nullopt;
  constexpr double level = 0.95, errors = 1.959964;
  return CardIntervals{
      level, {{"erosion_strain", erosion.strain - errors * erosion.error, erosion.strain + errors * erosion.error}}};
}

CardMaterial card_of(const IdentifyJob& job, const Identification& found, const std::vector<CardData>& data) {
  const double mu_true = true_modulus(found.tissue.mu, found.alpha, job.convention);
  CardMaterial card{.name = job.card_name,
                    .density = job.tissue.density,
                    .terms = {{mu_true, found.alpha}},
                    .bulk_modulus = reduce(identified_scene(job, found)).bulk_modulus,
                    .erosion = CardErosion{found.tissue.erosion->strain, job.measure, 1 / job.ridge.elements_per_radius,
                                           job.calibration.radius / job.ridge.elements_per_radius},
                    .comments = job.card_comments,
                    .intervals = intervals_of(*found.tissue.erosion),
                    .data = data};
  card.comments.push_back("identified by percal from " + job.title);
  card.comments.push_back("its runs had " + in_words(job.solver));
  if (found.alpha_scan) {
    card.fit_error =
        fmt::format("depths at the known pairs differ by {:.1f} % in the mean", 100 * found.alpha_scan->score);
    card.comments.push_back(fmt::format("alpha is fitted, and no better known than {:.2f} to {:.2f}",
                                        found.alpha_scan->lowest, found.alpha_scan->highest));
  }
  card.comments.push_back(fmt::format("no interval of mu: one formulation stands for it, {:+.1f} % off in depth",
                                      100 * found.similarity.mismatch));
  return card;
}

}  // namespace

Scene identified_scene(const IdentifyJob& job, const Identification& found) {
  Scene scene = impact_scene(job, job.calibration,
                             {job.tissue.density, found.tissue.mu, found.alpha, found.tissue.erosion->strain},
                             job.volumetric, job.ridge.elements_per_radius);
  scene.replicates = job.ridge.replicates;
  return scene;
}

Identification identify(const IdentifyJob& job, Campaign& campaign,
                        const std::function<void(const ComparedNumbers&)>& announce) {
  largest_run(job);                                 // throws where it cannot be run
  const std::vector<CardData> data = data_of(job);  // now: files may be changed while runs take their time
  Identification found;
  const auto finish = [&](ComparedNumbers table) {
    if (announce) announce(table);
    found.steps.push_back(std::move(table));
  };
  found.gelatin = find_law(job.gelatin);
  finish(law_step(job, found));

  if (const auto* scan = std::get_if<AlphaScan>(&job.alpha)) {
    found.alpha_scan = choose_alpha(run_alpha_trials(campaign, job, *scan), static_cast<int>(scan->target.size()));
    found.alpha = found.alpha_scan->alpha;
  } else {
    found.alpha = std::get<AlphaGiven>(job.alpha).alpha;
  }
  found.ridge = find_ridge(campaign, job, found.alpha);
  finish(ridge_step(job, found));

  found.similarity = find_similar_system(job);
  finish(similarity_step(job, found));
  finish(formulation_step(job, found));

  found.tissue = find_tissue(job, found);
  finish(tissue_step(job, found));

  if (found.complete()) {
    found.model_check = check_model_system(campaign, job, found);
    finish(check_step(job, found));
    if (!job.mesh_study.empty()) {
      found.mesh_study = study_mesh(campaign, job, found);
      finish(mesh_step(job, found));
    }
  }
  for (const PredictionSet& set : job.predictions)
    if (auto result = predict(campaign, job, set, found)) {
      found.predictions.push_back(std::move(*result));
      finish(prediction_step(job, found.predictions.back()));
    }
  if (found.complete()) found.card = card_of(job, found, data);
  found.tables = published_tables(job, found);
  found.findings = findings(job, found);
  return found;
}

}  // namespace percal
