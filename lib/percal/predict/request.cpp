#include "percal/predict/request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "percal/base/error.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

template <class Named>
std::string names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const auto& one : all) names.push_back(in_quotes(one.name));
  return listed(names);
}

template <class Named>
std::optional<int> index_named(const std::vector<Named>& all, const std::string& name) {
  const auto found = std::ranges::find(all, name, &Named::name);
  return found == all.end() ? std::nullopt : std::optional(static_cast<int>(found - all.begin()));
}

// Option of the number that is looked for: nobody says it.
void check_left_out(ShotNumber wanted, const PredictWords& words) {
  const auto refuse_beside = [&](const std::string& option, const std::string& given) {
    if (!given.empty())
      refuse_option(option, "this beside --depth, which looks for the " + std::string(word(wanted)),
                    std::string("no ") + option + ", or --solve-for another number");
  };
  if (wanted == ShotNumber::speed) refuse_beside("--speed", words.speed);
  if (wanted == ShotNumber::diameter) {
    refuse_beside("--diameter", words.sphere.diameter);
    refuse_beside("--radius", words.sphere.radius);
  }
  if (wanted == ShotNumber::density) refuse_beside("--particle-density", words.sphere.density);
  if (wanted != ShotNumber::speed && !words.sphere.mass.empty())
    refuse_option("--particle-mass", "this beside --solve-for " + std::string(word(wanted)), "--particle-density");
  if (!words.shots.empty()) refuse_option("--shots", "this beside --depth", "one of the two");
}

ShotNumber number_looked_for(const PredictWords& words) {
  for (const ShotNumber number : {ShotNumber::speed, ShotNumber::diameter, ShotNumber::density})
    if (words.solve_for == word(number)) return number;
  if (words.solve_for.empty()) return ShotNumber::speed;
  refuse_option("--solve-for", in_quotes(words.solve_for), "speed, diameter or density");
}

// Where the numbers of the shots come from: a column, an option, or what the fitted shots have in common.
class Sources {
 public:
  Sources(const PredictWords& words, const ShotModel& model, const PredictRequest& request)
      : words_(words),
        shots_(shots_of_body(model.shots, request.body ? request.body->place : 0)),
        request_(request),
        rows_(words.shots.empty() ? std::nullopt : std::optional(read_csv(words.shots))) {}

  std::size_t size() const { return rows_.size(); }
  std::vector<std::string> labels() const { return rows_.labels(); }
  std::vector<std::string> columns_passed_over() const { return rows_.columns_passed_over(); }

  std::vector<double> radii() const {
    if (const auto& body = request_.body) {
      if (rows_.radii(words_.sphere)) refuse_option("--diameter", "a size for " + body->name(), "the size that it has");
      return std::vector(size(), body->scene.particle.radius);
    }
    if (const auto said = rows_.radii(words_.sphere)) return *said;
    std::vector<double> sizes = in_common("diameter", ShotNumber::diameter, "a diameter or a radius",
                                          [](const FiredShot& shot) { return 2 * shot.radius; });
    for (double& size : sizes) size /= 2;
    return sizes;
  }

  std::vector<double> densities(const std::vector<double>& radii) const {
    if (request_.body && rows_.have("particle_mass", words_.sphere.mass))
      refuse_option("--particle-mass", "this for " + request_.body->name(), "--particle-density");
    if (const auto said = rows_.densities(words_.sphere, radii)) return *said;
    return in_common("particle_density", ShotNumber::density, "the sphere's density or its mass",
                     [](const FiredShot& shot) { return shot.density; });
  }

  std::vector<double> speeds() const {
    if (request_.speeds) return std::vector(size(), request_.speeds->high);
    if (rows_.have("speed", words_.speed)) return rows_.numbers("speed", words_.speed, dimension::speed);
    return in_common("speed", ShotNumber::speed, "a speed, or a range \"50..250 m/s\"",
                     [](const FiredShot& shot) { return shot.speed; });
  }

  // In common as a length, or in radii.
  std::vector<double> layer_depths(const std::vector<double>& radii) const {
    if (rows_.have("layer_depth", words_.layer_depth))
      return rows_.numbers("layer_depth", words_.layer_depth, dimension::length);
    if (const auto depth = common([](const FiredShot& shot) { return shot.layer_depth; }))
      return std::vector(size(), *depth);
    const auto in_radii = common([](const FiredShot& shot) { return shot.layer_depth / shot.radius; });
    if (!in_radii)
      refuse_option("--layer-depth", "nothing, and the fitted shots differ in it",
                    "the target's depth, such as \"200 mm\"");
    std::vector<double> depths = radii;
    for (double& depth : depths) depth *= *in_radii;
    return depths;
  }

 private:
  using NumberOfShot = std::function<double(const FiredShot&)>;

  std::optional<double> common(const NumberOfShot& number) const {
    return number_in_common(shots_, request_.material, number);
  }

  // Where the number itself is looked for, the search begins in the middle of all shots.
  std::vector<double> in_common(const std::string& name, ShotNumber number, const std::string& accepted,
                                const NumberOfShot& of_shot) const {
    if (request_.looked_for == number) {
      double sum = 0;
      for (const FiredShot& shot : shots_) sum += std::log(of_shot(shot));
      return std::vector(size(), std::exp(sum / static_cast<double>(shots_.size())));
    }
    const auto found = common(of_shot);
    if (!found) refuse_option(ShotRows::option_of(name), "nothing, and the fitted shots differ in it", accepted);
    return std::vector(size(), *found);
  }

  const PredictWords& words_;
  const std::vector<FiredShot> shots_;  // of the same body
  const PredictRequest& request_;
  ShotRows rows_;
};

void take_shots(const PredictWords& words, const ShotModel& model, PredictRequest& request) {
  const Sources sources(words, model, request);
  const auto radii = sources.radii();
  const auto densities = sources.densities(radii), speeds = sources.speeds(), layers = sources.layer_depths(radii);
  const auto labels = sources.labels();
  // Of all shots of a body.
  const FiredShot first = shots_of_body(model.shots, request.body ? request.body->place : 0).front();
  const double width = first.layer_width / first.radius;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    NamedShot shot;
    shot.radius = radii[i];
    shot.density = densities[i];
    shot.speed = speeds[i];
    shot.layer_depth = layers[i];
    shot.layer_width = width * shot.radius;
    shot.body = request.body;
    shot.label = labels[i].empty() ? words_of(shot) : labels[i];
    if (!(shot.layer_depth > shot.radius))
      refuse_option("--layer-depth", format_quantity(shot.layer_depth, dimension::length),
                    (shot.body ? "more than half the width, " : "more than the sphere's radius, ") +
                        format_quantity(shot.radius, dimension::length));
    request.shots.push_back(std::move(shot));
  }
  request.columns_passed_over = sources.columns_passed_over();
}

}  // namespace

int hypothesis_named(const std::string& name, const ShotModel& model, const Place& place) {
  if (name.empty()) return 0;
  if (const auto named = index_named(model.hypotheses, name)) return *named;
  for (std::size_t k = 0; k < model.hypotheses.size(); ++k)
    if (name == std::to_string(k + 1)) return static_cast<int>(k);
  throw BadInput(
      place, in_quotes(name),
      fmt::format("a number from 1 to {}, or one of {}", model.hypotheses.size(), names_of(model.hypotheses)));
}

int material_named(const std::string& name, const ShotModel& model, const Place& place) {
  const auto& materials = model.hypotheses.front().materials;
  if (const auto named = index_named(materials, name)) return *named;
  if (!name.empty()) throw BadInput(place, in_quotes(name), names_of(materials));
  std::vector<int> shot_into;
  for (const FiredShot& shot : model.shots)
    if (shot.fitted && std::ranges::find(shot_into, shot.material) == shot_into.end())
      shot_into.push_back(shot.material);
  if (materials.size() > 1 && shot_into.size() != 1) throw BadInput(place, "nothing", "one of " + names_of(materials));
  return materials.size() == 1 ? 0 : shot_into.front();
}

std::shared_ptr<const ShotBody> body_named(const std::string& name, const ShotModel& model, int material) {
  std::vector<std::string> names;
  if (!model.runs.empty()) names.emplace_back("sphere");
  for (const KeptBody& kept : model.bodies) names.push_back(kept.body->name());
  const auto refuse = [&](const std::string& found) { refuse_option("--body", found, listed(names)); };
  if (name.empty()) {
    std::set<int> places;
    for (const FiredShot& shot : model.shots)
      if (shot.material == material && shot.fitted) places.insert(place_of_body(shot));
    if (places.empty() && model.bodies.empty()) return nullptr;
    if (places.size() != 1) refuse("nothing, and the fitted shots differ in it");
    return *places.begin() == 0 ? nullptr : model.bodies[*places.begin() - 1].body;
  }
  const auto known = std::ranges::find(names, name);
  if (known == names.end()) refuse(in_quotes(name));
  const auto place = known - names.begin() - (model.runs.empty() ? 0 : 1);
  return place < 0 ? nullptr : model.bodies[static_cast<std::size_t>(place)].body;
}

std::vector<NamedText> named_texts(PredictWords& words) {
  std::vector<NamedText> texts{{"material", &words.material},
                               {"hypothesis", &words.hypothesis},
                               {"body", &words.body},
                               {"speed", &words.speed},
                               {"layer_depth", &words.layer_depth},
                               {"speed_error", &words.speed_error},
                               {"shots", &words.shots},
                               {"depth", &words.depth},
                               {"solve_for", &words.solve_for}};
  for (const NamedText& text : named_texts(words.sphere)) texts.push_back(text);
  return texts;
}

PredictRequest understood(const PredictWords& words, const ShotModel& model) {
  PredictRequest request{.words = words,
                         .hypothesis = hypothesis_named(words.hypothesis, model, {"", 0, "--hypothesis"}),
                         .material = material_named(words.material, model, {"", 0, "--material"}),
                         .level = words.level.value_or(model.level),
                         .shots = {},
                         .speeds = {},
                         .looked_for = {}};
  request.body = body_named(words.body, model, request.material);
  if (!words.speed_error.empty())
    request.speed_error = one_share(words.speed_error, "--speed-error",
                                    {.low = 0, .high = 0.5, .words = "a share of the speed from 0 to 50 %"});
  if (words.v50) {
    if (!words.depth.empty()) refuse_option("--v50", "this beside --depth", "one of the two");
    if (!model.passage)
      refuse_option("--v50", "a calibration that has not learnt what passes a layer",
                    "one with shots that passed or stopped, a speed left, or [training] passage = true");
  }
  if (!words.depth.empty() || words.v50) {
    request.looked_for = number_looked_for(words);
    check_left_out(*request.looked_for, words);
    if (request.body && *request.looked_for == ShotNumber::diameter)
      refuse_option("--solve-for", "diameter of " + request.body->name(), "speed or density");
    if (!words.v50) request.depth = one_quantity(words.depth, "--depth", dimension::length, positive("length"));
  } else if (!words.solve_for.empty()) {
    refuse_option("--solve-for", in_quotes(words.solve_for) + " without --depth or --v50", "one of them beside it");
  }
  if (words.speed.find("..") != std::string::npos) {
    if (!words.shots.empty()) refuse_option("--speed", "a range beside --shots", "one speed for all, or a column");
    if (request.looked_for) refuse_option("--speed", "a range beside --depth or --v50", "one speed");
    request.speeds = quantity_range(words.speed, "--speed", dimension::speed, positive("speed"));
  }
  take_shots(words, model, request);
  if (words.v50) request.depth = request.shots.front().layer_depth;
  return request;
}

}  // namespace percal
