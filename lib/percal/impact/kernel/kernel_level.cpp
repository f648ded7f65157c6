// The kernel for one instruction level: compiled once for each, with PERCAL_LEVEL naming it (cmake/PercalKernel.cmake).
#include "percal/impact/kernel/contact_and_motion.hpp"
#include "percal/impact/kernel/held_energy.hpp"
#include "percal/impact/kernel/weighted_sum.hpp"

namespace percal::PERCAL_LEVEL {

template <class Real>
constexpr Kernel<Real> table_of_functions{internal_forces<Real>,
                                          internal_forces_averaged<Real>,
                                          internal_forces_general<Real>,
                                          nodes_in_sphere<Real>,
                                          nodes_in_polygon<Real>,
                                          kick_and_drift<Real>,
                                          weighted_sum<Real>,
                                          kinetic_energy<Real>,
                                          stored_energy<Real>,
                                          Lane<typename VectorOf<Real>::type>::count};

extern const Kernel<float> single_kernel;
extern const Kernel<double> double_kernel;
const Kernel<float> single_kernel = table_of_functions<float>;
const Kernel<double> double_kernel = table_of_functions<double>;

}  // namespace percal::PERCAL_LEVEL
