#include "percal/scene/erosion_toml.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "percal/units/words.hpp"

namespace percal {
namespace {

// What an erosion table may say, in the order of the alternatives of Erosion behind NoErosion.
const std::vector<std::string> criteria{"strain", "stress", "energy"};

using Limits = std::array<std::optional<double>, 3>;  // by criteria

std::optional<double> optional_limit(const TomlTable& table, const std::string& key) {
  if (key == "strain") return table.optional_number(key, positive("strain"));
  return table.optional_quantity(key, dimension::pressure, positive(key == "stress" ? "stress" : "energy per volume"));
}

// One or more of them.
Limits read_limits(const TomlTable& table) {
  Limits limits;
  for (std::size_t k = 0; k < criteria.size(); ++k) limits[k] = optional_limit(table, criteria[k]);
  if (std::ranges::none_of(limits, [](const auto& limit) { return limit.has_value(); }))
    table.refuse("strain", "no such key", "one or more of strain, stress and energy, each a positive limit");
  return limits;
}

std::size_t first_of(const Limits& limits) {
  return static_cast<std::size_t>(
      std::ranges::find_if(limits, [](const auto& limit) { return limit.has_value(); }) - limits.begin());
}

// Those behind the first one.
FurtherErosion further_of(const Limits& limits, std::size_t first) {
  return {first < 1 ? limits[1] : std::nullopt, first < 2 ? limits[2] : std::nullopt};
}

Erosion erosion_by(std::size_t criterion, double limit, StrainMeasure measure) {
  switch (criterion) {
    case 1: return StressErosion{limit};
    case 2: return EnergyErosion{limit};
  }
  return StrainErosion{limit, measure};
}

void only_beside_strain(const TomlTable& table, const std::string& key) {
  if (table.has(key) && !table.has("strain")) table.refuse(key, "this without strain", key + " only beside strain");
}

ErosionBySize read_by_size(const TomlTable& table) {
  const auto strain = table.optional_number("strain_below", positive("strain"));
  const auto cell = table.optional_quantity("cell", dimension::length, positive("length"));
  only_beside_strain(table, "strain_below");
  only_beside_strain(table, "cell");
  if (!strain && !cell) return AnySize{};
  if (!strain) table.refuse("cell", "this without strain_below", "strain_below beside it: the limit of smaller particles");
  if (!cell) table.refuse("strain_below", "this without cell", "cell beside it: the size from which strain counts");
  return SmallerThanCell{*cell, *strain};
}

ErosionAverage read_average(const TomlTable& table, const ParticleScene& particle, const LayerScene& layer) {
  const auto length = table.optional_quantity("length", dimension::length, positive("length"));
  const auto in_radii = table.optional_number("length_in_radii", positive("number of radii"));
  if (length && in_radii)
    table.refuse("length_in_radii", "this beside length",
                 "one of the two, or neither: each element is then judged by itself");
  if (!length && !in_radii) return NoAverage{};
  const std::string key = erosion_length_key(table);
  if (table.has("stress"))
    table.refuse(
        key, "this beside stress",
        "a length beside strain or energy: what is averaged is the energy, and a limit of stress is none of it");
  if (!layer.further_erosion.is_empty())
    table.refuse(key, "this beside strain and energy", "a length beside one criterion, strain or energy");
  return AverageWithin{length ? *length : *in_radii * particle.radius};
}

}  // namespace

std::string erosion_length_key(const TomlTable& erosion) {
  for (const char* key : {"length", "length_in_radii"})
    if (erosion.has(key)) return key;
  return "";
}

void read_erosion(const TomlTable& target, const ParticleScene& particle, LayerScene& layer) {
  const auto table = target.optional_table("erosion");
  if (!table) return;
  const Limits limits = read_limits(*table);
  const std::size_t first = first_of(limits);
  only_beside_strain(*table, "measure");
  const auto measure = static_cast<StrainMeasure>(table->word(
      "measure",
      {word(StrainMeasure::engineering), word(StrainMeasure::true_strain), word(StrainMeasure::green_lagrange)}, 0));
  layer.erosion = erosion_by(first, *limits[first], measure);
  layer.further_erosion = further_of(limits, first);
  layer.erosion_by_size = read_by_size(*table);
  layer.erosion_average = read_average(*table, particle, layer);
}

void read_lower_erosion(const TomlTable& table, const LayerScene& first, LowerLayerScene& layer) {
  const auto erosion = table.optional_table("erosion");
  if (!erosion) return;
  if (std::holds_alternative<NoErosion>(first.erosion))
    table.refuse(
        "erosion", "this where the first layer has none",
        "[target.erosion] as well, whose criteria are those of all layers; a limit out of reach keeps the first whole");
  const std::size_t own = first.erosion.index() - 1;
  const std::array<bool, 3> known{own == 0, own == 1 || first.further_erosion.stress, own == 2 || first.further_erosion.energy};
  std::vector<std::string> accepted;
  for (std::size_t k = 0; k < criteria.size(); ++k)
    if (known[k]) accepted.push_back(criteria[k]);
  const Limits limits = read_limits(*erosion);
  for (std::size_t k = 0; k < criteria.size(); ++k)
    if (limits[k] && !known[k])
      erosion->refuse(criteria[k], "this",
                      fmt::format("{}, {} of [target.erosion]", fmt::join(accepted, " or "),
                                  accepted.size() == 1 ? "the criterion" : "the criteria"));
  layer.erosion_limit = limits[own];
  layer.further_erosion = further_of(limits, own);
  layer.erosion_by_size = read_by_size(*erosion);
}

}  // namespace percal
