#include "percal/calibrate/json_parts.hpp"

namespace percal::calibration_json {

Json numbers(const std::vector<double>& values) {
  Json all = Json::array();
  for (const double value : values) all.push_back(number(value));
  return all;
}

Json interval_to_json(const Interval& interval) {
  return {{"low", number(interval.low)},
          {"high", number(interval.high)},
          {"low_open", interval.low_open},
          {"high_open", interval.high_open}};
}

Json estimate_to_json(const Estimate& estimate, const std::string& unit) {
  const std::string suffix = unit.empty() ? "" : "_" + unit;
  return {{"value" + suffix, number(estimate.value)}, {"interval" + suffix, interval_to_json(estimate.interval)}};
}

Json deviation_to_json(const Deviation& deviation) {
  const bool any = deviation.shots > 0;
  return {{"name", deviation.name},
          {"shots", deviation.shots},
          {"mean_deviation", any ? number(deviation.mean_absolute) : Json(nullptr)},
          {"mean_signed_deviation", any ? number(deviation.mean_signed) : Json(nullptr)},
          {"within_interval", deviation.within}};
}

Json shot_depths_to_json(const CalibrationJob& job, const std::vector<ShotDepth>& depths) {
  Json all = Json::array();
  for (const ShotDepth& depth : depths) {
    const MeasuredShot& shot = job.shots[depth.shot];
    all.push_back({{"shot", depth.shot},
                   {"label", shot.label},
                   {"measured_m", shot.at_least ? Json(nullptr) : number(shot.depth)},
                   {"measured_at_least_m", shot.at_least ? number(shot.depth) : Json(nullptr)},
                   {"depth_m", number(depth.depth)},
                   {"low_m", number(depth.low)},
                   {"high_m", number(depth.high)},
                   {"model_error", number(depth.model_error)},
                   {"fitted", depth.fitted},
                   {"deviation", number(depth.deviation)}});
  }
  return all;
}

Json cross_validations_to_json(const CalibrationJob& job, const std::vector<CrossValidationResult>& all) {
  Json list = Json::array();
  for (const CrossValidationResult& one : all)
    list.push_back({{"name", one.name},
                    {"shots_fitted", one.fitted},
                    {"fit", deviation_to_json(one.fit)},
                    {"prediction", deviation_to_json(one.prediction)},
                    {"goal", number(one.goal)},
                    {"shots", shot_depths_to_json(job, one.shots)}});
  return list;
}

namespace {

Json profile_to_json(const FreeParameter& parameter, const ProfileInterval& interval) {
  std::vector<double> values, rises;
  for (const ProfilePoint& point : interval.profile) {
    values.push_back(parameter.natural(point.searched));
    rises.push_back(point.rise);
  }
  return {{with_unit("value", parameter), numbers(values)}, {"rise", numbers(rises)}};
}

}  // namespace

Json parameters_to_json(const std::vector<FreeParameter>& parameters, const Minimum& best,
                        const std::vector<ProfileInterval>& intervals, const std::optional<Bootstrap>& bootstrap) {
  Json all = Json::array();
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const FreeParameter& parameter = parameters[k];
    const auto i = static_cast<Eigen::Index>(k);
    Json entry{{"name", parameter.name},
               {with_unit("value", parameter), number(parameter.natural(best.searched[i]))},
               {"at_bound", static_cast<bool>(best.at_bound[k])},
               {"standard_error_searched", number(std::sqrt(best.covariance(i, i)))},
               {with_unit("interval", parameter), nullptr},
               {"identifiable", nullptr},
               {"profile", nullptr},
               {with_unit("bootstrap_interval", parameter), nullptr}};
    for (const ProfileInterval& interval : intervals) {
      if (interval.parameter != static_cast<int>(k)) continue;
      entry[with_unit("interval", parameter)] = interval_to_json(interval.interval);
      entry["identifiable"] = interval.identifiable;
      entry["profile"] = profile_to_json(parameter, interval);
    }
    if (bootstrap && k < bootstrap->intervals.size())
      entry[with_unit("bootstrap_interval", parameter)] = interval_to_json(bootstrap->intervals[k]);
    all.push_back(entry);
  }
  return all;
}

Json minimum_to_json(const CalibrationJob& job, const std::vector<FreeParameter>& parameters, const Minimum& minimum) {
  Json values = Json::array(), scatter = Json::array();
  for (std::size_t k = 0; k < parameters.size(); ++k)
    values.push_back({{"name", parameters[k].name},
                      {with_unit("value", parameters[k]),
                       number(parameters[k].natural(minimum.searched[static_cast<Eigen::Index>(k)]))},
                      {"at_bound", static_cast<bool>(minimum.at_bound[k])}});
  for (std::size_t g = 0; g < minimum.scatter.size() && g < job.groups.size(); ++g)
    scatter.push_back({{"group", job.groups[g].name}, {"standard_deviation", number(minimum.scatter[g])}});
  return {{"parameters", values},
          {"objective", number(minimum.objective)},
          {"deviance", number(minimum.deviance)},
          {"degrees_of_freedom", minimum.degrees_of_freedom},
          {"scatter", scatter},
          {"converged", minimum.converged},
          {"evaluations", minimum.evaluations}};
}

}  // namespace percal::calibration_json
