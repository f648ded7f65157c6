#include "percal/observe/history.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <numbers>

namespace percal {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::vector<HistoryPoint> two_points{{0, 0, 1, 0, {.particle = 1}},
                                           {2, 1.5, 0.5, 0.25, {.particle = 0.25, .eroded = 0.5}}};
const Scales impact_scales{.radius = 1e-3, .speed = 100, .target_density = 1200};
constexpr double pressure = 1200 * 1e4;  // rho_t v^2, Pa

const std::string energies =
    "energy_particle,energy_particle_elastic,energy_live_kinetic,energy_freed_mass,energy_elastic,energy_hourglass,"
    "energy_viscosity,energy_relaxation,energy_eroded,energy_collisions,energy_friction,energy_sum";

Problem in_plane_strain(bool whole) {
  Problem problem;
  problem.geometry = Geometry::plane_strain;
  problem.whole = whole;
  return problem;
}

TEST(History, IsInSiAndItsCsvNamesTheUnits) {
  const std::string csv = history_csv(two_points, Problem{}, impact_scales);
  EXPECT_THAT(csv, StartsWith("time_s,tip_m,speed_m_s,force_N," + energies + "\n0,0,100,0,1,0,0,0,0,0,0,0,0,0,0,1\n"));
  EXPECT_THAT(csv, HasSubstr("\n2e-05,0.0015,50,18.8495559,0.25,0,0,0,0,0,0,0,0.5,0,0,0.75\n"));
  EXPECT_EQ(history_csv({}, Problem{}, {}), "time_s,tip_m,speed_m_s,force_N," + energies + "\n");
}

TEST(History, HasTheSameColumnsAsJson) {
  const auto json = history_to_json(two_points, Problem{}, impact_scales);
  EXPECT_EQ(json.size(), 5u);
  EXPECT_EQ(json.at("tip_m"), (std::vector<double>{0, 1.5e-3}));
  EXPECT_EQ(json.at("speed_m_s"), (std::vector<double>{100, 50}));
  EXPECT_NEAR(json.at("time_s")[1], 2e-5, 1e-13);
  EXPECT_EQ(json.at("energy").size(), std::size(energy_terms) + 1);
  EXPECT_EQ(json.at("energy").at("eroded"), (std::vector<double>{0, 0.5}));
  EXPECT_EQ(json.at("energy").at("sum"), (std::vector<double>{1, 0.75}));
}

TEST(History, TheForceIsThatOnTheWholeParticle) {
  const double force = 0.25;
  const auto of = [](const Problem& problem, const char* key) {
    return history_to_json(two_points, problem, impact_scales).at(key)[1].get<double>();
  };
  EXPECT_NEAR(of(Problem{}, "force_N") / (force * 2 * std::numbers::pi * pressure * 1e-6), 1, 1e-12) << "per radian";
  EXPECT_NEAR(of(in_plane_strain(true), "force_N_per_m") / (force * pressure * 1e-3), 1, 1e-12);
  EXPECT_NEAR(of(in_plane_strain(false), "force_N_per_m") / (2 * force * pressure * 1e-3), 1, 1e-12)
      << "the other half is its mirror image";
  EXPECT_THAT(history_csv(two_points, in_plane_strain(true), impact_scales), HasSubstr(",force_N_per_m,"));
}

}  // namespace
}  // namespace percal
