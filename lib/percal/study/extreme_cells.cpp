#include "percal/study/extreme_cells.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace percal {
namespace {

constexpr double radius = 1e-6, speed = 651, density = 1000, mu = 63.75e6;                            // SI
constexpr double base_depth = 40, base_end = 200;                                                     // radii
constexpr double gold = 16800, steel = 7800, titanium = 4540, pmma = 1150, tungsten_carbide = 15600;  // kg/m3
constexpr double radius_time = radius / speed;                                                        // s

Scene base_scene() {
  Scene scene;
  scene.source = "cell";
  scene.particle.name = "gold";
  scene.particle.radius = radius;
  scene.particle.density = gold;
  scene.particle.speed = speed;
  scene.target.name = "skin";
  scene.target.density = density;
  scene.target.mu_as_given = mu;
  scene.target.alpha = 8.5;
  scene.target.volumetric = BulkToShear{50};
  scene.target.depth = base_depth * radius;
  scene.target.width = 5 * radius;
  scene.target.erosion = StrainErosion{0.7};
  scene.mesh.elements_per_radius = 7;
  scene.solver.end_time = base_end * radius_time;
  scene.replicates = 1;
  return scene;
}

void no_erosion(Scene& s) { s.target.erosion = NoErosion{}; }
void erode_at(Scene& s, double strain) { s.target.erosion = StrainErosion{strain}; }
void set_pi4(Scene& s, double pi4) { s.target.mu_as_given = density * speed * speed / pi4; }
void set_density_ratio(Scene& s, double ratio) { s.particle.density = ratio * density; }
void stop_at(Scene& s, double radii) { s.solver.end_time = radii * s.particle.radius / s.particle.speed; }
// K/mu with which the impact has this Mach number.
void set_mach(Scene& s, double mach) {
  const double pi4 = density * speed * speed / s.target.mu_as_given;
  s.target.volumetric = BulkToShear{pi4 / (mach * mach) - 4.0 / 3};
}
// Without dimensions the same problem, with radius `to`.
void set_radius(Scene& s, double to) {
  const double factor = to / s.particle.radius;
  s.particle.radius = to;
  s.target.depth *= factor;
  *s.target.width *= factor;
  *s.solver.end_time *= factor;
}
void make_elastic(Scene& s, double youngs_modulus) {
  s.particle.youngs_modulus = youngs_modulus;
  s.particle.elasticity = Elasticity::elastic;
}
void set_profile(Scene& s, std::vector<std::array<double, 2>> vertices) {
  s.particle.shape = ProfileShape{.vertices_file = "",
                                  .vertices = std::move(vertices),
                                  .orientation = 0,
                                  .mass = std::nullopt,
                                  .free_rotation = false};
}
void make_cone(Scene& s, double tip_angle) {  // deg
  const double height = radius / std::tan(tip_angle / 360 * std::numbers::pi);
  set_profile(s, {{0, 0}, {radius, height}, {-radius, height}});
}
void make_rhombus(Scene& s, double tip_angle) {
  const double height = radius / std::tan(tip_angle / 360 * std::numbers::pi);
  s.geometry = Geometry::plane_strain;
  set_profile(s, {{0, 0}, {radius, height}, {0, 2 * height}, {-radius, height}});
}
void gelatin(Scene& s, double modulus, double impact_speed) {
  s.target.name = "gelatin";
  s.target.mu_as_given = modulus;
  s.particle.speed = impact_speed;
  stop_at(s, base_end);
}
LowerLayerScene second_layer(const Scene& s, double modulus, double depth) {
  return {.name = "second",
          .density = density,
          .mu_as_given = modulus,
          .alpha = s.target.alpha,
          .volumetric = BulkToShear{50},
          .depth = depth * radius,
          .erosion_limit = 0.7};
}
void layered(Scene& s, double first_thickness, double first, double second) {
  s.target.mu_as_given = first;
  s.target.depth = first_thickness * radius;
  s.below = {second_layer(s, second, base_depth - first_thickness)};
}

class Matrix {
 public:
  Matrix& group(std::string name) {
    group_ = std::move(name);
    return *this;
  }
  void add(const std::string& what, const std::function<void(Scene&)>& change) {
    cells_.push_back({group_, what, base_scene()});
    change(cells_.back().scene);
  }
  std::vector<ExtremeCell> take() { return std::move(cells_); }

 private:
  std::string group_;
  std::vector<ExtremeCell> cells_;
};

void add_material(Matrix& m) {
  m.group("alpha");
  for (const double alpha : {-20.0, -5.0, -2.0, 0.5, 2.0, 9.0, 16.0, 25.0})
    m.add(fmt::format("alpha {}", alpha), [=](Scene& s) { s.target.alpha = alpha; });
  m.group("Poisson's ratio");
  for (const double nu : {0.3, 0.4, 0.45, 0.49, 0.495, 0.499, 0.4999})
    m.add(fmt::format("nu {}", nu), [=](Scene& s) { s.target.volumetric = PoissonRatio{nu}; });
  m.group("volumetric law");
  m.add("quadratic", [](Scene& s) { s.solver.volumetric_law = VolumetricLaw::quadratic; });
  m.add("logarithmic", [](Scene& s) { s.solver.volumetric_law = VolumetricLaw::logarithmic; });
  m.group("relaxation");
  for (const double time : {1e-3, 1.0, 1e3})
    m.add(fmt::format("half relaxes in {} radii", time), [=](Scene& s) {
      s.target.relaxation = PronySeries{{{0.5, time * radius_time}}};
    });
  m.add("three terms, 0.99 in all", [](Scene& s) {
    s.target.relaxation = PronySeries{{{0.33, 1e-3 * radius_time}, {0.33, radius_time}, {0.33, 1e3 * radius_time}}};
  });
}

void add_erosion(Matrix& m) {
  m.group("erosion");
  for (const double strain : {0.05, 0.2, 0.5, 1.0, 2.0, 3.0})
    m.add(fmt::format("strain {}", strain), [=](Scene& s) { erode_at(s, strain); });
  m.add("none", no_erosion);
  m.add("true strain 0.5", [](Scene& s) { s.target.erosion = StrainErosion{0.5, StrainMeasure::true_strain}; });
  m.add("Green-Lagrange strain 1", [](Scene& s) {
    s.target.erosion = StrainErosion{1, StrainMeasure::green_lagrange};
  });
  m.add("stress of 2 mu", [](Scene& s) { s.target.erosion = StressErosion{2 * mu}; });
  m.add("energy of mu/4", [](Scene& s) { s.target.erosion = EnergyErosion{mu / 4}; });
  m.add("strain 0.7, eroded nodes in contact", [](Scene& s) { s.solver.eroded_nodes = ErodedNodes::in_contact; });
}

void rub(Scene& s, double coefficient) { s.particle.friction = CoulombFriction{coefficient}; }
void weave(Scene& s, double k1, double k2, double kappa) { s.target.fibres = PlanarFibres{k1 * mu, k2, kappa}; }

void add_skin(Matrix& m) {
  m.group("several criteria");
  m.add("strain 0.7 or stress of 2 mu", [](Scene& s) { s.target.further_erosion.stress = 2 * mu; });
  m.add("all three, the energy far out of reach", [](Scene& s) { s.target.further_erosion = {2 * mu, 1e6 * mu}; });
  m.add("strain 0.05 below a cell of 10 um", [](Scene& s) { s.target.erosion_by_size = SmallerThanCell{1e-5, 0.05}; });
  m.group("friction");
  for (const double coefficient : {0.01, 0.3, 1.0, 100.0})
    m.add(fmt::format("coefficient {}", coefficient), [=](Scene& s) { rub(s, coefficient); });
  m.add("coefficient 1, erosion none", [](Scene& s) {
    rub(s, 1);
    no_erosion(s);
  });
  m.add("coefficient 1, cone of 30 deg", [](Scene& s) {
    rub(s, 1);
    make_cone(s, 30);
  });
  m.group("initial stretch");
  for (const double stretch : {0.5, 0.9, 1.2, 1.69})
    m.add(fmt::format("stretch {}", stretch), [=](Scene& s) { s.target.stretch = stretch; });
  m.add("stretch 1.3, erosion none, alpha -5", [](Scene& s) {
    s.target.stretch = 1.3;
    s.target.alpha = -5;
    no_erosion(s);
  });
  m.add("stretch 1.3 over an unstretched layer", [](Scene& s) {
    layered(s, 2, mu, mu);
    s.target.stretch = 1.3;
  });
  m.group("fibres");
  m.add("k1 of mu, k2 1", [](Scene& s) { weave(s, 1, 1, 0.5); });
  m.add("k1 of 1000 mu, k2 0.1", [](Scene& s) { weave(s, 1000, 0.1, 0.45); });
  m.add("k1 of mu, k2 1000", [](Scene& s) { weave(s, 1, 1000, 0.4); });
  m.add("k1 of mu, k2 1, erosion none", [](Scene& s) {
    weave(s, 1, 1, 1.0 / 3);
    no_erosion(s);
  });
  m.add("k1 of mu, k2 10, stretch 1.2, coefficient 0.3", [](Scene& s) {
    weave(s, 1, 10, 0.5);
    s.target.stretch = 1.2;
    rub(s, 0.3);
  });
}

void add_groups_of_similarity(Matrix& m) {
  m.group("pi4");
  for (int exponent = -3; exponent <= 4; ++exponent)
    m.add(fmt::format("pi4 1e{}", exponent), [=](Scene& s) { set_pi4(s, std::pow(10, exponent)); });
  m.group("density ratio");
  for (const double ratio : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0})
    m.add(fmt::format("density ratio {}", ratio), [=](Scene& s) { set_density_ratio(s, ratio); });
  m.group("radius");
  const std::pair<double, const char*> radii[] = {{1e-8, "10 nm"},  {1e-7, "100 nm"}, {1e-6, "1 um"},
                                                  {1e-4, "100 um"}, {1e-2, "1 cm"},   {1, "1 m"}};
  for (const auto& [to, name] : radii)
    m.add(fmt::format("radius {}", name), [to = to](Scene& s) { set_radius(s, to); });
}

void add_particles(Matrix& m) {
  m.group("particle");
  m.add("PMMA at 80 m/s", [](Scene& s) {
    s.particle.density = pmma;
    s.particle.speed = 80;
    stop_at(s, base_end);
  });
  const std::pair<const char*, double> kinds[] = {
      {"PMMA", pmma}, {"titanium", titanium}, {"steel", steel}, {"tungsten carbide", tungsten_carbide}};
  for (const auto& [name, kind] : kinds)
    m.add(fmt::format("{} at 651 m/s", name), [kind = kind](Scene& s) { s.particle.density = kind; });
  m.add("tungsten carbide at 3000 m/s", [](Scene& s) {
    s.particle.density = tungsten_carbide;
    s.particle.speed = 3000;
    stop_at(s, base_end);
  });
  m.group("elastic particle");
  m.add("gold, E 79 GPa", [](Scene& s) { make_elastic(s, 79e9); });
  m.add("steel, E 210 GPa, into gelatin of 10 kPa at 20 m/s", [](Scene& s) {
    s.particle.density = steel;
    gelatin(s, 10e3, 20);
    make_elastic(s, 210e9);
    stop_at(s, 20);
  });
  m.add("PMMA, E 2.45 GPa", [](Scene& s) {
    s.particle.density = pmma;
    make_elastic(s, 2.45e9);
  });
  m.add("as soft as the target, E 3 mu", [](Scene& s) {
    set_density_ratio(s, 1);
    make_elastic(s, 3 * mu);
  });
  m.add("ten times stiffer, E 30 mu, erosion none", [](Scene& s) {
    make_elastic(s, 30 * mu);
    no_erosion(s);
  });
  m.group("tip angle");
  for (const double angle : {20.0, 30.0, 45.0, 60.0, 90.0})
    m.add(fmt::format("cone of {} deg", angle), [=](Scene& s) { make_cone(s, angle); });
  for (const double angle : {20.0, 30.0, 45.0, 60.0, 90.0})
    m.add(fmt::format("rhombus of {} deg", angle), [=](Scene& s) { make_rhombus(s, angle); });
  for (const double tilt : {0.0, 10.0})
    m.add(fmt::format("rhombus of 60 deg, tilted by {} deg, free to turn", tilt), [=](Scene& s) {
      make_rhombus(s, 60);
      auto& profile = std::get<ProfileShape>(s.particle.shape);
      profile.orientation = tilt / 180 * std::numbers::pi;
      profile.free_rotation = true;
      s.mesh.whole = true;
    });
}

void add_meshes(Matrix& m) {
  m.group("mesh");
  for (const double n : {1, 2, 40, 100})
    m.add(fmt::format("{} element{} per radius", n, n == 1 ? "" : "s"), [=](Scene& s) {
      s.mesh.elements_per_radius = n;
      if (n >= 40) s.target.depth = 3 * radius;
    });
  m.group("thickness");
  for (const double thickness : {1.1, 2.0})
    m.add(fmt::format("{} radii", thickness), [=](Scene& s) { s.target.depth = thickness * radius; });
  m.add("2 radii, bottom fixed", [](Scene& s) {
    s.target.depth = 2 * radius;
    s.target.bottom = Bottom::fixed;
  });
  m.add("2 radii, bottom fixed, erosion none", [](Scene& s) {
    s.target.depth = 2 * radius;
    s.target.bottom = Bottom::fixed;
    no_erosion(s);
  });
  m.group("layers");
  m.add("1000 times stiffer below", [](Scene& s) { layered(s, 5, mu / 100, 10 * mu); });
  m.add("1000 times softer below", [](Scene& s) { layered(s, 5, 10 * mu, mu / 100); });
  m.add("a skin of one element, ten times stiffer", [](Scene& s) { layered(s, 1.0 / 7, 10 * mu, mu); });
}

void add_numerics(Matrix& m) {
  m.group("time step");
  for (const double factor : {0.1, 0.5, 0.9, 1.0, 1.2})
    m.add(fmt::format("factor {}", factor), [=](Scene& s) { s.solver.time_step_factor = factor; });
  m.add("factor 1.2, erosion none", [](Scene& s) {
    s.solver.time_step_factor = 1.2;
    no_erosion(s);
  });
  m.group("numerics");
  m.add("double precision", [](Scene& s) { s.solver.arithmetic = Arithmetic::double_precision; });
  m.add("one rate", [](Scene& s) { s.solver.rates = 1; });
  m.add("no hourglass control", [](Scene& s) { s.solver.hourglass = 0; });
  m.add("hourglass viscosity 0.1", [](Scene& s) {
    s.solver.hourglass_form = HourglassForm::viscosity;
    s.solver.hourglass = 0.1;
  });
  m.add("no viscosity", [](Scene& s) { s.solver.linear_viscosity = s.solver.quadratic_viscosity = 0; });
}

void add_supersonic(Matrix& m) {
  m.group("supersonic");
  for (const double mach : {1.1, 2.0})
    for (const bool erodes : {true, false})
      m.add(fmt::format("Mach {}, erosion {}", mach, erodes ? "0.7" : "none"), [=](Scene& s) {
        set_pi4(s, 100);
        set_mach(s, mach);
        if (!erodes) no_erosion(s);
      });
  for (const bool erodes : {true, false})
    m.add(fmt::format("Mach 10, erosion {}", erodes ? "0.7" : "none"), [=](Scene& s) {
      set_pi4(s, 1e4);
      set_mach(s, 10);
      if (!erodes) no_erosion(s);
    });
  m.add("Mach 2, K raised on request", [](Scene& s) {
    set_pi4(s, 100);
    set_mach(s, 2);
    s.solver.stiffen_supersonic = true;
  });
}

void add_combinations(Matrix& m) {
  m.group("combination");
  m.add("alpha 25, erosion none", [](Scene& s) {
    s.target.alpha = 25;
    no_erosion(s);
  });
  m.add("alpha -20, pi4 100", [](Scene& s) {
    s.target.alpha = -20;
    set_pi4(s, 100);
  });
  m.add("alpha 16, nu 0.4999", [](Scene& s) {
    s.target.alpha = 16;
    s.target.volumetric = PoissonRatio{0.4999};
  });
  m.add("alpha 25, strain 3", [](Scene& s) {
    s.target.alpha = 25;
    erode_at(s, 3);
  });
  m.add("alpha -20, erosion none, pi4 1e3", [](Scene& s) {
    s.target.alpha = -20;
    no_erosion(s);
    set_pi4(s, 1e3);
  });
  m.add("alpha 0.5, erosion none, pi4 1e4", [](Scene& s) {
    s.target.alpha = 0.5;
    no_erosion(s);
    set_pi4(s, 1e4);
  });
  m.add("nu 0.3, erosion none, pi4 100", [](Scene& s) {
    s.target.volumetric = PoissonRatio{0.3};
    no_erosion(s);
    set_pi4(s, 100);
  });
  m.add("density ratio 20, pi4 1e-3, one element per radius", [](Scene& s) {
    set_density_ratio(s, 20);
    set_pi4(s, 1e-3);
    s.mesh.elements_per_radius = 1;
  });
}

// What is refused before it starts, with the reader's words.
void add_refused(Matrix& m) {
  m.group("refused");
  m.add("friction 0.3 of an elastic particle", [](Scene& s) {
    rub(s, 0.3);
    make_elastic(s, 79e9);
  });
  m.add("stretch 1.7, the erosion strain's own", [](Scene& s) { s.target.stretch = 1.7; });
  m.add("nu 0.5", [](Scene& s) { s.target.volumetric = PoissonRatio{0.5}; });
  m.add("alpha 0", [](Scene& s) { s.target.alpha = 0; });
  m.add("negative mu", [](Scene& s) { s.target.mu_as_given = -mu; });
  m.add("factor 1.3", [](Scene& s) { s.solver.time_step_factor = 1.3; });
  m.add("layer thinner than the radius", [](Scene& s) { s.target.depth = 0.9 * radius; });
  m.add("wall within the particle", [](Scene& s) { s.target.width = radius; });
  m.add("erosion strain 0", [](Scene& s) { erode_at(s, 0); });
  m.add("elastic prism", [](Scene& s) {
    s.geometry = Geometry::plane_strain;
    make_elastic(s, 79e9);
  });
  m.add("all of the modulus relaxes", [](Scene& s) { s.target.relaxation = PronySeries{{{1, radius_time}}}; });
}

}  // namespace

std::vector<ExtremeCell> extreme_cells() {
  Matrix matrix;
  add_material(matrix);
  add_erosion(matrix);
  add_skin(matrix);
  add_groups_of_similarity(matrix);
  add_particles(matrix);
  add_meshes(matrix);
  add_numerics(matrix);
  add_supersonic(matrix);
  add_combinations(matrix);
  add_refused(matrix);
  return matrix.take();
}

}  // namespace percal
