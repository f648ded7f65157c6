// The solver's bits, pinned. Evaluations are kept for ever under a key with solver_version in it: were the bits to
// change and the version not, old depths would be served as new ones.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "impact/element_reference.hpp"
#include "impact/polygons.hpp"
#include "impact/setting_s.hpp"
#include "percal/base/version.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/solid/march/march.hpp"
#include "percal/text/sha256.hpp"
#include "solid/solid_problems.hpp"
#include "support/sanitized.hpp"

#if defined(__GLIBC__)
#include <gnu/libc-version.h>
#endif

namespace percal {
namespace {

constexpr const char* what_to_do =
    "The solver's bits have changed. Where nobody meant to, that is an error. Where it was meant: raise\n"
    "solver_version (solid_version of a block) in lib/percal/base/version.hpp, run `impact_test "
    "--gtest_filter=*PinnedSolver*` on a\n"
    "processor that has all levels, and in tests/impact/pinned_solver_test.cpp write the version into\n"
    "pinned_version (pinned_solid_version) and the lines that it prints into pinned_bits.";

constexpr int pinned_version = 5, pinned_solid_version = 1;

constexpr double scatter = 0.05;  // of a depth from level to level, by what erodes a step earlier or later

// Of each run below, in their order, the first digits of the SHA-256 of all its numbers. By GCC 12 and glibc 2.36.
using Bits = std::vector<std::string>;
const std::map<std::string, Bits> pinned_bits{
    {"x86_64_v2",
     {"e9d8243e50ae3cd4", "ddd74fd555539e03", "e234b979dcbd9805", "d006ae8126df0606", "d5c4240a288a533f",
      "7d38fe8dee815acb", "d1bfe92f42678b72", "cd36cbaaee547f0f", "653e161b5894e1c8"}},
    {"x86_64_v3",
     {"df283a9c6706aa8b", "1b523c871618a0d2", "3a1e7a06aee333aa", "b3f0623b831e60a9", "7a70581c34d1b446",
      "d3a4f180424b3786", "a4fde2607f98565a", "c73920c912ffd273", "43c3d3e8706afd45"}},
    {"x86_64_v4",
     {"850eb72640defa90", "0000dae709f0c5da", "49cc792f148958f4", "055fb7f870f271d5", "597b30b79175bcdf",
      "8c07a86d5feb1df5", "ac88895fa30870de", "ef79341fc3f7bf72", "7a4fe989a2792d5d"}},
};

struct PinnedRun {
  std::string name;
  Problem problem;
  double depth;  // radii
};

Problem short_impact(Arithmetic arithmetic) {
  Problem p = setting_s(6);
  p.depth = 15;
  p.end_time = 8;
  p.arithmetic = arithmetic;
  return p;
}

Problem rotating_prism() {
  Problem p = prism_impact(turned(square_on_its_corner(), 0.3));
  p.end_time = 5;
  std::get<RigidPolygon>(p.particle).free_rotation = true;
  return p;
}

// A body of revolution with a blunt tip.
Problem cone() {
  Problem p = short_impact(Arithmetic::double_precision);
  p.end_time = 4;
  p.particle = RigidPolygon{.vertices = {{-0.3, -0.8}, {0.3, -0.8}, {1, 0.6}, {-1, 0.6}}, .mass = 8};
  return p;
}

Problem layers() {
  Problem p = short_impact(Arithmetic::single_precision);
  p.volumetric_law = VolumetricLaw::logarithmic;
  p.depth = 2.3;
  p.below = {{.depth = 1.4, .density = 1.2, .mu = 2 * p.mu(), .alpha = 4, .bulk_ratio = 30, .erosion_limit = 0.5},
             {.depth = 12, .density = 0.9, .mu = p.mu(), .alpha = -3, .bulk_ratio = 60, .erosion_limit = 0.8}};
  return p;
}

Problem relaxation() {
  Problem p = short_impact(Arithmetic::double_precision);
  p.end_time = 4;
  p.relaxation = PronySeries{{{0.3, 0.4}, {0.25, 3}}};
  p.hourglass_form = HourglassForm::viscosity;
  p.erosion = EnergyErosion{1};
  return p;
}

Problem elastic_particle() {
  Problem p = short_impact(Arithmetic::single_precision);
  p.end_time = 3;
  p.particle = ElasticSphere{186, 0.42};
  p.history_samples = 10;
  return p;
}

// In three dimensions, aslant and with a history.
Problem block() {
  Problem p = block_setting_s();
  p.whole = true;
  p.block.angle = 0.4;
  p.block.fine_depth = 8;
  p.end_time = 4;
  p.history_samples = 10;
  return p;
}

Problem block_prism() {
  Problem p = block_setting_s(3);
  p.particle =
      RigidPolygon{.vertices = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}}, .mass = 40, .inertia = 10, .half_thickness = 0.7};
  p.end_time = 4;
  p.arithmetic = Arithmetic::double_precision;
  return p;
}

ImpactResult result_of(const Problem& problem, int threads = 1) {
  return problem.geometry == Geometry::block ? run_solid(problem, threads) : run_impact(problem, threads);
}

std::vector<PinnedRun> pinned_runs() {
  return {{"sphere to its end, single", setting_s(5), 27.7},
          {"sphere, double", short_impact(Arithmetic::double_precision), 7.27},
          {"prism", rotating_prism(), 4.01},
          {"profile", cone(), 3.83},
          {"layers", layers(), 7.23},
          {"relaxation", relaxation(), 3.78},
          {"elastic particle", elastic_particle(), 2.89},
          {"block", block(), 3.5},
          {"prism in a block", block_prism(), 3.69}};
}

std::string numbers_of(const EnergyLedger& energy) {
  std::string text;
  for (const auto& [key, share, words] : energy_terms)
    if (share != &EnergyLedger::friction)
      text += fmt::format(" {:a}", energy.*share);  // of which none of these runs has any
  return text;
}

// All that a run says but for its processor time.
std::string digest_of(const ImpactResult& r) {
  std::string text = fmt::format("{} {:a} {:a} {:a} {:a} {:a} {:a} {} {} {:a} {} {} {:a} {:a}", word(r.outcome),
                                 r.depth, r.end_time, r.end_speed, r.sideways, r.turn, r.target_momentum, r.elements,
                                 r.steps, r.element_steps, r.eroded, r.distorted, r.smallest_jacobian, r.smallest_step);
  text += numbers_of(r.energy);
  for (const HistoryPoint& point : r.history)
    text +=
        fmt::format(" {:a} {:a} {:a} {:a}", point.time, point.tip, point.speed, point.force) + numbers_of(point.energy);
  return sha256(text).substr(0, 16);
}

// Why this is not the build whose bits are pinned; empty where it is.
std::string other_build() {
#if defined(__clang__) || !defined(__GNUC__) || __GNUC__ != 12
  return "another compiler than GCC 12";
#elif !defined(NDEBUG)
  return "a build with assertions";
#elif defined(PERCAL_SANITIZED)
  return "a build with sanitizers";
#elif defined(__FMA__) || defined(__FAST_MATH__)
  return "a build with compiler flags of its own";
#endif
#if defined(__GLIBC__)
  const std::string library = gnu_get_libc_version();
  return library == "2.36" ? "" : "glibc " + library;
#else
  return "another C library than glibc 2.36";
#endif
}

class PinnedSolver : public testing::TestWithParam<std::string> {
 protected:
  const std::string& level() const { return GetParam(); }
  bool is_lacking() const {
    for (const auto& kernels : kernels_here())
      if (kernels.level == level()) return false;
    return true;
  }
  // This same test in a process of its own, where the level can still be chosen. Returns whether it passed.
  bool passes_on_its_level() const {
    const std::string only = "--gtest_filter=*PinnedSolver.KeepsItsBits/" + level();
    const pid_t child = fork();
    if (child == 0) {
      setenv("PERCAL_ISA", level().c_str(), 1);
      execl("/proc/self/exe", "impact_test", only.c_str(), "--gtest_brief=1", nullptr);
      _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
};

TEST_P(PinnedSolver, KeepsItsBits) {
  if (is_lacking()) GTEST_SKIP() << "this processor lacks " << level();
  if (level() != instruction_level()) {
    EXPECT_TRUE(passes_on_its_level()) << "said above";
    return;
  }
  Bits found;
  for (const auto& [name, problem, depth] : pinned_runs()) {
    const ImpactResult result = result_of(problem);
    EXPECT_NE(result.outcome, Outcome::unstable) << name << ": " << result.reason;
    EXPECT_NEAR(result.depth / depth, 1, scatter) << name;
    found.push_back(digest_of(result));
    for (const int threads : {2, 7})
      EXPECT_EQ(digest_of(result_of(problem, threads)), found.back()) << name << ", " << threads << " threads";
  }
  const auto pinned = pinned_bits.find(level());
  const std::string other = pinned == pinned_bits.end() ? "level " + level() : other_build();
  if (!other.empty()) {
    std::cout << other << ", whose bits are not pinned: depths alone were compared\n";
    return;
  }
  EXPECT_EQ(found, pinned->second) << what_to_do << "\n"
                                   << fmt::format("    {{\"{}\", {{\"{}\"}}}},", level(), fmt::join(found, "\", \""));
}
#if defined(__x86_64__)
INSTANTIATE_TEST_SUITE_P(Levels, PinnedSolver, testing::Values("x86_64_v2", "x86_64_v3", "x86_64_v4"),
                         [](const auto& level) { return level.param; });
#else
INSTANTIATE_TEST_SUITE_P(Levels, PinnedSolver, testing::Values("generic"),
                         [](const auto& level) { return level.param; });
#endif

TEST(PinnedSolverVersion, IsTheOneThatThePinnedBitsBelongTo) {
  EXPECT_EQ(std::pair(pinned_version, pinned_solid_version), std::pair(solver_version, solid_version))
      << "solver_version was raised: run `impact_test --gtest_filter=*PinnedSolver*` and write version and bits into "
         "tests/impact/pinned_solver_test.cpp";
}

}  // namespace
}  // namespace percal
