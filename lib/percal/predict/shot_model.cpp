#include "percal/predict/shot_model.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "percal/base/error.hpp"
#include "percal/predict/emulator_json.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

using page::at;
using page::Json;
using page::list;

constexpr std::size_t numbers_of_point = 7;  // the fourth, a length, may be null; two more a term of relaxation

Json point_to_json(const LayerMaterial& point) {
  Json numbers = Json::array({point.mu_true, point.alpha, point.erosion_strain, page::finite(point.erosion_length),
                              point.laws.rate_exponent, point.laws.size_exponent, point.laws.erosion_strain_below});
  for (const PronyTerm& term : point.laws.relaxation.terms) numbers.insert(numbers.end(), {term.share, term.time});
  return numbers;
}

// What stands behind the other numbers of a point.
PronySeries relaxation_of(const Json& numbers) {
  PronySeries series;
  if ((numbers.size() - numbers_of_point) % 2 != 0 || numbers.size() > numbers_of_point + 2 * most_relaxation_terms)
    throw page::MissingKey("points");
  for (std::size_t k = numbers_of_point; k < numbers.size(); k += 2) {
    const auto share = page::number(numbers[k]), time = page::number(numbers[k + 1]);
    if (!share || !time || !(*share >= 0 && *time > 0)) throw page::MissingKey("points");
    series.terms.push_back({*share, *time});
  }
  if (!series.terms.empty() && !(lasting_share(series) > 0)) throw page::MissingKey("points");
  return series;
}

LayerMaterial point_of(const Json& json, LayerMaterial point) {
  if (!json.is_array() || json.size() < numbers_of_point) throw page::MissingKey("points");
  const Json without_length = {json[0], json[1], json[2], json[4], json[5], json[6]};
  const auto row = row_of(without_length, numbers_of_point - 1, "points");
  point.mu_true = row[0];
  point.alpha = row[1];
  point.erosion_strain = row[2];
  point.erosion_length = page::number(json[3]);
  point.laws.rate_exponent = row[3];
  point.laws.size_exponent = row[4];
  point.laws.erosion_strain_below = row[5];
  point.laws.relaxation = relaxation_of(json);
  if (!(point.mu_true > 0 && point.erosion_strain > 0 && point.erosion_length.value_or(1) > 0))
    throw page::MissingKey("points");
  return point;
}

// What all points of a layer have in common.
Json layer_to_json(const LayerMaterial& layer) {
  return {{"density_kg_m3", layer.density},
          {"reference_rate_1_s", layer.laws.reference_rate},
          {"reference_radius_m", layer.laws.reference_radius},
          {"cell_m", layer.laws.cell}};
}

LayerMaterial layer_of(const Json& json) {
  LayerMaterial layer{.density = wanted(json, "density_kg_m3"),
                      .laws = {.reference_rate = wanted(json, "reference_rate_1_s"),
                               .reference_radius = wanted(json, "reference_radius_m"),
                               .cell = wanted(json, "cell_m")}};
  if (!(layer.laws.reference_rate > 0 && layer.laws.reference_radius > 0)) throw page::MissingKey("reference_rate_1_s");
  if (!(layer.density > 0)) throw page::MissingKey("density_kg_m3");
  return layer;
}

Json cover_to_json(const MaterialSample& material, std::size_t k) {
  Json points = Json::array();
  for (const CoveredMaterial& point : material.points) points.push_back(point_to_json(point.covers[k].material));
  Json json = layer_to_json(material.points.front().covers[k].material);
  json["thickness_m"] = material.points.front().covers[k].thickness;
  json["points"] = std::move(points);
  return json;
}

// Adds the cover to each of the material's points.
void take_cover(const Json& json, MaterialSample& material) {
  const LayerMaterial common = layer_of(json);
  const double thickness = wanted(json, "thickness_m");
  if (!(thickness > 0)) throw page::MissingKey("thickness_m");
  const Json& points = list(json, "points");
  if (points.size() != material.points.size()) throw page::MissingKey("points");
  for (std::size_t i = 0; i < points.size(); ++i)
    material.points[i].covers.push_back({point_of(points[i], common), thickness});
}

Json material_to_json(const MaterialSample& material) {
  Json points = Json::array(), covers = Json::array();
  for (const LayerMaterial& point : material.points) points.push_back(point_to_json(point));
  for (std::size_t k = 0; k < material.points.front().covers.size(); ++k) covers.push_back(cover_to_json(material, k));
  Json json = layer_to_json(material.points.front());
  json.update({{"name", material.name},
               {"scatter", page::finite(material.scatter)},
               {"freedom", page::finite(material.freedom)},
               {"points", points}});
  if (!covers.empty()) json["covers"] = covers;
  for (const auto& [number, beside] : material.beside)
    json["beside"][kind_of(number).key] = {{"scatter", page::finite(beside.scatter)},
                                           {"freedom", page::finite(beside.freedom)}};
  return json;
}

MaterialSample material_of(const Json& json) {
  MaterialSample material{.name = page::text(json, "name"),
                          .points = {},
                          .scatter = wanted(json, "scatter"),
                          .freedom = wanted(json, "freedom")};
  const LayerMaterial common = layer_of(json);
  for (const Json& point : list(json, "points")) material.points.emplace_back(point_of(point, common));
  if (material.points.empty() || !(material.scatter >= 0 && material.freedom >= 0)) throw page::MissingKey("points");
  if (!page::maybe(json, "covers").is_null())
    for (const Json& cover : list(json, "covers")) take_cover(cover, material);
  if (material.points.front().covers.size() > most_covers) throw page::MissingKey("covers");
  for (const RunNumber number : numbers_beside) {
    const Json& beside = page::maybe(page::maybe(json, "beside"), kind_of(number).key);
    if (beside.is_null()) continue;
    const SampleScatter scatter{wanted(beside, "scatter"), wanted(beside, "freedom")};
    if (!(scatter.scatter >= 0 && scatter.freedom >= 0)) throw page::MissingKey("beside");
    material.beside[number] = scatter;
  }
  return material;
}

Json hypothesis_to_json(const ShotHypothesis& hypothesis) {
  Json materials = Json::array();
  for (const MaterialSample& material : hypothesis.materials) materials.push_back(material_to_json(material));
  return {{"name", hypothesis.name},
          {"contradicted", hypothesis.contradicted},
          {"mesh_error", page::finite(hypothesis.mesh_error)},
          {"materials", materials}};
}

ShotHypothesis hypothesis_of(const Json& json) {
  ShotHypothesis hypothesis{.name = page::text(json, "name"),
                            .contradicted = page::yes(json, "contradicted"),
                            .mesh_error = page::number_or(json, "mesh_error", 0),
                            .materials = {}};
  for (const Json& material : list(json, "materials")) hypothesis.materials.push_back(material_of(material));
  if (hypothesis.materials.empty()) throw page::MissingKey("materials");
  return hypothesis;
}

Json shot_to_json(const FiredShot& shot) {
  Json json{{"label", shot.label},
            {"material", shot.material},
            {"radius_m", shot.radius},
            {"density_kg_m3", shot.density},
            {"speed_m_s", shot.speed},
            {"layer_depth_m", shot.layer_depth},
            {"layer_width_m", shot.layer_width},
            {"depth_m", page::finite(shot.depth)},
            {"seen", shot.seen},
            {"fitted", shot.fitted}};
  if (shot.body) json["body"] = shot.body->place;
  return json;
}

FiredShot shot_of(const Json& json, std::size_t materials, const std::vector<KeptBody>& bodies) {
  FiredShot shot;
  shot.label = page::text(json, "label");
  shot.material = whole(json, "material");
  shot.radius = wanted(json, "radius_m");
  shot.density = wanted(json, "density_kg_m3");
  shot.speed = wanted(json, "speed_m_s");
  shot.layer_depth = wanted(json, "layer_depth_m");
  shot.layer_width = wanted(json, "layer_width_m");
  shot.depth = page::number(json, "depth_m");
  shot.seen = page::text(json, "seen");
  shot.fitted = page::yes(json, "fitted");
  for (const double positive :
       {shot.radius, shot.density, shot.speed, shot.layer_depth, shot.layer_width, shot.depth.value_or(1)})
    if (!(positive > 0)) throw page::MissingKey("shots");
  if (static_cast<std::size_t>(shot.material) >= materials) throw page::MissingKey("material");
  if (!page::maybe(json, "body").is_null()) {
    const int place = whole(json, "body");
    if (place < 1 || static_cast<std::size_t>(place) > bodies.size()) throw page::MissingKey("body");
    shot.body = bodies[place - 1].body;
  }
  return shot;
}

// The most covers of anything that can be shot into.
std::size_t covers_of(const ShotModel& model) {
  std::size_t most = 0;
  if (model.hypotheses.empty()) return most;
  for (const MaterialSample& material : model.hypotheses.front().materials)
    most = std::max(most, material.points.front().covers.size());
  return most;
}

// A key of results that know no such number is missing there.
void take_beside(const Json& json, ShotModel& model) {
  for (const RunNumber number : numbers_beside) {
    const Json& learnt = page::maybe(page::maybe(json, "beside"), kind_of(number).key);
    if (learnt.is_null()) continue;
    LearntNumber& known =
        model.beside[number] = {runs_of(learnt, covers_of(model)), settings_of(at(learnt, "settings"))};
    require_lengths(known.settings, known.runs);
    for (const ShotHypothesis& hypothesis : model.hypotheses)
      for (const MaterialSample& material : hypothesis.materials)
        if (!material.beside.contains(number)) throw page::MissingKey("beside");
  }
}

// The part of a scene that is of its particle.
std::shared_ptr<const ShotBody> body_of(const std::string& scene, int place) {
  auto body = std::make_shared<ShotBody>();
  body->place = place;
  body->scene = parse_scene(scene, "scene of the calibration's runs");
  return body;
}

void take_bodies(const Json& json, ShotModel& model) {
  if (page::maybe(json, "bodies").is_null()) return;
  for (const Json& kept : list(json, "bodies")) {
    const std::string scene = page::text(kept, "scene_of_runs");
    const LearntNumber depth{runs_of(kept, covers_of(model)), settings_of(at(kept, "settings"))};
    require_lengths(depth.settings, depth.runs);
    model.bodies.push_back({body_of(scene, static_cast<int>(model.bodies.size()) + 1), depth, scene});
  }
}

Json bodies_to_json(const ShotModel& model) {
  Json bodies = Json::array();
  for (const KeptBody& kept : model.bodies)
    bodies.push_back({{"name", kept.body->name()},
                      {"scene_of_runs", kept.scene},
                      {"runs", runs_to_json(kept.depth.runs, covers_of(model))},
                      {"settings", settings_to_json(kept.depth.settings)}});
  return bodies;
}

}  // namespace

std::optional<Between> numbers_of_shots(const std::vector<FiredShot>& shots, int material, Shots which,
                                        const std::function<double(const FiredShot&)>& number) {
  std::optional<Between> range;
  for (const FiredShot& shot : shots) {
    if (shot.material != material || (which == Shots::fitted && !shot.fitted)) continue;
    const double value = number(shot);
    range = range ? Between{std::min(range->low, value), std::max(range->high, value)} : Between{value, value};
  }
  return range;
}

std::optional<double> number_in_common(const std::vector<FiredShot>& shots, int material,
                                       const std::function<double(const FiredShot&)>& number) {
  for (const Shots which : {Shots::fitted, Shots::all})
    if (const auto range = numbers_of_shots(shots, material, which, number))
      return is_one(*range) ? std::optional(range->low) : std::nullopt;
  return std::nullopt;
}

Emulators emulators_of(const ShotModel& model) {
  Emulators emulators;
  if (!model.runs.empty()) emulators.of.emplace(EmulatorOf{}, Emulator(model.runs, model.settings));
  for (const auto& [number, learnt] : model.beside)
    emulators.of.emplace(EmulatorOf{0, number}, Emulator(learnt.runs, learnt.settings));
  for (const auto& [body, depth, scene] : model.bodies)
    emulators.of.emplace(EmulatorOf{body->place}, Emulator(depth.runs, depth.settings));
  return emulators;
}

std::vector<FiredShot> shots_of_body(const std::vector<FiredShot>& shots, int body) {
  std::vector<FiredShot> own;
  std::ranges::copy_if(shots, std::back_inserter(own),
                       [body](const FiredShot& shot) { return place_of_body(shot) == body; });
  return own;
}

ShotModel of_spheres(ShotModel model, const std::string& file) {
  if (model.runs.empty())
    throw BadInput({file, 0, "shot_model"}, "a calibration that knows no spheres, only other bodies",
                   "one with shots of spheres");
  model.shots = shots_of_body(model.shots, 0);
  model.bodies.clear();
  return model;
}

Json shot_model_to_json(const ShotModel& model) {
  Json shots = Json::array(), hypotheses = Json::array();
  const Json runs = runs_to_json(model.runs, covers_of(model));
  for (const FiredShot& shot : model.shots) shots.push_back(shot_to_json(shot));
  for (const ShotHypothesis& hypothesis : model.hypotheses) hypotheses.push_back(hypothesis_to_json(hypothesis));
  Json json{{"level", model.level},
            {"elements", model.elements},
            {"passage", model.passage},
            {"replicates", model.replicates},
            {"scene_of_runs", model.scene},
            {"shots", shots},
            {"runs", runs},
            {"settings", model.runs.empty() && !model.bodies.empty() ? Json() : settings_to_json(model.settings)},
            {"hypotheses", hypotheses}};
  if (!model.bodies.empty()) json["bodies"] = bodies_to_json(model);
  for (const auto& [number, learnt] : model.beside)
    json["beside"][kind_of(number).key] = {{"runs", runs_to_json(learnt.runs, covers_of(model))},
                                           {"settings", settings_to_json(learnt.settings)}};
  return json;
}

ShotModel shot_model_of(const Json& result, const std::string& file) {
  const std::string accepted = "the result.json of a percal calibrate with shots and a hypothesis that was fitted";
  if (!result.is_object() || page::maybe(result, "command") != "calibrate")
    throw BadInput({file, 0, "command"}, "no result of a calibration", accepted);
  const Json& json = at(result, "shot_model");
  if (json.is_null()) throw BadInput({file, 0, "shot_model"}, "a calibration that knows of no shots", accepted);
  ShotModel model{.level = wanted(json, "level"),
                  .elements = wanted(json, "elements"),
                  .passage = page::yes(json, "passage"),
                  .replicates = whole(json, "replicates"),
                  .scene = page::text(json, "scene_of_runs"),
                  .shots = {},
                  .runs = {},
                  .settings = {},
                  .hypotheses = {}};
  if (!(model.level > 0 && model.level < 1)) throw page::MissingKey("level");
  if (!(model.elements > 0)) throw page::MissingKey("elements");
  for (const Json& hypothesis : list(json, "hypotheses")) model.hypotheses.push_back(hypothesis_of(hypothesis));
  if (model.hypotheses.empty()) throw page::MissingKey("hypotheses");
  for (const ShotHypothesis& hypothesis : model.hypotheses)
    if (hypothesis.materials.size() != model.hypotheses.front().materials.size()) throw page::MissingKey("materials");
  model.runs = runs_of(json, covers_of(model));
  take_bodies(json, model);
  if (!model.runs.empty() || model.bodies.empty()) model.settings = settings_of(at(json, "settings"));
  require_lengths(model.settings, model.runs);
  take_beside(json, model);
  for (const Json& shot : list(json, "shots"))
    model.shots.push_back(shot_of(shot, model.hypotheses.front().materials.size(), model.bodies));
  if (model.shots.empty()) throw page::MissingKey("shots");
  return model;
}

ShotModel kept_shot_model(const Json& result, const std::string& file) {
  const std::string accepted = "a value as percal calibrate wrote it";
  try {
    return shot_model_of(result, file);
  } catch (const page::MissingKey& missing) {
    throw BadInput({file, 0, missing.key}, "no value that can be used", accepted);
  } catch (const Json::exception& error) {
    throw BadInput({file, 0, "shot_model"}, error.what(), accepted);
  }
}

}  // namespace percal
