#include "percal/impact/kernel/kernel.hpp"

#include <array>
#include <cstdlib>

#include "percal/base/error.hpp"

#define PERCAL_DECLARE_LEVEL(level)          \
  namespace percal::level {                  \
  extern const Kernel<float> single_kernel;  \
  extern const Kernel<double> double_kernel; \
  }
#if defined(__x86_64__)
PERCAL_DECLARE_LEVEL(x86_64_v2)
PERCAL_DECLARE_LEVEL(x86_64_v3)
PERCAL_DECLARE_LEVEL(x86_64_v4)
#else
PERCAL_DECLARE_LEVEL(generic)
#endif

namespace percal {
namespace {

struct Level {
  std::string name;
  bool supported;
  const Kernel<float>* single_kernel;
  const Kernel<double>* double_kernel;
};

#if defined(__x86_64__)
std::array<Level, 3> levels() {
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                  __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512vl");
  return {Level{"x86_64_v4", v4, &x86_64_v4::single_kernel, &x86_64_v4::double_kernel},
          Level{"x86_64_v3", v3, &x86_64_v3::single_kernel, &x86_64_v3::double_kernel},
          Level{"x86_64_v2", true, &x86_64_v2::single_kernel, &x86_64_v2::double_kernel}};
}
#else
std::array<Level, 1> levels() { return {Level{"generic", true, &generic::single_kernel, &generic::double_kernel}}; }
#endif

Level choose() {
  const char* wanted = std::getenv("PERCAL_ISA");
  std::string known;
  for (const Level& level : levels()) {
    if (!wanted || !*wanted) {
      if (level.supported) return level;
    } else if (level.name == wanted) {
      if (!level.supported) throw BadInput({"environment", 0, "PERCAL_ISA"}, wanted, "a level that this processor has");
      return level;
    }
    known += (known.empty() ? "" : ", ") + level.name;
  }
  throw BadInput({"environment", 0, "PERCAL_ISA"}, wanted ? wanted : "", known);
}

const Level& chosen() {
  static const Level level = choose();
  return level;
}

}  // namespace

const std::string& instruction_level() { return chosen().name; }
template <>
const Kernel<float>& kernel<float>() {
  return *chosen().single_kernel;
}
template <>
const Kernel<double>& kernel<double>() {
  return *chosen().double_kernel;
}

}  // namespace percal
