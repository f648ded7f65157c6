// The data of a calibration as its result repeats them, so that the result can be read without the job's tables.
#include "percal/calibrate/json_parts.hpp"

namespace percal::calibration_json {
namespace {

Json parameters_of(const CalibrationJob& job) {
  const char* const kinds[] = {"modulus", "exponent", "erosion strain"};  // as ParameterKind
  Json all = Json::array();
  for (const auto& [kind, free] : job.parameters)
    all.push_back({{"name", free.name},
                   {"kind", kinds[static_cast<int>(kind)]},
                   {with_unit("low", free), free.low},
                   {with_unit("high", free), free.high},
                   {"logarithmic", free.logarithmic},
                   {with_unit("prior", free), number(free.prior)},
                   {"prior_error", free.prior ? number(free.prior_error) : Json(nullptr)}});
  return all;
}

Json shots_of(const CalibrationJob& job) {
  Json all = Json::array();
  for (const MeasuredShot& shot : job.shots)
    all.push_back({{"label", shot.label},
                   {"set", job.sets[shot.set].name},
                   {"material", job.materials[shot.material].name},
                   {"scatter", job.groups[shot.group].name},
                   {"radius_m", shot.radius},
                   {"density_kg_m3", shot.density},
                   {"speed_m_s", shot.speed},
                   {"speed_error_m_s", shot.speed_error},
                   {"layer_depth_m", shot.layer_depth},
                   {"layer_width_m", shot.layer_width},
                   {"measured_m", shot.at_least ? Json(nullptr) : Json(shot.depth)},
                   {"measured_at_least_m", shot.at_least ? Json(shot.depth) : Json(nullptr)},
                   {"depth_error_m", shot.depth_error},
                   {"used", shot.used}});
  return all;
}

// Every point of a curve: how it was deformed, how far, and what stress was measured.
Json points_of(const MeasuredCurve& curve) {
  Json deformation = Json::array(), amount = Json::array(), stress = Json::array();
  for (const StressPoint& point : curve.data.points) {
    deformation.push_back(word(point.strained.deformation));
    amount.push_back(number(point.strained.amount));
    stress.push_back(number(point.nominal_stress));
  }
  return {{"deformation", deformation}, {"stretch_or_shear", amount}, {"stress_Pa", stress}};
}

Json published_of(const CalibrationJob& job) {
  Json all = Json::array();
  for (const PublishedPairs& published : job.published) {
    Json pairs = Json::array();
    for (const PublishedPair& pair : published.pairs)
      pairs.push_back({{"erosion_strain", pair.erosion_strain}, {"mu_as_given_Pa", pair.mu}});
    all.push_back(
        {{"name", published.name}, {"parameter", job.parameters[published.modulus].free.name}, {"pairs", pairs}});
  }
  return all;
}

Json curves_of_job(const CalibrationJob& job) {
  Json all = Json::array();
  for (const MeasuredCurve& curve : job.curves)
    all.push_back({{"name", curve.name},
                   {"material", job.materials[curve.material].name},
                   {"scatter", job.groups[curve.group].name},
                   {"file", curve.data.sources.empty() ? Json(nullptr) : Json(curve.data.sources.front().file)},
                   {"points", curve.data.points.size()},
                   {"measured", points_of(curve)},
                   {"rate_factor", curve.rate_factor},
                   {"rate_factor_error", curve.rate_factor_error},
                   {"relative_error", curve.relative_error},
                   {"synthetic", curve.synthetic}});
  return all;
}

}  // namespace

Json job_to_json(const CalibrationJob& job) {
  return {{"parameters", parameters_of(job)},
          {"shots", shots_of(job)},
          {"curves", curves_of_job(job)},
          {"ridge_points", published_of(job)}};
}

}  // namespace percal::calibration_json
