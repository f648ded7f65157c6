// Targets that are stretched in their plane before the impact.
#include "percal/impact/target/initial_stretch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "impact/element_reference.hpp"
#include "impact/same_bits.hpp"
#include "impact/setting_s.hpp"
#include "impact/specimen.hpp"
#include "percal/impact/march/march.hpp"

namespace percal {
namespace {

Problem stretched_specimen(double stretch, Geometry geometry) {
  Problem p = specimen_problem();
  p.geometry = geometry;
  p.stretch = stretch;
  return p;
}

// Kirchhoff stresses, by the formula.
struct Stress {
  double r, z;
};
Stress stress_of(const Problem& p, const InitialStretch& l) {
  const double J = l.jacobian(), volumetric = p.bulk() / 2 * (J * J - 1);
  return {isochoric_stress_of(p.mu(), p.alpha, l.r, l.z, l.hoop) + volumetric,
          isochoric_stress_of(p.mu(), p.alpha, l.z, l.r, l.hoop) + volumetric};
}

InitialStretch initial_of(const Problem& p) { return constants_of_layers(p).front().initial; }

TEST(InitialStretch, LeavesTheFaceFreeOfStressToRoundOff) {
  for (const auto geometry : {Geometry::axisymmetric, Geometry::plane_strain})
    for (const double stretch : {0.8, 1.02, 1.1, 1.5}) {
      const Problem p = stretched_specimen(stretch, geometry);
      const InitialStretch l = initial_of(p);
      EXPECT_EQ(l.r, stretch);
      EXPECT_EQ(l.hoop, geometry == Geometry::plane_strain ? 1 : stretch);
      EXPECT_NEAR(stress_of(p, l).z, 0, 1e-11 * p.bulk());  // of 1e-12 that keeps equal stretches apart
      EXPECT_EQ(stress_of(p, l).r > 0, stretch > 1);
    }
  EXPECT_TRUE(initial_of(stretched_specimen(1, Geometry::axisymmetric)).is_none());
}

template <class Real>
double largest_free_force(StrainedTarget<Real>& specimen) {
  specimen.look(0);
  const auto& block = specimen.block;
  double largest = 0;
  for (int i = 0; i < block.mesh().columns(); ++i)  // the wall holds its nodes
    for (int j = 0; j <= block.mesh().rows; ++j) {
      const long n = block.at(i, j);
      if (i > 0) largest = std::max(largest, std::abs(static_cast<double>(block.far_forces().r[n])));
      largest = std::max(largest, std::abs(static_cast<double>(block.far_forces().z[n])));
    }
  return largest;
}

TEST(InitialStretch, LayersOfDifferentStretchAreInEquilibriumToRoundOff) {
  for (const auto geometry : {Geometry::axisymmetric, Geometry::plane_strain}) {
    Problem p = stretched_specimen(1.15, geometry);
    p.depth = 5;
    p.below = {{.depth = 4, .density = 1.2, .mu = 0.7, .alpha = 3, .stretch = 1.4}, {.depth = 3, .mu = 1, .alpha = -2}};
    StrainedTarget<double> exact(p);
    EXPECT_LT(largest_free_force(exact), 1e-12 * p.bulk());
    StrainedTarget<float> single(p);
    EXPECT_LT(largest_free_force(single), 3e-6 * p.bulk());
  }
}

TEST(InitialStretch, TheWallBearsTheTensionOfTheLayer) {
  const Problem p = stretched_specimen(1.2, Geometry::plane_strain);
  StrainedTarget<> specimen(p);
  specimen.look(0);
  const InitialStretch l = initial_of(p);
  EXPECT_NEAR(specimen.stress_r(), stress_of(p, l).r / l.jacobian(), 1e-11) << "Cauchy stress";
}

// The same element by the plain kernel, with the sides that it had and all of its way as displacement.
TEST(InitialStretch, AnElementGivesTheForcesOfTheUnstretchedOneThatHasComeToTheSamePlace) {
  for (const auto geometry : {Geometry::axisymmetric, Geometry::plane_strain}) {
    Problem p = stretched_specimen(1.25, geometry);
    p.hourglass = 0;
    StrainedTarget<> stretched(p);
    displace_at_random(stretched.block, 0.05);
    const ColumnReport report = stretched.look(0);
    const InitialStretch l = initial_of(p);

    p.stretch = 1;
    StrainedTarget<> plain(p);
    auto& block = plain.block;
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 0; j <= block.mesh().rows; ++j) {
        const long n = block.at(i, j);
        block.view().u_r[n] = stretched.block.view().u_r[n] + block.mesh().radius[i] * (1 - 1 / l.r);
        block.view().u_z[n] = stretched.block.view().u_z[n] + j * block.mesh().row_height * (1 - 1 / l.z);
      }
    const bool plane = geometry == Geometry::plane_strain;
    const auto& lanes = kernel<double>().lanes;
    std::vector<unsigned char> flags(1000);
    double largest_inverse_step = 0;
    for (int i = 0; i < block.mesh().columns(); ++i) {
      ColumnShape shape = block.shapes()[i];
      shape = {shape.width / l.r, shape.height / l.z, plane ? 1 : shape.thickness / l.hoop, shape.per_radius * l.hoop,
               shape.at_axis};
      const auto& forces = block.far_forces();
      ColumnReport one;
      kernel<double>().internal_forces(block.view(),
                                       {forces.r + block.at(i, 0), forces.z + block.at(i, 0),
                                        forces.r + block.at(i + 1, 0), forces.z + block.at(i + 1, 0), i == 0},
                                       i, {0, (block.mesh().rows + lanes - 1) / lanes * lanes}, shape,
                                       plain.solid.layers.front().material, 0, {1e30, flags.data()}, one);
      largest_inverse_step = std::max(largest_inverse_step, one.largest_inverse_step);
    }
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 0; j <= block.mesh().rows; ++j) {
        const long n = block.at(i, j);
        ASSERT_NEAR(stretched.block.far_forces().r[n], block.far_forces().r[n], 1e-11 * p.bulk()) << i << " " << j;
        ASSERT_NEAR(stretched.block.far_forces().z[n], block.far_forces().z[n], 1e-11 * p.bulk()) << i << " " << j;
      }
    EXPECT_NEAR(report.largest_inverse_step * std::sqrt(l.jacobian()), largest_inverse_step,
                1e-11 * largest_inverse_step)
        << "the density is that of the solid as it stands";
  }
}

// The same body before it was stretched, by a march of its own: its wall is moved outwards slowly, and when all is at rest a sphere dents
// it. Without erosion, viscosity or the plain march's shortcuts.
class StretchedSlowly {
 public:
  StretchedSlowly(const Problem& p, const InitialStretch& l)
      : stretch_(l), material_(constants_of(p)), block_(p, before(mesh_of(p), l), kernel<double>().lanes) {
    for (int i = 0; i < columns(); ++i)
      for (int j = 0; j <= block_.mesh().rows; ++j) block_.view().inverse_mass[block_.at(i, j)] /= l.jacobian();
  }

  // The wall moves for the first half of the time.
  void pull(double time) {
    for (double now = 0; now < time; now += step_) {
      const double share = std::min(1.0, 2 * now / time);
      for (int j = 0; j <= block_.mesh().rows; ++j) {
        block_.view().u_r[block_.at(columns(), j)] = share * (stretch_.r - 1) * block_.mesh().radius.back();
        block_.view().u_z[block_.at(columns(), j)] = share * (stretch_.z - 1) * j * block_.mesh().row_height;
      }
      move();
      for (int i = 0; i < columns(); ++i)
        for (int j = 0; j <= block_.mesh().rows; ++j)
          for (double* v : {block_.view().v_r, block_.view().v_z}) v[block_.at(i, j)] *= 1 - 0.1 * step_;
    }
    for (int i = 0; i < columns(); ++i)
      for (int j = 0; j <= block_.mesh().rows; ++j)
        for (double* v : {block_.view().v_r, block_.view().v_z}) v[block_.at(i, j)] = 0;
  }
  double thickness() const {
    const auto& mesh = block_.mesh();
    return mesh.rows * mesh.row_height + block_.view().u_z[block_.at(2, mesh.rows)] -
           block_.view().u_z[block_.at(2, 0)];
  }

  // The sphere's speed after this time, its mass given.
  double speed_after(double time, double mass) {
    double speed = 1, tip = block_.view().u_z[block_.at(0, 0)];
    for (double now = 0; now < time; now += step_) {
      move();
      speed = strike(tip - 1 + speed * step_, speed, mass);
      tip += speed * step_;
    }
    return speed;
  }

 private:
  static GradedMesh before(GradedMesh mesh, const InitialStretch& l) {
    for (double& radius : mesh.radius) radius /= l.r;
    mesh.row_height /= l.z;
    return mesh;
  }
  int columns() const { return block_.mesh().columns(); }
  void move() {
    const int lanes = kernel<double>().lanes;
    const Rows rows{0, (block_.mesh().rows + lanes) / lanes * lanes};
    step_ = 0.4 / all_internal_forces(kernel<double>(), block_, material_, 0).largest_inverse_step;
    for (int i = 0; i < columns(); ++i)
      kernel<double>().kick_and_drift(block_.view(), block_.far_forces(), i, rows, i == 0, step_, step_);
  }
  // Nodes inside are brought to the surface, the sphere is slowed down by as much.
  double strike(double centre, double speed, double mass) {
    const auto& view = block_.view();
    for (int i = 0; i < columns(); ++i)
      for (int j = 0; j <= block_.mesh().rows; ++j) {
        const long n = block_.at(i, j);
        const double x = block_.mesh().radius[i] + view.u_r[n], z = j * block_.mesh().row_height + view.u_z[n] - centre;
        const double distance = std::hypot(x, z);
        if (distance >= 1) continue;
        const double away_x = i == 0 ? 0 : x / distance, away_z = z / distance, faster = (1 - distance) / step_;
        view.v_r[n] += faster * away_x;
        view.v_z[n] += faster * away_z;
        view.u_r[n] += faster * away_x * step_;
        view.u_z[n] += faster * away_z * step_;
        speed -= faster * away_z / (view.inverse_mass[n] * mass);
      }
    return speed;
  }

  const InitialStretch stretch_;
  const MaterialConstants material_;
  Block<double> block_;
  double step_ = 0;
};

TEST(InitialStretch, ADentIsThatOfTheSameBodyStretchedSlowlyBefore) {
  Problem p = dent();
  p.linear_viscosity = p.quadratic_viscosity = 0;
  p.hourglass = 0.05;
  p.depth = 6;
  p.density_ratio = 3;
  p.end_time = 1.5;
  p.time_step_factor = 0.4;
  const double mass = 2.0 / 3 * p.density_ratio;
  p.stretch = 1.2;
  const InitialStretch l = initial_of(p);
  const ImpactResult stretched = run_impact(p, 1);
  p.stretch = 1;
  const ImpactResult slack = run_impact(p, 1);
  StretchedSlowly body(p, l);
  body.pull(400);
  EXPECT_NEAR(body.thickness(), mesh_of(p).rows * mesh_of(p).row_height, 1e-3);
  const double lost = 1 - body.speed_after(p.end_time, mass);
  EXPECT_NEAR((1 - stretched.end_speed) / lost, 1, 0.01);
  EXPECT_GT(std::abs((1 - slack.end_speed) / lost - 1), 0.05) << "which the stretch has changed";
}

TEST(InitialStretch, TheEnergyBeforeTheImpactIsTheZeroAndTheLedgerCloses) {
  Problem p = dent();
  p.stretch = 1.1;
  const auto closure = [&](double factor) {
    p.time_step_factor = factor;
    return std::abs(run_impact(p, 1).energy.closure());
  };
  const double coarse = closure(0.8), fine = closure(0.2);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_GT(std::log(coarse / fine) / std::log(4), 1.5);
}

TEST(InitialStretch, AnErodingShotClosesWithLayersRelaxationAndViscousHourglass) {
  Problem p = setting_s();
  p.stretch = 1.1;
  p.depth = 3;
  p.below = {{.depth = 40,
              .density = 1.1,
              .mu = 0.5 * p.mu(),
              .alpha = 6,
              .bulk_ratio = 60,
              .erosion_limit = 0.6,
              .stretch = 1.2}};
  p.end_time = 8;
  const ImpactResult elastic = run_impact(p, 1);
  EXPECT_LT(std::abs(elastic.energy.closure()), 3e-3);
  EXPECT_GT(elastic.eroded, 50);
  p.relaxation = PronySeries{{{0.3, 2}}};
  p.hourglass_form = HourglassForm::viscosity;
  p.hourglass = 0.1;
  EXPECT_LT(std::abs(run_impact(p, 1).energy.closure()), 5e-3);
}

// The whole strain counts.
TEST(InitialStretch, AnElementGoesWhenWhatItWasStretchedByAndWhatIsAddedReachTheLimit) {
  Problem p = stretched_specimen(1.2, Geometry::plane_strain);
  p.erosion = StrainErosion{0.5};
  for (const double added : {1.24, 1.26}) {
    StrainedTarget<> specimen(p);
    EXPECT_TRUE(take_initial_state(specimen.block, specimen.solid));
    specimen.look(0);
    specimen.stretch(added, 1 / added);
    specimen.look(0.1);
    const double half_more = 0.5 * 1.44 * (added * added - 1);  // judged half a step ahead
    EXPECT_EQ(specimen.block.view().alive[0]<0, 1.44 * added * added + half_more> 1.5 * 1.5);
    StrainedTarget<> held(p);
    held.stretch(added, 1 / added);
    held.look(0);
    EXPECT_EQ(held.look(0.1).doomed > 0, 1.2 * added > 1.5);
  }
}

TEST(InitialStretch, AShotHasTheSameBitsOnAnyNumberOfThreadsAndATautTargetIsAnother) {
  Problem p = setting_s();
  p.end_time = 8;
  const ImpactResult slack = run_impact(p, 1);
  p.stretch = 1.2;
  const ImpactResult taut = run_impact(p, 1);
  EXPECT_GT(std::abs(taut.end_speed - slack.end_speed), 0.02);
  same_bits(run_impact(p, 3), taut);
}

TEST(InitialStretch, OneThatAloneReachesALimitEndsTheRunAtOnce) {
  Problem p = setting_s();
  p.erosion = StressErosion{0.01};
  p.stretch = 1.3;
  const ImpactResult result = run_impact(p, 1);
  EXPECT_EQ(result.outcome, Outcome::unstable);
  EXPECT_EQ(result.reason, "the target's initial stretch alone reaches its limit of erosion");
  EXPECT_EQ(result.steps, 0);
}

}  // namespace
}  // namespace percal
