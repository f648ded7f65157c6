// [targets.NAME]: materials with others on top of them.
#include <fmt/format.h>

#include <algorithm>

#include "percal/calibrate/job/read_job.hpp"
#include "percal/invert/emulator.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

// Of SharedParameters that are the same parameter, of numbers that are equal.
bool is_same(const MaterialNumber& a, const MaterialNumber& b) {
  const auto *of_a = std::get_if<SharedParameter>(&a), *of_b = std::get_if<SharedParameter>(&b);
  if (of_a && of_b) return of_a->index == of_b->index;
  return !of_a && !of_b && std::get<double>(a) == std::get<double>(b);
}

// A run has one erosion length for all its layers.
void need_one_erosion_length(const TomlTable& block, const CalibrationMaterial& cover,
                             const CalibrationMaterial& below) {
  if (cover.erosion_length && !is_same(*cover.erosion_length, *below.erosion_length))
    block.refuse("material", in_quotes(cover.name) + ", whose erosion_length is not that of " + in_quotes(below.name),
                 "layers of one target with one erosion_length");
}

CalibrationTarget target_from(const TomlTable& block, const std::string& name, const CalibrationJob& job) {
  CalibrationTarget target{.name = name, .material = material_index(block, job)};
  for (const TomlTable& cover : block.tables("covers")) {
    target.covers.push_back({.material = material_index(cover, job),
                             .thickness = cover.quantity("thickness", dimension::length, positive("thickness"))});
    need_one_erosion_length(cover, job.materials[target.covers.back().material], job.materials[target.material]);
  }
  if (target.covers.empty() || target.covers.size() > most_covers)
    block.refuse("covers", fmt::format("{} of them", target.covers.size()),
                 fmt::format("one to {} [[targets.{}.covers]], from the top down", most_covers, name));
  std::ranges::reverse(target.covers);
  return target;
}

}  // namespace

void read_targets(const TomlTable& root, CalibrationJob& job) {
  for (std::size_t m = 0; m < job.materials.size(); ++m)
    job.targets.push_back({.name = job.materials[m].name, .material = static_cast<int>(m)});
  const auto blocks = root.optional_table("targets");
  if (!blocks) return;
  for (const std::string& name : blocks->keys()) {
    if (std::ranges::find(job.targets, name, &CalibrationTarget::name) != job.targets.end())
      blocks->refuse(name, "the name of a material", "another name");
    job.targets.push_back(target_from(blocks->table(name), name, job));
  }
  const bool closed_form = covers_of(job) == 0;
  if (!closed_form && root.has("dehn") && job.dehn)
    root.refuse("dehn", "true beside targets with covers", "false: the closed form knows one layer");
  job.dehn = job.dehn && closed_form;
}

int target_index(const TomlTable& block, const CalibrationJob& job) {
  block.knows("target");
  if (!block.has("target")) return material_index(block, job);  // the first targets are the materials
  if (block.has("material")) block.refuse("material", "this beside target", "one of the two");
  const std::string name = block.text("target");
  const auto found = std::ranges::find(job.targets, name, &CalibrationTarget::name);
  if (found == job.targets.end())
    block.refuse("target", in_quotes(name), "a target or a material of the job: " + names_of(job.targets));
  return static_cast<int>(found - job.targets.begin());
}

}  // namespace percal
