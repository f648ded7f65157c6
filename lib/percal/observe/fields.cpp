#include "percal/observe/fields.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "percal/base/error.hpp"
#include "percal/base/inputs.hpp"
#include "percal/text/file.hpp"

namespace percal {
namespace {

// x, y, z of each point; z = 0 of one in the plane.
template <class Number, class Coordinates>
std::vector<Number> in_space(const std::vector<Coordinates>& points, double unit) {
  std::vector<Number> numbers;
  numbers.reserve(3 * points.size());
  for (const Coordinates& point : points) {
    for (const double coordinate : point) numbers.push_back(static_cast<Number>(coordinate * unit));
    if (point.size() == 2) numbers.push_back(0);
  }
  return numbers;
}

// What `numbers_of` makes of each state, one after the other.
template <class NumbersOf>
std::vector<float> of_states(const std::vector<CellState>& states, const NumbersOf& numbers_of) {
  std::vector<float> numbers;
  for (const CellState& state : states)
    for (const double number : numbers_of(state)) numbers.push_back(static_cast<float>(number));
  return numbers;
}

double von_mises(const std::array<double, 6>& s) {
  const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

void add_states(VtuMesh& mesh, const std::vector<CellState>& states, double pressure) {
  using Numbers = std::vector<double>;
  mesh.cell_data.push_back(
      {"principal_stretches", 3, of_states(states, [](const CellState& c) { return c.stretches; })});
  // VTK's order of a symmetric tensor is that of CellState: XX, YY, ZZ, XY, YZ, XZ.
  mesh.cell_data.push_back({"stress", 6, of_states(states, [&](const CellState& c) {
                              Numbers numbers(c.stress.begin(), c.stress.end());
                              for (double& number : numbers) number *= pressure;
                              return numbers;
                            })});
  mesh.cell_data.push_back({"pressure", 1, of_states(states, [&](const CellState& c) {
                              return Numbers{-(c.stress[0] + c.stress[1] + c.stress[2]) / 3 * pressure};
                            })});
  mesh.cell_data.push_back({"von_mises_stress", 1, of_states(states, [&](const CellState& c) {
                              return Numbers{von_mises(c.stress) * pressure};
                            })});
  mesh.cell_data.push_back({"energy_density", 1, of_states(states, [&](const CellState& c) {
                              return Numbers{c.energy_density * pressure};
                            })});
}

template <class Coordinates>
VtuMesh mesh_of_piece(const PieceOf<Coordinates>& piece, double time, const Scales& scales) {
  VtuMesh mesh;
  mesh.time = time * scales.radius / scales.speed;
  mesh.points = in_space<double>(piece.position, scales.radius);
  mesh.corners.assign(piece.corners.begin(), piece.corners.end());
  mesh.ends.assign(piece.ends.begin(), piece.ends.end());
  mesh.point_data.push_back({"displacement", 3, in_space<float>(piece.displacement, scales.radius)});
  mesh.point_data.push_back({"velocity", 3, in_space<float>(piece.velocity, scales.speed)});
  if (!piece.states.empty()) add_states(mesh, piece.states, scales.target_density * scales.speed * scales.speed);
  return mesh;
}

template <class Coordinates>
VtuMesh mesh_of_target(const TargetPieceOf<Coordinates>& target, double time, double volume_unit,
                       const Scales& scales) {
  VtuMesh mesh = mesh_of_piece(target, time, scales);
  std::vector<float> volumes;
  for (const double volume : target.volume) volumes.push_back(static_cast<float>(volume * volume_unit));
  mesh.cell_data.push_back({"eroded", 1, target.eroded});
  mesh.cell_data.push_back({"layer", 1, std::vector<std::uint8_t>(target.layer.begin(), target.layer.end())});
  mesh.cell_data.push_back({"undeformed_volume", 1, volumes});
  return mesh;
}

struct FrameMeshes {
  VtuMesh target, particle;
};
FrameMeshes meshes_of(const Frame& frame, const Problem& problem, const Scales& scales) {
  if (!frame.in_space) return {target_fields(frame, problem, scales), particle_fields(frame, scales)};
  const SpaceFrame space = frame.in_space();
  const double time = frame.moment.time, radius = scales.radius;
  FrameMeshes meshes{mesh_of_target(space.target, time, radius * radius * radius, scales),
                     mesh_of_piece(space.particle, time, scales)};
  meshes.target.hexahedra = true;
  return meshes;
}

// "target_0003.vtu", "particle_12345.vtu".
bool is_frame_file(const std::string& name) {
  const auto number = name.find('_') + 1, end = name.find_first_not_of("0123456789", number);
  return (name.starts_with("target_") || name.starts_with("particle_")) && end != std::string::npos &&
         end - number >= 4 && name.substr(end) == ".vtu";
}

// Files of an earlier series, which the new one may be shorter than.
void remove_earlier_frames(const std::string& folder, const std::string& list) {
  std::error_code error;
  std::vector<std::filesystem::path> found{list};
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (is_frame_file(entry.path().filename().string())) found.push_back(entry.path());
  for (const auto& file : found) refuse_to_replace_input(file.string());
  for (const auto& file : found)
    if (!error) std::filesystem::remove(file, error);
  if (error) throw IoFailure(folder + ": an earlier series cannot be removed: " + error.message());
}

}  // namespace

VtuMesh target_fields(const Frame& frame, const Problem& problem, const Scales& scales) {
  const double radius = scales.radius;
  const double volume_unit = problem.geometry == Geometry::axisymmetric
                                 ? 2 * std::numbers::pi * radius * radius * radius
                                 : radius * radius;  // of a metre's thickness
  return mesh_of_target(frame.target, frame.moment.time, volume_unit, scales);
}

VtuMesh particle_fields(const Frame& frame, const Scales& scales) {
  return mesh_of_piece(frame.particle, frame.moment.time, scales);
}

FieldSeries::FieldSeries(std::string folder, const std::string& name, const FieldInterval& interval,
                         const Problem& problem, const Scales& scales)
    : folder_(std::move(folder)),
      list_((std::filesystem::path(folder_) / (name + ".pvd")).string()),
      problem_(problem),
      scales_(scales),
      schedule_(interval, problem, scales) {
  ensure_writable_folder(folder_);
  remove_earlier_frames(folder_, list_);
}

void FieldSeries::see(const Frame& frame) {
  const auto [target, particle] = meshes_of(frame, problem_, scales_);
  const std::vector<std::string> files{fmt::format("target_{:04}.vtu", written_.size()),
                                       fmt::format("particle_{:04}.vtu", written_.size())};
  const std::filesystem::path folder(folder_);
  write_file((folder / files[0]).string(), vtu_text(target));
  write_file((folder / files[1]).string(), vtu_text(particle));
  written_.push_back({target.time, files});
  write_file(list_, pvd_text(written_));
}

}  // namespace percal
