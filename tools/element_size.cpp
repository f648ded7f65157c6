#include "element_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "percal/base/progress.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/text/one_value.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

struct NamedScene {
  std::string name;
  Scene scene;
};

// The scene's target is what the card says: calibrate and identify write the scenes of all their cards to one folder.
bool is_of(const Scene& scene, const CardMaterial& material) {
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(b); };
  const auto* erosion = std::get_if<StrainErosion>(&scene.target.erosion);
  return erosion && material.erosion && material.terms.size() == 1 &&
         same(scene.target.alpha, material.terms[0].alpha) &&
         same(true_modulus(scene.target.mu_as_given, scene.target.alpha, scene.target.convention),
              material.terms[0].mu) &&
         same(erosion->limit, material.erosion->limit) && erosion->measure == material.erosion->measure;
}

std::vector<NamedScene> scenes_beside(const std::string& result, const CardMaterial& material) {
  const auto folder = std::filesystem::path(result).parent_path() / "scenes";
  std::vector<NamedScene> found;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    if (entry.path().extension() == ".toml")
      if (Scene scene = read_scene(entry.path().string()); is_of(scene, material))
        found.push_back({entry.path().stem().string(), std::move(scene)});
  // shot_2 before shot_10
  std::ranges::sort(found, {}, [](const NamedScene& one) { return std::pair(one.name.size(), one.name); });
  if (found.empty())
    throw BadInput(Place{.file = result, .line = 0, .key = "--element-size"},
                   fmt::format("no shot of '{}' in {}", material.name, folder.string()),
                   "a result of calibrate or identify in the folder that it wrote, with its scenes");
  return found;
}

const NamedScene& chosen(const std::vector<NamedScene>& scenes, const CardArguments& card) {
  if (card.shot.empty()) return scenes.front();
  const auto named = std::ranges::find(scenes, card.shot, &NamedScene::name);
  if (named != scenes.end()) return *named;
  std::vector<std::string> names;
  for (const NamedScene& one : scenes) names.push_back(one.name);
  throw BadInput(Place{.file = card.result, .line = 0, .key = "--shot"}, in_quotes(card.shot), listed(names));
}

}  // namespace

std::optional<StrainAtSize> strain_for_elements(const CardArguments& card, const CardMaterial& material,
                                                const Common& common) {
  const double element = one_quantity(card.element_size, "--element-size", dimension::length, positive("length"));
  if (!material.erosion)
    throw BadInput(Place{.file = card.result, .line = 0, .key = "--element-size"}, "a card without an erosion strain",
                   "one with it");
  const auto scenes = scenes_beside(card.result, material);
  const NamedScene& shot = chosen(scenes, card);
  need_element_size(shot.scene, element, Place{.file = card.result, .line = 0, .key = "--element-size"});
  if (common.check) return std::nullopt;
  Store store(store_file(common));
  Campaign campaign(&store, common.threads);
  Progress progress(shot.name, strain_runs(shot.scene));
  return strain_at_size(shot.scene, element, campaign, &progress);
}

std::string in_words(const StrainAtSize& found) {
  const auto length = [](double metres) { return format_quantity(metres, dimension::length, 4); };
  return fmt::format(
      "erosion strain {:.4g} +- {:.2g} (95 %) for elements of {} ({:.4g} radii): with it a shot goes as deep ({}) as "
      "with {:.4g} on elements of {}",
      found.strain, found.half_width, length(found.element), found.element / found.radius, length(*found.own.depth),
      found.own_strain, length(found.own_element));
}

}  // namespace percal::tools
