#include "percal/math/instruction_level.hpp"

#include <cstdlib>
#include <vector>

#include "percal/base/error.hpp"

namespace percal {
namespace {

struct Level {
  std::string name;
  bool supported;
};

// The best first.
std::vector<Level> levels() {
#if defined(__x86_64__)
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                  __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512vl");
  return {{"x86_64_v4", v4}, {"x86_64_v3", v3}, {"x86_64_v2", true}};
#else
  return {{"generic", true}};
#endif
}

std::string choose() {
  const char* wanted = std::getenv("PERCAL_ISA");
  std::string known;
  for (const Level& level : levels()) {
    if (!wanted || !*wanted) {
      if (level.supported) return level.name;
    } else if (level.name == wanted) {
      if (!level.supported) throw BadInput({"environment", 0, "PERCAL_ISA"}, wanted, "a level that this processor has");
      return level.name;
    }
    known += (known.empty() ? "" : ", ") + level.name;
  }
  throw BadInput({"environment", 0, "PERCAL_ISA"}, wanted ? wanted : "", known);
}

}  // namespace

const std::string& instruction_level() {
  static const std::string level = choose();
  return level;
}

}  // namespace percal
