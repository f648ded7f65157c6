// A sphere, or a body of another shape, shot into a layer of a known material: as a scene to run, and as inputs of the emulator.   docs/theory/prediction.md
#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "percal/invert/emulator.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

// What is shot where that is no sphere: a rigid prism or polyhedron in three dimensions, standing and flying as the scene has it.
//                                                                                     docs/theory/emulator.md, Other bodies
struct ShotBody {
  int place = 1;  // among the bodies of its job or result, from 1
  Scene scene;    // geometry, particle, mesh and solver of its runs; nothing else of it counts

  const std::string& name() const { return scene.particle.name; }
};

// A rigid sphere straight down into a layer, or several of them; SI. Or another body into one layer.
struct SphereShot {
  double radius = 0, density = 0;          // m, kg/m3: of the sphere; of another body half its width
  double speed = 0;                        // m/s
  double layer_depth = 0;                  // m; of all layers together
  double layer_width = 0;                  // m: radius of the fixed outer wall
  std::shared_ptr<const ShotBody> body{};  // none: a sphere
};

// ShotBody::place, 0 of a sphere.
inline int place_of_body(const SphereShot& shot) { return shot.body ? shot.body->place : 0; }

// "3.18 mm at 83 m/s"; of a body without its size.
std::string words_of(const SphereShot& shot);

// How numbers of a material change from shot to shot: the modulus by a power of the rate v/a, or by what has relaxed of it in a/v; the
// erosion strain by a power of the radius, or by whether the sphere is smaller than a cell. Exponents and a cell of 0, a series without
// terms: they do not.                                                                        docs/theory/calibration.md (3a) to (3d)
struct MaterialLaws {
  double rate_exponent = 0, reference_rate = 1;    // 1/s
  double size_exponent = 0, reference_radius = 1;  // m
  double cell = 0, erosion_strain_below = 0;       // m: spheres of a smaller diameter erode it at this strain
  PronySeries relaxation = {};                     // s; the modulus is then the instantaneous one
};
inline bool is_below_cell(const MaterialLaws& laws, double radius) { return 2 * radius < laws.cell; }

// The numbers of the layer's material; of one with laws at the reference rate and radius.
struct LayerMaterial {
  double density = 0;  // kg/m3
  double mu_true = 0;  // Pa
  double alpha = 0;
  double erosion_strain = 0;                  // engineering: the critical stretch less 1
  std::optional<double> erosion_length = {};  // m
  MaterialLaws laws = {};
};

// A layer with what lies on top of it, nothing by default: covers, the next to it first, at most most_covers of them.
struct Cover {
  LayerMaterial material;
  double thickness = 0;  // m
};
struct CoveredMaterial : LayerMaterial {
  CoveredMaterial() = default;
  CoveredMaterial(LayerMaterial layer, std::vector<Cover> on_top = {})  // implicit: a layer alone is one without covers
      : LayerMaterial(std::move(layer)), covers(std::move(on_top)) {}
  std::vector<Cover> covers;
};

// Over the modulus at the reference rate (of one that relaxes: the instantaneous one), over the erosion strain at the reference radius.
double rate_factor(const MaterialLaws& laws, double rate);
double size_factor(const MaterialLaws& laws, double radius);
// What the shot meets: the laws applied, and gone.
LayerMaterial at_shot(const LayerMaterial& material, const SphereShot& shot);

// Elements per radius of a mesh with so many elements in the material's erosion length, or per radius where it has none; of a body on the
// smaller of half its width and half its thickness.
double mesh_of(const SphereShot& shot, const LayerMaterial& material, double elements);

// What `scene` becomes for the shot: particle and target; its mesh and its solver stay. A sphere is rigid, as in every published run; K/mu
// keeps the Mach number below 0.3. A body brings its geometry, its solver and the rest of its mesh. Names of covers are "cover", with their places where there are several.
Scene scene_of_shot(Scene scene, const SphereShot& shot, const CoveredMaterial& material);

// The emulator's inputs for a shot: those of its problem (inputs_of), but for the problem's rounding, over which nothing could be
// differentiated. With their derivatives.
struct ShotInputs {
  SphereInputs at;
  // By a material's ln mu_true, alpha, erosion strain, ln erosion length, rate exponent, size exponent, erosion strain below a cell: of
  // the layer, then of each cover
  using ByMaterial = Eigen::Matrix<double, sphere_inputs, 7>;
  std::vector<ByMaterial> by_material;
  Eigen::Vector<double, sphere_inputs> by_log_speed;
  // Of the layer, then of each cover: d ln(modulus met) / d(the share of each term of relaxation, then ln of each time); empty where it
  // does not relax
  std::vector<Eigen::RowVectorXd> log_mu_by_relaxation = {};
};
ShotInputs shot_inputs(const SphereShot& shot, const CoveredMaterial& material);

}  // namespace percal
