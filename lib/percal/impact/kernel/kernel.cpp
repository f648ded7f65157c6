#include "percal/impact/kernel/kernel.hpp"

#include "percal/math/instruction_level.hpp"

PERCAL_DECLARE_TABLES(Kernel<float>, single_kernel)
PERCAL_DECLARE_TABLES(Kernel<double>, double_kernel)

namespace percal {

template <>
const Kernel<float>& kernel<float>() {
  PERCAL_RETURN_TABLE(single_kernel)
}
template <>
const Kernel<double>& kernel<double>() {
  PERCAL_RETURN_TABLE(double_kernel)
}

}  // namespace percal
