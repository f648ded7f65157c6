#include "percal/atlas/atlas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "percal/atlas/embedded.hpp"
#include "percal/invert/depth_covariance.hpp"
#include "percal/text/csv.hpp"

namespace percal {
namespace {

// A number of a run as a column has it.
struct Column {
  const char* name;
  double (*of)(const TrainingRun&);
  void (*put)(TrainingRun&, double);
};

template <double SphereInputs::*member>
constexpr Column logarithmic(const char* name) {
  return {name, [](const TrainingRun& run) { return std::exp(run.at.*member); },
          [](TrainingRun& run, double value) { run.at.*member = std::log(value); }};
}
template <double SphereInputs::*member>
constexpr Column plain(const char* name) {
  return {name, [](const TrainingRun& run) { return run.at.*member; },
          [](TrainingRun& run, double value) { run.at.*member = value; }};
}

const std::vector<Column>& columns() {
  static const std::vector<Column> all{logarithmic<&SphereInputs::log_pi4>("pi4"),
                                       logarithmic<&SphereInputs::log_pi5>("pi5"),
                                       plain<&SphereInputs::alpha>("alpha"),
                                       plain<&SphereInputs::erosion_strain>("erosion_strain"),
                                       logarithmic<&SphereInputs::log_layer_depth>("layer_depth"),
                                       logarithmic<&SphereInputs::log_bulk_ratio>("bulk_ratio"),
                                       logarithmic<&SphereInputs::log_erosion_length>("erosion_length"),
                                       {"element_size", [](const TrainingRun& run) { return run.h; },
                                        [](TrainingRun& run, double value) { run.h = value; }},
                                       {"reach", [](const TrainingRun& run) { return std::exp(run.log_depth); },
                                        [](TrainingRun& run, double value) { run.log_depth = std::log(value); }}};
  return all;
}

constexpr char setting_mark[] = "# setting: ";

constexpr int runs_near = 300, runs_for_a_look = 150;
// A search that begins on a third of them and ends after a few steps on all: as near to fresh runs as one that goes on to the end, its noise
// within some 13 % of that one's.                                                                docs/verification/atlas.md
constexpr EmulatorOptions search_near{
    .most_points_for_search = runs_near, .most_points_for_starts = 100, .most_evaluations = 130};
// How far features may differ for runs to tell of each other about as much as of a run twice as far in another one: the lengths that the
// search finds over the whole atlas, by three.                                                    docs/theory/atlas.md (1)
constexpr std::array feature_lengths{2.0, 1.5, 8.0, 0.6, 2.0, 3.0, 0.7};

std::string setting_in(const std::string& text, const std::string& name) {
  const auto begin = text.find(setting_mark);
  if (begin == std::string::npos)
    throw BadInput({.file = name, .line = 1, .key = ""}, "no line that says the setting of the runs",
                   fmt::format("a line that begins with \"{}\"", setting_mark));
  const auto from = begin + sizeof(setting_mark) - 1;
  return text.substr(from, text.find_first_of("\r\n", from) - from);
}

}  // namespace

Atlas parse_atlas(const std::string& text, const std::string& name) {
  const CsvTable table = parse_csv(text, name);
  Atlas atlas{.name = name, .setting = setting_in(text, name), .runs = std::vector<TrainingRun>(table.rows.size())};
  for (const Column& column : columns()) {
    const std::vector<double> values = table.numbers(column.name, dimension::none);
    for (std::size_t k = 0; k < values.size(); ++k) column.put(atlas.runs[k], values[k]);
  }
  for (std::size_t k = 0; k < atlas.runs.size(); ++k) {
    const TrainingRun& run = atlas.runs[k];
    if (!in_order(run.at).allFinite() || !std::isfinite(run.log_depth) || !(run.h > 0) || !(run.at.erosion_strain > 0))
      throw BadInput({.file = name, .line = table.rows[k].line, .key = ""}, "numbers that cannot be those of a run",
                     "numbers above 0; an exponent may be below");
  }
  return atlas;
}

std::string atlas_text(const std::string& setting, const std::vector<TrainingRun>& runs) {
  std::string text =
      "# Runs of rigid spheres: lengths in radii, element_size in radii too or in erosion lengths where there is one "
      "(1: none).\n"
      "# reach: docs/theory/emulator.md (1a). Written by percal atlas write.\n";
  text += setting_mark + setting + "\n";
  for (const Column& column : columns())
    text += fmt::format("{}{}", &column == &columns().front() ? "" : ",", column.name);
  text += "\n";
  for (const TrainingRun& run : runs) {
    for (const Column& column : columns())
      text += fmt::format("{}{:.5g}", &column == &columns().front() ? "" : ",", column.of(run));
    text += "\n";
  }
  return text;
}

const std::vector<Atlas>& own_atlases() {
  static const std::vector<Atlas> own = [] {
    std::vector<Atlas> all;
    for (const auto& [name, text] : embedded_atlases()) all.push_back(parse_atlas(text, name));
    return all;
  }();
  return own;
}

const Atlas* own_atlas(const std::string& setting) {
  const auto found = std::ranges::find(own_atlases(), setting, &Atlas::setting);
  return found == own_atlases().end() ? nullptr : &*found;
}

std::vector<TrainingRun> nearest_runs(const std::vector<TrainingRun>& runs, std::size_t most,
                                      const std::function<double(const TrainingRun&)>& distance) {
  std::vector<double> distances;
  for (const TrainingRun& run : runs) distances.push_back(distance(run));
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return distances[k]; });
  order.resize(std::min(most, order.size()));
  std::ranges::sort(order);
  std::vector<TrainingRun> nearest;
  for (std::size_t k : order) nearest.push_back(runs[k]);
  return nearest;
}

std::function<double(const TrainingRun&)> feature_distance(const SphereInputs& at) {
  return [here = depth_features(at)](const TrainingRun& run) {
    const Eigen::VectorXd there = depth_features(run.at);
    double sum = 0;
    for (std::size_t j = 0; j < feature_lengths.size(); ++j) {
      const double apart = there[static_cast<Eigen::Index>(j)] - here[static_cast<Eigen::Index>(j)];
      sum += apart * apart / (feature_lengths[j] * feature_lengths[j]);
    }
    return sum;
  };
}

Emulator emulator_near(const Atlas& atlas, const SphereInputs& at) {
  return Emulator(nearest_runs(atlas.runs, runs_near, feature_distance(at)), search_near);
}

Emulator roughly_near(const Atlas& atlas, const SphereInputs& at) {
  constexpr double of_distance = 3;  // lengths of the search over those of feature_distance()
  EmulatorSettings settings{
      .amplitude = 1.1, .mesh_amplitude = 0.08, .mesh_order = 1, .noise = 0.027, .noise_order = 0.5};
  for (std::size_t j = 0; j < feature_lengths.size(); ++j)
    settings.length[j] = settings.mesh_length[j] = of_distance * feature_lengths[j];
  return Emulator(nearest_runs(atlas.runs, runs_for_a_look, feature_distance(at)), settings);
}

}  // namespace percal
