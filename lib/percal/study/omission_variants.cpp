#include "percal/study/omission_variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "percal/base/error.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/problem/domain.hpp"
#include "percal/problem/particle.hpp"
#include "percal/scene/profile.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/scene/width.hpp"
#include "percal/study/ladder.hpp"

namespace percal {
namespace {

constexpr double wider = 2, thicker = 1.5, finer = 1.5, stiffer_layer = 2, stiffer_bulk = 4;
constexpr double illustrated_share = 0.2;  // of the modulus that relaxes within a radius at impact speed
constexpr double illustrated_friction = 0.1, illustrated_stretch = 1.05, illustrated_fibres = 0.1;
constexpr double weak_hourglass = 0.1, strong_hourglass = 1, viscous_hourglass = 0.1;

class Planner {
 public:
  Planner(const Scene& scene, const Reduction& baseline) : scene_(scene), baseline_(baseline) {}

  // What the next variants are about.
  Planner& about(OmissionKind kind, std::string left_out = "", bool is_illustration = false) {
    kind_ = kind;
    left_out_ = std::move(left_out);
    is_illustration_ = is_illustration;
    return *this;
  }

  void add(const std::string& name, const std::string& how, const std::function<void(Scene&)>& change) {
    Scene variant = scene_;
    variant.output = {};
    change(variant);
    try {
      refuse_what_is_too_large(reduce(parse_scene(scene_to_toml(variant, ""), scene_.source)).problem, scene_.source);
    } catch (const BadInput& error) {
      return skip(name, error.what());
    }
    plan_.variants.push_back({name, kind_, how, left_out_, is_illustration_, std::move(variant)});
  }

  void skip(const std::string& name, const std::string& why) { plan_.skipped.push_back({name, kind_, why, left_out_}); }

  void physics(const std::optional<double>& depth) {
    particle();
    friction();
    layers(depth);
    relaxation();
    skin();
    volumetric_laws();
    eroded_nodes();
  }

  void domain() {
    about(OmissionKind::domain);
    if (scene_.target.bottom == Bottom::free)
      add("bottom fixed", "the layer's lower face does not move", [](Scene& s) { s.target.bottom = Bottom::fixed; });
    else
      add("bottom free", "the layer's lower face is free", [](Scene& s) { s.target.bottom = Bottom::free; });
    const Problem& p = baseline_.problem;
    const int columns = graded_columns_like(p, p.elements_per_radius, wider * p.width);
    add("width x 2", fmt::format("the wall twice as far away, {} graded columns that grow as before", columns),
        [columns](Scene& s) {
          s.target.width = wider * width_of(s);
          s.mesh.graded_columns = columns;
        });
    add("thickness x 1.5",
        scene_.below.empty() ? "the layer half as thick again"
                             : "the lowest layer thicker by half of all layers' thickness",
        [this](Scene& s) { lowest_depth(s) += (thicker - 1) * whole_depth(); });
  }

  void numerics() {
    hourglass();
    viscosity();
    resolution();
    about(OmissionKind::numerics);
    add("K/mu x 4",
        fmt::format("{:.4g} for {:.4g}", stiffer_bulk * baseline_.problem.bulk_ratio, baseline_.problem.bulk_ratio),
        [this](Scene& s) {
          s.target.volumetric = BulkToShear{stiffer_bulk * baseline_.problem.bulk_ratio};
          for (std::size_t i = 0; i < s.below.size(); ++i)
            s.below[i].volumetric = BulkToShear{stiffer_bulk * baseline_.problem.below[i].bulk_ratio};
        });
  }

  OmissionPlan take() { return std::move(plan_); }

 private:
  void particle() {
    about(OmissionKind::physics, "elastic particle");
    const auto& p = scene_.particle;
    if (is_elastic(scene_))
      add("rigid particle", "without the elasticity that the scene has",
          [](Scene& s) { s.particle.elasticity = Elasticity::rigid; });
    else if (!std::holds_alternative<NoFriction>(p.friction))
      skip("elastic particle", "the scene has friction, which is that of rigid particles");
    else if (!p.youngs_modulus)
      skip("elastic particle", "the scene gives no Young's modulus");
    else
      add("elastic particle",
          fmt::format("meshed, Young's modulus {:.4g} GPa, Poisson's ratio {:.3g}", 1e-9 * *p.youngs_modulus,
                      p.poisson_ratio),
          [](Scene& s) { s.particle.elasticity = Elasticity::elastic; });
    const auto* profile = std::get_if<ProfileShape>(&p.shape);
    if (scene_.geometry != Geometry::plane_strain) return;
    about(OmissionKind::physics, "rotation");
    if (profile && !profile->free_rotation)
      add("rotation", "the particle is free to turn and to move sideways, both halves meshed", [](Scene& s) {
        std::get<ProfileShape>(s.particle.shape).free_rotation = true;
        s.mesh.whole = true;
      });
    about(OmissionKind::numerics, "second half");
    if (!baseline_.problem.whole)
      add("second half", "both sides of the middle line meshed", [](Scene& s) { s.mesh.whole = true; });
  }

  void friction() {
    if (!std::holds_alternative<NoFriction>(scene_.particle.friction)) {
      about(OmissionKind::physics);
      return add("no friction", "without the friction that the scene has",
                 [](Scene& s) { s.particle.friction = NoFriction{}; });
    }
    about(OmissionKind::physics, "friction", true);
    if (is_elastic(scene_)) return skip("friction", "the particle is elastic, and friction is that of rigid ones");
    add("friction", fmt::format("an illustration: Coulomb's, with a coefficient of {}", illustrated_friction),
        [](Scene& s) {
          s.particle.friction = CoulombFriction{illustrated_friction};
          s.particle.elasticity = Elasticity::rigid;
        });
  }

  // A second layer from `share` of the target's depth on; the first layer is that much thinner.
  static void split(Scene& s, double from, double stiffness) {
    LowerLayerScene lower;
    lower.name = "second layer";
    lower.density = s.target.density;
    lower.mu_as_given = stiffness * s.target.mu_as_given;
    lower.alpha = s.target.alpha;
    lower.volumetric = s.target.volumetric;
    lower.depth = s.target.depth - from;
    if (const auto* strain = std::get_if<StrainErosion>(&s.target.erosion)) lower.erosion_limit = strain->limit;
    if (const auto* stress = std::get_if<StressErosion>(&s.target.erosion)) lower.erosion_limit = stress->limit;
    if (const auto* energy = std::get_if<EnergyErosion>(&s.target.erosion)) lower.erosion_limit = energy->limit;
    lower.further_erosion = s.target.further_erosion;
    lower.erosion_by_size = s.target.erosion_by_size;
    lower.stretch = s.target.stretch;
    lower.fibres = s.target.fibres;
    s.target.depth = from;
    s.below = {lower};
  }

  void layers(const std::optional<double>& depth) {
    about(OmissionKind::physics, "further layers", scene_.below.empty());
    if (!scene_.below.empty()) {
      add("one layer", "the first layer's material all the way down", [this](Scene& s) {
        s.target.depth = whole_depth();
        s.below.clear();
      });
      return;
    }
    const double element = scene_.particle.radius / scene_.mesh.elements_per_radius;
    const double middle = 0.5 * std::min(depth.value_or(scene_.target.depth), scene_.target.depth);
    const double from = element * std::max(1.0, std::round(middle / element));
    const std::string where = fmt::format("from {:.3g} radii down, {} ", from / scene_.particle.radius,
                                          depth ? "the middle of the penetration" : "the middle of the layer");
    add("second layer of the same", where + "on: the same material, a check of layering itself",
        [from](Scene& s) { split(s, from, 1); });
    add("second layer twice as stiff", where + "on; the factor is an illustration",
        [from](Scene& s) { split(s, from, stiffer_layer); });
  }

  void relaxation() {
    if (!std::holds_alternative<NoRelaxation>(scene_.target.relaxation)) {
      about(OmissionKind::physics);
      add("no relaxation", "without the Prony series of the scene",
          [](Scene& s) { s.target.relaxation = NoRelaxation{}; });
      return;
    }
    about(OmissionKind::physics, "rate dependence", true);
    const double time = scene_.particle.radius / scene_.particle.speed;
    add("relaxation", "an illustration: a fifth of the modulus relaxes in the time of one radius at impact speed",
        [time](Scene& s) {
          s.target.relaxation = PronySeries{{{illustrated_share, time}}};
        });
  }

  // Every layer's.
  template <class Change>
  static void each_layer(Scene& s, const Change& change) {
    change(s.target);
    for (LowerLayerScene& layer : s.below) change(layer);
  }

  void skin() {
    const auto some = [this](const auto& has) { return has(scene_.target) || std::ranges::any_of(scene_.below, has); };
    about(OmissionKind::physics);
    if (some([](const auto& layer) { return layer.stretch != 1 || layer.stretch_across; }))
      add("no initial stretch", "without the stretch that layers have before the impact",
          [](Scene& s) { each_layer(s, [](auto& layer) { layer.stretch = 1, layer.stretch_across.reset(); }); });
    else {
      about(OmissionKind::physics, "initial stretch", true);
      add("initial stretch",
          fmt::format("an illustration: every layer stretched by {} in its plane", illustrated_stretch), [](Scene& s) {
            each_layer(s, [](auto& layer) { layer.stretch = illustrated_stretch, layer.stretch_across.reset(); });
          });
    }
    about(OmissionKind::physics);
    if (some([](const auto& layer) { return !std::holds_alternative<NoFibres>(layer.fibres); }))
      return add("no fibres", "without the fibres of the scene",
                 [](Scene& s) { each_layer(s, [](auto& layer) { layer.fibres = NoFibres{}; }); });
    about(OmissionKind::physics, "fibres", true);
    add("fibres", "an illustration: in the first layer's plane, k1 a tenth of its modulus, k2 = 1",
        [this](Scene& s) { s.target.fibres = PlanarFibres{.k1 = illustrated_fibres * baseline_.mu_true, .k2 = 1}; });
  }

  void volumetric_laws() {
    about(OmissionKind::physics);
    const std::pair<VolumetricLaw, const char*> laws[] = {{VolumetricLaw::log_quadratic, "log-quadratic"},
                                                          {VolumetricLaw::quadratic, "quadratic"},
                                                          {VolumetricLaw::logarithmic, "logarithmic"}};
    for (const auto& [law, name] : laws)
      if (law != scene_.solver.volumetric_law)
        add(fmt::format("volumetric law {}", name), "another energy of the change in volume, with the same K",
            [law = law](Scene& s) { s.solver.volumetric_law = law; });
  }

  void eroded_nodes() {
    about(OmissionKind::physics);
    const bool released = scene_.solver.eroded_nodes == ErodedNodes::released;
    const std::string name = released ? "eroded nodes in contact" : "eroded nodes released";
    if (std::holds_alternative<NoErosion>(scene_.target.erosion)) return skip(name, "nothing erodes in this scene");
    add(name, released ? "nodes without elements still meet the particle" : "nodes without elements are let go",
        [released](Scene& s) { s.solver.eroded_nodes = released ? ErodedNodes::in_contact : ErodedNodes::released; });
  }

  void hourglass() {
    about(OmissionKind::numerics);
    const auto form = scene_.solver.hourglass_form;
    const auto set = [](HourglassForm to, double value) {
      return [to, value](Scene& s) {
        s.solver.hourglass_form = to;
        s.solver.hourglass = value;
      };
    };
    for (const double stiffness : {weak_hourglass, strong_hourglass})
      if (form != HourglassForm::stiffness || stiffness != scene_.solver.hourglass)
        add(fmt::format("hourglass stiffness {:.2g}", stiffness), "in units of mu",
            set(HourglassForm::stiffness, stiffness));
    if (form != HourglassForm::viscosity)
      add("hourglass viscosity",
          fmt::format("a damper of {:.2g} of the wave impedance in place of the spring", viscous_hourglass),
          set(HourglassForm::viscosity, viscous_hourglass));
  }

  void viscosity() {
    about(OmissionKind::numerics);
    const auto& s = scene_.solver;
    if (s.linear_viscosity > 0 || s.quadratic_viscosity > 0)
      add("bulk viscosity halved",
          fmt::format("linear {:.3g}, quadratic {:.3g}", s.linear_viscosity / 2, s.quadratic_viscosity / 2),
          [](Scene& v) {
            v.solver.linear_viscosity /= 2;
            v.solver.quadratic_viscosity /= 2;
          });
    if (s.linear_viscosity > 0)
      add("no linear bulk viscosity", fmt::format("quadratic {:.3g} as it is", s.quadratic_viscosity),
          [](Scene& v) { v.solver.linear_viscosity = 0; });
  }

  void resolution() {
    about(OmissionKind::numerics);
    const double mesh = scene_.mesh.elements_per_radius;
    const double fine = std::max(mesh + 1, std::round(finer * mesh));
    add(fmt::format("{:g} elements per radius", fine), fmt::format("for {:g}", mesh),
        [fine](Scene& s) { s = on_mesh(s, fine); });
    add("half the time step", fmt::format("factor {:.3g}", scene_.solver.time_step_factor / 2),
        [](Scene& s) { s.solver.time_step_factor /= 2; });
    const bool two = scene_.solver.rates == 2;
    add(two ? "one rate" : "two rates",
        two ? "all elements take the short step" : "elements away from the particle take twice the step",
        [two](Scene& s) { s.solver.rates = two ? 1 : 2; });
    const bool single = scene_.solver.arithmetic == Arithmetic::single_precision;
    about(OmissionKind::numerics, single ? "double precision" : "");
    add(single ? "double precision" : "single precision", "of the time loop", [single](Scene& s) {
      s.solver.arithmetic = single ? Arithmetic::double_precision : Arithmetic::single_precision;
    });
  }

  double whole_depth() const {
    double depth = scene_.target.depth;
    for (const auto& layer : scene_.below) depth += layer.depth;
    return depth;
  }
  static double& lowest_depth(Scene& s) { return s.below.empty() ? s.target.depth : s.below.back().depth; }

  const Scene& scene_;
  const Reduction& baseline_;
  OmissionKind kind_ = OmissionKind::physics;
  std::string left_out_;
  bool is_illustration_ = false;
  OmissionPlan plan_;
};

}  // namespace

std::string word(OmissionKind kind) {
  switch (kind) {
    case OmissionKind::physics: return "physics";
    case OmissionKind::domain: return "domain";
    case OmissionKind::numerics: return "numerics";
  }
  return "";
}

OmissionPlan plan_omissions(const Scene& scene, const Reduction& baseline, const std::optional<double>& depth) {
  Planner planner(scene, baseline);
  planner.physics(depth);
  planner.domain();
  planner.numerics();
  return planner.take();
}

}  // namespace percal
