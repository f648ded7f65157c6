#include "percal/invert/kernel/kernel.hpp"

#include "percal/math/instruction_level.hpp"

PERCAL_DECLARE_TABLES(EmulatorKernel, the_emulator_kernel)

namespace percal {

const EmulatorKernel& emulator_kernel() { PERCAL_RETURN_TABLE(the_emulator_kernel) }

}  // namespace percal
