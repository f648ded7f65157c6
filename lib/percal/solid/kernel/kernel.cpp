#include "percal/solid/kernel/kernel.hpp"

#include "percal/math/instruction_level.hpp"

PERCAL_DECLARE_TABLES(SolidKernel<float>, single_solid_kernel)
PERCAL_DECLARE_TABLES(SolidKernel<double>, double_solid_kernel)

namespace percal {

template <>
const SolidKernel<float>& solid_kernel<float>() {
  PERCAL_RETURN_TABLE(single_solid_kernel)
}
template <>
const SolidKernel<double>& solid_kernel<double>() {
  PERCAL_RETURN_TABLE(double_solid_kernel)
}

}  // namespace percal
