// What no single block of a job can tell.
#include <algorithm>
#include <set>

#include "percal/calibrate/read_job.hpp"

namespace percal {
namespace {

void add_index(std::set<int>& indices, const MaterialNumber& number) {
  if (const auto* shared = std::get_if<SharedParameter>(&number)) indices.insert(shared->index);
}

std::set<int> parameters_of(const CalibrationMaterial& material) {
  std::set<int> indices;
  for (const MaterialNumber* number : {&material.mu, &material.alpha, &material.erosion_strain})
    add_index(indices, *number);
  return indices;
}

// Parameters that a fitted shot or a curve depends on.
std::set<int> parameters_with_data(const CalibrationJob& job) {
  std::set<int> indices;
  for (const MeasuredShot& shot : job.shots)
    if (shot.used) indices.merge(parameters_of(job.materials[shot.material]));
  for (const MeasuredCurve& curve : job.curves) {
    add_index(indices, job.materials[curve.material].mu);
    add_index(indices, job.materials[curve.material].alpha);
  }
  return indices;
}

void check_parameters(const TomlTable& root, const CalibrationJob& job) {
  std::set<int> named;
  for (const CalibrationMaterial& material : job.materials) named.merge(parameters_of(material));
  const std::set<int> with_data = parameters_with_data(job);
  for (std::size_t k = 0; k < job.parameters.size(); ++k) {
    const std::string& name = job.parameters[k].free.name;
    if (!named.contains(static_cast<int>(k)))
      root.table("parameters")
          .refuse(name, "a parameter that no material names",
                  "one that is mu, alpha or erosion_strain of some material");
    if (!with_data.contains(static_cast<int>(k)))
      root.table("parameters")
          .refuse(name, "a parameter that no fitted datum depends on",
                  "a fitted shot of its material (for mu and alpha a curve will do), or a value in its place");
  }
}

void check_materials(const TomlTable& root, const CalibrationJob& job) {
  for (std::size_t m = 0; m < job.materials.size(); ++m) {
    const auto of_this = [m](const auto& data) { return data.material == static_cast<int>(m); };
    if (std::none_of(job.shots.begin(), job.shots.end(), of_this) &&
        std::none_of(job.curves.begin(), job.curves.end(), of_this))
      root.table("materials").refuse(job.materials[m].name, "a material without data", "shots or curves of it");
  }
}

void check_groups(const TomlTable& root, const CalibrationJob& job) {
  for (std::size_t g = 0; g < job.groups.size(); ++g) {
    const auto in_this = [g](const auto& data) { return data.group == static_cast<int>(g); };
    if (std::none_of(job.shots.begin(), job.shots.end(), in_this) &&
        std::none_of(job.curves.begin(), job.curves.end(), in_this))
      root.table("scatter").refuse(job.groups[g].name, "a group without data",
                                   "shots or curves with scatter = its name");
  }
}

}  // namespace

void check_use(const TomlTable& root, const CalibrationJob& job) {
  if (job.shots.empty() && job.curves.empty())
    root.refuse("shots", "neither shots nor curves", "[[shots]] or [[curves]]");
  check_materials(root, job);
  check_groups(root, job);
  check_parameters(root, job);
}

}  // namespace percal
