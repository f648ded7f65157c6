#include "percal/solid/kernel/kernel.hpp"

#include <stdexcept>
#include <string>

// Every level that impact/kernel/kernel.cpp may choose.
#if defined(__x86_64__)
#define PERCAL_EACH_LEVEL(of) of(x86_64_v2) of(x86_64_v3) of(x86_64_v4)
#else
#define PERCAL_EACH_LEVEL(of) of(generic)
#endif
#define PERCAL_DECLARE_LEVEL(level)                     \
  namespace percal::level {                             \
  extern const SolidKernel<float> single_solid_kernel;  \
  extern const SolidKernel<double> double_solid_kernel; \
  }
PERCAL_EACH_LEVEL(PERCAL_DECLARE_LEVEL)

namespace percal {

template <>
const SolidKernel<float>& solid_kernel<float>() {
#define PERCAL_TAKE_LEVEL(level) \
  if (instruction_level() == #level) return level::single_solid_kernel;
  PERCAL_EACH_LEVEL(PERCAL_TAKE_LEVEL)
#undef PERCAL_TAKE_LEVEL
  throw std::logic_error("no kernel of the instruction level " + instruction_level());
}
template <>
const SolidKernel<double>& solid_kernel<double>() {
#define PERCAL_TAKE_LEVEL(level) \
  if (instruction_level() == #level) return level::double_solid_kernel;
  PERCAL_EACH_LEVEL(PERCAL_TAKE_LEVEL)
#undef PERCAL_TAKE_LEVEL
  throw std::logic_error("no kernel of the instruction level " + instruction_level());
}

}  // namespace percal
