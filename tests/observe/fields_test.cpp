#include "percal/observe/fields.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <set>

#include "observe/crater.hpp"
#include "observe/vtu_reader.hpp"
#include "percal/base/error.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/text/file.hpp"

namespace percal {
namespace {

using test::crater;
using test::scales;
namespace fs = std::filesystem;
const double pressure_unit = 1100.0 * 300 * 300;

class Fields : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder); }
  void TearDown() override { fs::remove_all(folder); }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
    return names;
  }
  VtuReader read(const std::string& name) const { return VtuReader(read_file((folder / name).string())); }
  const fs::path folder = fs::path(testing::TempDir()) / ("percal_fields_" + std::to_string(getpid()));
};

TEST_F(Fields, EachFrameIsTwoFilesAndTheListNamesThemWithTheirTimes) {
  FieldSeries series(folder.string(), "gold", EveryTime{1.5 * 2e-6 / 300}, crater(), scales);
  run_impact(crater(), series);
  EXPECT_EQ(series.frames(), 5u) << "at 0, 1.5, 3, 4.5 and the end, 5";
  EXPECT_EQ(files().size(), 11u);
  const std::string list = read_file(series.list());
  EXPECT_EQ(fs::path(series.list()).filename(), "gold.pvd");
  EXPECT_THAT(list, testing::HasSubstr("<DataSet timestep=\"0\" part=\"0\" file=\"target_0000.vtu\"/>"));
  EXPECT_THAT(list, testing::HasSubstr("part=\"1\" file=\"particle_0004.vtu\"/>"));
}

TEST_F(Fields, AreInSi) {
  struct Last : FrameObserver {
    bool is_due(const Moment&) override { return false; }
    void see(const Frame& seen) override { frame = seen; }
    Frame frame;
  } last;
  const ImpactResult result = run_impact(crater(), last);
  FieldSeries series(folder.string(), "x", EverySteps{1}, crater(), scales);
  series.see(last.frame);
  const VtuReader target = read("target_0000.vtu"), particle = read("particle_0000.vtu");
  const TargetPiece& piece = last.frame.target;

  const auto points = target.array<double>("Points", "Float64");
  const auto displacement = target.array<float>("displacement", "Float32");
  const auto velocity = target.array<float>("velocity", "Float32");
  const auto stretches = target.array<float>("principal_stretches", "Float32");
  const auto stress = target.array<float>("stress", "Float32");
  const auto pressure = target.array<float>("pressure", "Float32");
  const auto mises = target.array<float>("von_mises_stress", "Float32");
  const auto density = target.array<float>("energy_density", "Float32");
  const auto volume = target.array<float>("undeformed_volume", "Float32");
  const auto eroded = target.array<std::uint8_t>("eroded", "UInt8");
  ASSERT_EQ(points.size(), 3 * piece.position.size());
  ASSERT_EQ(stress.size(), 6 * piece.states.size());
  for (std::size_t n = 0; n < piece.position.size(); n += 17)
    for (int d = 0; d < 2; ++d) {
      EXPECT_DOUBLE_EQ(points[3 * n + d], piece.position[n][d] * 2e-6);
      EXPECT_FLOAT_EQ(displacement[3 * n + d], static_cast<float>(piece.displacement[n][d] * 2e-6));
      EXPECT_FLOAT_EQ(velocity[3 * n + d], static_cast<float>(piece.velocity[n][d] * 300));
      EXPECT_EQ(points[3 * n + 2], 0);
    }
  double elastic = 0;
  for (std::size_t k = 0; k < piece.states.size(); ++k) {
    const auto& s = piece.states[k].stress;
    for (int i = 0; i < 4; ++i) EXPECT_FLOAT_EQ(stress[6 * k + i], static_cast<float>(s[i] * pressure_unit));
    EXPECT_EQ(stress[6 * k + 4], 0);
    EXPECT_FLOAT_EQ(pressure[k], static_cast<float>(-(s[0] + s[1] + s[2]) / 3 * pressure_unit));
    EXPECT_GE(stretches[3 * k], stretches[3 * k + 1]);
    EXPECT_GE(stretches[3 * k + 1], stretches[3 * k + 2]);
    EXPECT_EQ(eroded[k], piece.eroded[k]);
    if (eroded[k] == 1) {
      EXPECT_EQ(mises[k], 0);
    }
    elastic += double(density[k]) * volume[k];
  }
  const double impact_energy = 0.5 * 4 / 3 * std::numbers::pi * 8e-18 * 16.8 * 1100 * 300 * 300;  // of the whole sphere
  EXPECT_NEAR(elastic / impact_energy, result.energy.elastic, 1e-6);
  EXPECT_EQ(std::count(eroded.begin(), eroded.end(), 1), result.eroded);

  const auto ball = particle.array<double>("Points", "Float64");
  double lowest = 0;
  for (std::size_t n = 1; n < ball.size(); n += 3) lowest = std::min(lowest, ball[n]);
  EXPECT_NEAR(lowest, -result.depth * 2e-6, 1e-3 * 2e-6);
  EXPECT_THROW(particle.array<float>("stress", "Float32"), std::runtime_error) << "a rigid one has none";
}

TEST_F(Fields, ASimpleShearHasVonMisesStressOfRootThreeTimesTheShear) {
  Frame frame;
  frame.target.position = {{0, -1}, {1, -1}, {1, 0}, {0, 0}};
  frame.target.displacement = frame.target.velocity = frame.target.position;
  frame.target.corners = {0, 1, 2, 3};
  frame.target.ends = {4};
  frame.target.states = {CellState{.stress = {0, 0, 0, -0.5}}};
  frame.target.eroded = {0};
  frame.target.layer = {0};
  frame.target.volume = {1};
  Problem plane;
  plane.geometry = Geometry::plane_strain;
  const VtuReader file(vtu_text(target_fields(frame, plane, scales)));
  EXPECT_FLOAT_EQ(file.array<float>("von_mises_stress", "Float32")[0], float(std::sqrt(3.0) * 0.5 * pressure_unit));
  EXPECT_FLOAT_EQ(file.array<float>("undeformed_volume", "Float32")[0], 4e-12f) << "of a metre's thickness";
}

TEST_F(Fields, AShorterSeriesLeavesNothingOfTheOneBeforeButForeignFiles) {
  run_impact(crater(), *std::make_unique<FieldSeries>(folder.string(), "x", EveryTime{2e-6 / 300}, crater(), scales));
  EXPECT_EQ(files().size(), 13u);
  write_file((folder / "target_0001.vtu.txt").string(), "mine");
  FieldSeries series(folder.string(), "x", EveryTime{1}, crater(), scales);
  EXPECT_EQ(files(), (std::set<std::string>{"target_0001.vtu.txt"}));
  run_impact(crater(), series);
  EXPECT_EQ(files().size(), 6u);
}

TEST_F(Fields, AFullDiskEndsTheRunAndTheListNamesOnlyWhatIsWhole) {
  FieldSeries series(folder.string(), "x", EveryTime{2e-6 / 300}, crater(), scales);
  struct Fills : FrameObserver {
    explicit Fills(FieldSeries& s) : series(s) {}
    bool is_due(const Moment& now) override { return series.is_due(now); }
    void see(const Frame& frame) override {
      if (series.frames() == 2) fs::create_directory(fs::path(series.list()).parent_path() / "particle_0002.vtu");
      series.see(frame);
    }
    FieldSeries& series;
  } fills(series);
  EXPECT_THROW(run_impact(crater(), fills), IoFailure);
  const std::string list = read_file(series.list());
  EXPECT_THAT(list, testing::HasSubstr("target_0001.vtu"));
  EXPECT_THAT(list, testing::Not(testing::HasSubstr("target_0002.vtu")));
  EXPECT_THROW(FieldSeries("/proc/nowhere", "x", EverySteps{1}, crater(), scales), IoFailure);
}

}  // namespace
}  // namespace percal
