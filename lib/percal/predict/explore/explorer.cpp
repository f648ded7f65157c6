#include "percal/predict/explore/explorer.hpp"

#include <fmt/format.h>

#include <regex>

#include "percal/base/error.hpp"
#include "percal/base/version.hpp"
#include "percal/invert/emulator_search.hpp"
#include "percal/math/gaussian_process.hpp"
#include "percal/page/style.hpp"
#include "percal/problem/problem.hpp"
#include "percal/text/markup.hpp"
#include "percal/text/sha256.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

using page::Json;

Json to_json(const Eigen::VectorXd& numbers) { return std::vector<double>(numbers.begin(), numbers.end()); }

// In scaled inputs, so that the page needs neither runs nor settings.                     docs/theory/emulator.md (4) to (6)
Json emulator_to_json(const ShotModel& model) {
  const TrainingData data(model.runs);
  const CovarianceParameters parameters = covariance_parameters(model.settings, data.scale);
  const DepthCovariance covariance(parameters, data.plane_deviation);
  const auto process = GaussianProcess::conditioned(covariance.of_runs(data.points), data.values);
  if (!process)
    throw BadInput({}, "settings of the emulator with which its covariance is not positive definite",
                   "a shot_model as percal calibrate wrote it");
  Json runs = Json::array(), noise = Json::array();
  for (std::size_t i = 0; i < model.runs.size(); ++i) {
    runs.push_back(to_json(data.points.inputs.row(static_cast<Eigen::Index>(i))));
    noise.push_back(covariance.noise(model.runs[i].h / reference_h));
  }
  const double at_rest = subsonic_bulk_ratio(0), h = 1 / model.elements / reference_h;
  return {{"seen", data.scale.seen},
          {"centre", to_json(data.scale.centre)},
          {"half_range", to_json(data.scale.half_range)},
          {"amplitude", parameters.amplitude},
          {"length", to_json(parameters.length)},
          {"mesh_amplitude", parameters.mesh_amplitude},
          {"mesh_length", to_json(parameters.mesh_length)},
          {"plane_variance", data.plane_deviation * data.plane_deviation},
          {"mean", data.mean},
          {"mesh_here", covariance.mesh_factors(Eigen::VectorXd::Constant(1, h))[0]},
          {"runs", runs},
          {"mesh", to_json(covariance.mesh_factors(data.points.h))},
          {"noise", noise},
          {"weights", to_json(process->weights())},
          {"bulk", {{"least", least_bulk_ratio}, {"at_rest", at_rest}, {"by_pi4", subsonic_bulk_ratio(1) - at_rest}}}};
}

// The material that shots were fitted into, the first of them.
int material_to_begin_with(const ShotModel& model) {
  for (const FiredShot& shot : model.shots)
    if (shot.fitted) return shot.material;
  return 0;
}

// Nothing in it ends a script or begins a comment.
std::string as_script(const Json& data) {
  return std::regex_replace(data.dump(-1, ' ', false, Json::error_handler_t::replace), std::regex("<"), "\\u003c");
}

std::string summary_of(const ShotModel& model) {
  std::vector<std::string> materials;
  for (const MaterialSample& material : model.hypotheses.front().materials) materials.push_back(material.name);
  return fmt::format(
      "{}: by {} shots and an emulator of {} runs. Move a slider: the depths are those of percal predict.",
      listed(materials), model.shots.size(), model.runs.size());
}

}  // namespace

Json explorer_data(const ShotModel& model) {
  Json data = shot_model_to_json(model);
  for (const char* without : {"runs", "settings", "scene_of_runs", "replicates", "elements"}) data.erase(without);
  data["emulator"] = emulator_to_json(model);
  data["material"] = material_to_begin_with(model);
  return data;
}

std::string explorer_page(const ShotModel& model, const std::string& result) {
  const auto& files = embedded_explorer();
  Json data = explorer_data(model);
  data["result"] = result;
  const std::string script =
      files.at("model.js") + files.at("charts.js") + files.at("controls.js") + files.at("page.js");
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "script-src 'sha256-{}'; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<meta name=\"generator\" content=\"percal {}\">\n"
      "<title>{}</title>\n<style>{}{}</style>\n</head>\n<body>\n<header>\n<h1>{}</h1>\n<p class=\"summary\">{}</p>\n"
      "</header>\n{}<footer>Written by percal {} report --explore.</footer>\n"
      "<script type=\"application/json\" id=\"data\">{}</script>\n<script>{}</script>\n</body>\n</html>\n",
      sha256_in_base64(script), escaped(version()), escaped("Play with " + result), page::style_sheet,
      files.at("page.css"), escaped("Play with " + result), escaped(summary_of(model)), files.at("page.html"),
      escaped(version()), as_script(data), script);
}

}  // namespace percal
