// Models that a page to play with is asked about: the gel of the smooth law, and one that has all that a model can have.
#pragma once
#include "percal/math/draws.hpp"
#include "predict/smooth_model.hpp"

namespace percal::test {

// Two hypotheses, of which the second knows its scatter; two materials.
inline ShotModel model_of_two_gels() {
  ShotModel model = smooth_model();
  MaterialSample& gel = model.hypotheses.front().materials.front();
  for (const double factor : {0.8, 0.95, 1.03, 1.25}) {
    LayerMaterial point = true_gel;
    point.mu_true *= factor;
    point.erosion_strain *= std::pow(factor, -0.4);
    gel.points.push_back(point);
  }
  MaterialSample stiff = gel;
  stiff.name = "stiff \"gel\" & </script><b>more";
  for (CoveredMaterial& point : stiff.points) point.mu_true *= 2.5;
  model.hypotheses.front().materials.push_back(stiff);
  ShotHypothesis other = model.hypotheses.front();
  other.name = "scatter known";
  other.contradicted = true;
  for (MaterialSample& material : other.materials) {
    material.freedom = 0;
    for (CoveredMaterial& point : material.points) point.alpha = 6;
  }
  model.hypotheses.push_back(other);
  return model;
}

// A gel under a skin and a membrane, each with its laws, judged over a length, whose emulator has learnt from two meshes; its depths are
// reaches.
inline ShotModel model_of_everything() {
  constexpr int runs = 120;
  const auto points = sobol_points(runs, sphere_inputs, 1);
  ShotModel model{.elements = 5, .passage = true, .shots = steel_balls(), .runs = {}, .settings = {}, .hypotheses = {}};
  model.shots[0].seen = "at least";
  model.shots[1].seen = "passed";
  model.shots[1].depth.reset();
  for (int k = 0; k < runs; ++k) {
    const auto u = points.row(k);
    SphereInputs at{std::log(3.0) + u[0] * std::log(60.0),
                    std::log(1 / 17.0) + u[1] * std::log(15.0),
                    4 + 8 * u[2],
                    0.3 + 1.2 * u[3],
                    std::log(20.0) + u[4] * std::log(6.0),
                    std::log(50.0) + u[5] * std::log(40.0),
                    std::log(0.1) + u[6] * std::log(10.0)};
    for (int cover = 0; cover < (k % 4 == 0 ? 0 : most_covers); ++cover) {
      const auto of = u.segment(inputs_without_covers + 5 * cover, 5);
      lay_on(at, cover_members[cover],
             {.thickness = 0.2 + of[0],
              .density = 0.9 + 0.3 * of[1],
              .mu = 0.5 + 4 * of[2],
              .alpha = 3 + 8 * of[3],
              .erosion_strain = 0.3 + of[4]});
    }
    const double h = k % 3 == 0 ? 0.1 : 0.25;
    model.runs.push_back({at, h, smooth_law(at) - 0.4 * at.cover_depth - 0.2 * at.second_depth + 0.3 * h});
  }
  model.settings = {.amplitude = 0.5, .mesh_amplitude = 0.1, .mesh_order = 0.8, .noise = 0.02, .noise_order = 0.4};
  model.settings.length.fill(3);
  model.settings.mesh_length.fill(4);
  MaterialSample gel{.name = "gel", .points = {}, .scatter = 0.06, .freedom = 5};
  Draws draws(2);
  for (int k = 0; k < 6; ++k) {
    const auto factor = [&] { return std::exp(0.1 * draws.normal()); };
    LayerMaterial layer = true_gel;
    layer.mu_true *= factor();
    layer.erosion_length = 0.5e-3 * factor();
    layer.laws = {.rate_exponent = 0.1 * factor(),
                  .reference_rate = 3e4,
                  .size_exponent = -0.2 * factor(),
                  .reference_radius = 1e-3,
                  .cell = 2.5e-3,
                  .erosion_strain_below = 0.6 * factor()};
    LayerMaterial skin{.density = 1100, .mu_true = 400e3 * factor(), .alpha = 5 * factor(), .erosion_strain = 0.5};
    skin.laws.relaxation.terms = {{0.3 * factor(), 1e-5}, {0.2, 1e-3 * factor()}};
    LayerMaterial membrane = true_gel;
    membrane.alpha = 9 * factor();
    gel.points.push_back(CoveredMaterial(layer, {{skin, 1e-3}, {membrane, 0.5e-3}}));
  }
  model.hypotheses = {{.name = "as given", .mesh_error = -0.02, .materials = {gel}}};
  return model;
}

}  // namespace percal::test
