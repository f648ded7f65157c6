#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/powder/job.hpp"
#include "percal/powder/read_distribution.hpp"
#include "percal/scene/document_kind.hpp"
#include "percal/text/file.hpp"
#include "percal/text/job_table.hpp"

namespace percal {
namespace {

const Range confidence{.low = 0.5, .high = 0.9999, .words = "a level of confidence from 0.5 to 0.9999"};
const Range any_share{.low = 0, .high = 1, .words = "a share from 0 to 1"};
const Range some_scatter{.low = 0, .high = 1.5, .words = "a standard deviation of ln depth from 0 to 1.5"};
const Range tolerated{.low = 0.1, .high = 0.999, .words = "a share from 0.1 to 0.999"};

PlacedText placed(const TomlTable& root, const std::string& key) { return {root.text(key, ""), root.place(key)}; }

Bounce read_bounce(const TomlTable& root) {
  const int word = root.word("bounce", {"breach", "depth", "none"}, 0);
  root.knows("breach");
  root.knows("least_depth");
  if (word != 0 && root.has("breach")) root.refuse("breach", "this without bounce = \"breach\"", "bounce = \"breach\"");
  if (word != 1 && root.has("least_depth"))
    root.refuse("least_depth", "this without bounce = \"depth\"", "bounce = \"depth\"");
  if (word == 0)
    return Breach{root.quantity("breach", dimension::impact_parameter, positive("density times speed times radius"),
                                Breach{}.impact_parameter)};
  if (word == 1) return LeastDepth{root.number("least_depth", positive("number of radii"), LeastDepth{}.radii)};
  return NoBounce{};
}

Distribution halved(Distribution diameters) {
  if (auto* lognormal = std::get_if<Lognormal>(&diameters)) {
    lognormal->median /= 2;
    return diameters;
  }
  for (ValueClass& one : std::get<Histogram>(diameters)) {
    one.low /= 2;
    one.high /= 2;
  }
  return diameters;
}

void read_powder(const TomlTable& root, PowderJob& job) {
  const TomlTable block = root.table("powder");
  block.knows("radius");
  block.knows("diameter");
  if (block.has("radius") && block.has("diameter")) block.refuse("diameter", "this beside radius", "one of the two");
  const bool diameters = block.has("diameter");
  const auto sizes = read_distribution(block, {diameters ? "diameter" : "radius", dimension::length, true});
  job.powder.radius = diameters ? halved(sizes.by_number) : sizes.by_number;
  job.sizes_by_mass = sizes.was_by_mass;
  job.powder.density = read_distribution(block, {"density", dimension::density}).by_number;
  read_speed(block, job.powder);
}

void read_layers(const TomlTable& root, PowderJob& job) {
  double top = 0;
  for (const TomlTable& block : root.tables("layers")) {
    DepthLayer layer{.name = block.text("name"), .from = top};
    for (const DepthLayer& other : job.layers)
      if (other.name == layer.name) block.refuse("name", "the name of another layer", "a name of its own");
    top += block.quantity("thickness", dimension::length, positive("thickness"));
    layer.to = top;
    job.layers.push_back(layer);
  }
}

void read_measured(const TomlTable& root, PowderJob& job) {
  const auto block = root.optional_table("measured");
  if (!block) return;
  job.measured = MeasuredDepths{.mean = block->quantity("mean", dimension::length, positive("length")),
                                .deviation = block->quantity("deviation", dimension::length, positive("length")),
                                .particles = block->optional_integer("particles", 2, 1'000'000'000),
                                .note = block->text("note", "")};
}

void read_band(const TomlTable& root, PowderJob& job) {
  const auto block = root.optional_table("band");
  if (!block) return;
  DepthBand band{block->quantity("from", dimension::length, not_negative("depth")),
                 block->quantity("to", dimension::length, positive("depth"))};
  if (!(band.to > band.from)) block->refuse("to", format_quantity(band.to, dimension::length), "more than from");
  job.band = band;
}

SearchRange range_in(const TomlTable& block, const std::string& key, const Dimension& dimension) {
  const auto ends = block.quantities(key, dimension, positive(name_of(dimension)));
  if (ends.size() != 2 || !(ends[1] > ends[0]))
    block.refuse(key, fmt::format("{} of them{}", ends.size(), ends.size() == 2 ? ", the first no smaller" : ""),
                 "two, the smaller one first");
  return {ends[0], ends[1]};
}

DoseLimits read_limits(const TomlTable& root) {
  DoseLimits limits;
  const auto block = root.optional_table("limits");
  if (!block) return limits;
  limits.bounced = optional_share_from(*block, "bounced", any_share);
  limits.passed = optional_share_from(*block, "passed", any_share);
  limits.deeper_than = block->optional_quantity("deeper_than", dimension::length, positive("depth"));
  limits.deeper = optional_share_from(*block, "deeper", any_share);
  limits.beyond = optional_share_from(*block, "beyond", any_share);
  limits.most_impact = block->optional_quantity("most_impact", dimension::impact_parameter,
                                                positive("density times speed times radius"));
  if (limits.deeper && !limits.deeper_than) block->refuse("deeper", "this without deeper_than", "both or neither");
  if (limits.deeper_than && !limits.deeper) block->refuse("deeper_than", "this without deeper", "both or neither");
  return limits;
}

void read_design(const TomlTable& root, PowderJob& job) {
  const DoseLimits limits = read_limits(root);
  const auto block = root.optional_table("design");
  if (!block) {
    if (root.has("limits")) root.refuse("limits", "this without [design]", "[design], for percal design");
    return;
  }
  if (!job.band) root.refuse("band", "no such table", "[band] beside [design]: where the dose is wanted");
  block->knows("radius");
  block->knows("diameter");
  if (block->has("radius") == block->has("diameter"))
    block->refuse("radius", block->has("radius") ? "this beside diameter" : "no such key",
                  "one of radius and diameter");
  DesignQuestion design;
  design.radius = range_in(*block, block->has("radius") ? "radius" : "diameter", dimension::length);
  if (block->has("diameter")) design.radius = {design.radius.low / 2, design.radius.high / 2};
  design.speed = range_in(*block, "speed", dimension::speed);
  if (block->has("densities"))
    design.densities = block->quantities("densities", dimension::density, positive("density"));
  block->knows("densities");
  design.map = block->integer("map", 5, 101, design.map);
  design.enough = share_from(*block, "enough", tolerated, design.enough);
  design.limits = limits;
  job.design = design;
}

}  // namespace

PowderJob read_powder_job(const std::string& path) {
  PowderJob job;
  job.file = path;
  job.text = read_file(path);
  const TomlTable root = parse_toml(job.text, path);
  need_kind(root, DocumentKind::powder);
  job.title = root.text("title", path);
  root.describe("calibration", {"file", "the result.json of a percal calibrate, or its folder", ""});
  job.calibration = {root.path("calibration"), root.place("calibration")};
  job.material = placed(root, "material");
  job.hypothesis = placed(root, "hypothesis");
  job.level = root.optional_number("level", confidence);
  job.layer_depth = root.optional_quantity("layer_depth", dimension::length, positive("length"));
  job.layer_place = root.place("layer_depth");
  job.scatter = root.optional_number("scatter", some_scatter);
  job.bounce = read_bounce(root);
  read_powder(root, job);
  read_layers(root, job);
  read_measured(root, job);
  read_band(root, job);
  read_design(root, job);
  root.finish();
  return job;
}

}  // namespace percal
