#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "percal/scene/profile.hpp"
#include "percal/scene/read_scene.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double smallest_alpha = 1e-3;  // the solver divides by alpha
constexpr std::size_t most_relaxation_terms = 3;

// What of the target's [target.erosion] a scene may say, in the order of the alternatives of Erosion behind NoErosion.
const std::vector<std::string> erosion_keys{"strain", "stress", "energy"};

double erosion_limit(const TomlTable& table, const std::string& key) {
  if (key == "strain") return table.number(key, positive("strain"));
  return table.quantity(key, dimension::pressure, positive(key == "stress" ? "stress" : "energy per volume"));
}

// The one key of erosion_keys that the table has.
std::string erosion_key(const TomlTable& table) {
  std::string found;
  for (const std::string& key : erosion_keys) {
    if (!table.has(key)) continue;
    if (!found.empty()) table.refuse(key, "this beside " + found, "one of strain, stress and energy");
    found = key;
  }
  for (const std::string& key : erosion_keys)
    if (!table.has(key)) table.knows(key);
  if (found.empty()) table.refuse("strain", "no such key", "one of strain, stress and energy: a positive limit");
  return found;
}

Erosion read_erosion(const TomlTable& target) {
  const auto table = target.optional_table("erosion");
  if (!table) return NoErosion{};
  const std::string key = erosion_key(*table);
  const double limit = erosion_limit(*table, key);
  if (key != "strain" && table->has("measure"))
    table->refuse("measure", "this beside " + key, "measure only beside strain");
  const auto measure = static_cast<StrainMeasure>(table->word(
      "measure",
      {word(StrainMeasure::engineering), word(StrainMeasure::true_strain), word(StrainMeasure::green_lagrange)}, 0));
  if (key == "stress") return StressErosion{limit};
  if (key == "energy") return EnergyErosion{limit};
  return StrainErosion{limit, measure};
}

Relaxation read_relaxation(const TomlTable& target) {
  const auto tables = target.tables("relaxation");
  if (tables.empty()) return NoRelaxation{};
  if (tables.size() > most_relaxation_terms)
    target.refuse("relaxation", fmt::format("{} terms", tables.size()), "up to 3 terms, each a [[target.relaxation]]");
  PronySeries series;
  double sum = 0;
  for (const TomlTable& table : tables) {
    const Range share{
        .low = 0, .high = 1, .low_open = true, .high_open = true, .words = "a number between 0 and 1, both excluded"};
    series.terms.push_back({table.number("share", share), table.quantity("time", dimension::time, positive("time"))});
    sum += series.terms.back().share;
    if (!(sum < 1))
      table.refuse("share", fmt::format("{}, which makes the shares' sum {}", series.terms.back().share, sum),
                   "shares with a sum below 1, so that some stiffness is left");
  }
  return series;
}

struct OgdenAsGiven {
  double mu;  // Pa, meant as the convention says
  double alpha;
};

OgdenAsGiven read_ogden(const TomlTable& table, ModulusConvention convention) {
  const double alpha = table.number("alpha", any_number());
  if (std::abs(alpha) < smallest_alpha) {
    table.refuse("alpha", fmt::format("{}", alpha),
                 "a number from 0.001 up or from -0.001 down; alpha = 0 is not solved so far");
  }
  const double mu_as_given = table.quantity("mu", dimension::pressure, any_number());
  const double mu = true_modulus(mu_as_given, alpha, convention);
  if (mu > 0 && std::isfinite(mu)) return {mu_as_given, alpha};
  const std::string found = fmt::format("{} Pa", mu_as_given);
  if (convention == ModulusConvention::true_shear) table.refuse("mu", found, "a positive pressure");
  table.refuse("mu", fmt::format("{}, which makes the true shear modulus mu alpha/2 = {} Pa", found, mu),
               fmt::format("a {} pressure where convention = \"mu/alpha\" and alpha = {}",
                           alpha > 0 ? "positive" : "negative", alpha));
}

std::optional<double> lower_erosion_limit(const TomlTable& layer, const LayerScene& first) {
  const auto table = layer.optional_table("erosion");
  if (!table) return std::nullopt;
  if (std::holds_alternative<NoErosion>(first.erosion))
    layer.refuse(
        "erosion", "this where the first layer has none",
        "[target.erosion] as well, whose criterion is that of all layers; a limit out of reach keeps the first whole");
  const std::string key = erosion_key(*table), firsts = erosion_keys[first.erosion.index() - 1];
  if (key != firsts) table->refuse(key, "this", firsts + ", the criterion of [target.erosion]");
  return erosion_limit(*table, key);
}

}  // namespace

VolumetricChoice volumetric_from(const TomlTable& table) {
  const auto nu = table.optional_number("nu", {.low = -1,
                                               .high = 0.5,
                                               .low_open = true,
                                               .high_open = true,
                                               .words = "a number between -1 and 0.5, both excluded"});
  const auto ratio = table.optional_number("bulk_to_shear", positive("number (K/mu)"));
  if (nu && ratio) table.refuse("bulk_to_shear", "this beside nu", "one of the two, or neither (K is then chosen)");
  if (nu) return PoissonRatio{*nu};
  if (ratio) return BulkToShear{*ratio};
  return ChooseBulk{};
}

Range length_above(double low, const std::string& of_what) {
  return {.low = low,
          .high = infinity,
          .low_open = true,
          .words = "a length above the particle's " + of_what + " of " + format_quantity(low, dimension::length),
          .in_general = "a length above the particle's " + of_what};
}

LayerScene target_from(const TomlTable& table, const ParticleScene& particle, Geometry geometry, const Range& depth) {
  LayerScene target;
  target.name = table.text("name", target.name);
  target.density = table.quantity("density", dimension::density, positive("density"));
  target.convention = static_cast<ModulusConvention>(
      table.word("convention", {word(ModulusConvention::true_shear), word(ModulusConvention::mu_over_alpha)}, 0));
  const auto [mu, alpha] = read_ogden(table, target.convention);
  target.mu_as_given = mu;
  target.alpha = alpha;
  target.volumetric = volumetric_from(table);
  target.depth = table.quantity("depth", dimension::length, depth);
  const double widest = reach(particle, geometry);
  target.width = table.quantity(
      "width", dimension::length,
      length_above(widest, widest == particle.radius ? "radius" : "largest distance from its middle line"));
  target.bottom = static_cast<Bottom>(table.word("bottom", {"free", "fixed"}, static_cast<int>(target.bottom)));
  target.erosion = read_erosion(table);
  target.relaxation = read_relaxation(table);
  return target;
}

std::vector<LowerLayerScene> below_from(const std::vector<TomlTable>& tables, const LayerScene& first) {
  std::vector<LowerLayerScene> below;
  for (const TomlTable& table : tables) {
    LowerLayerScene layer;
    layer.name = table.text("name", layer.name);
    layer.density = table.quantity("density", dimension::density, positive("density"));
    const auto [mu, alpha] = read_ogden(table, first.convention);
    layer.mu_as_given = mu;
    layer.alpha = alpha;
    layer.volumetric = volumetric_from(table);
    layer.depth = table.quantity("depth", dimension::length, positive("length"));
    layer.erosion_limit = lower_erosion_limit(table, first);
    below.push_back(layer);
  }
  return below;
}

}  // namespace percal
