// The kernel for one instruction level: compiled once for each, with PERCAL_LEVEL naming it (cmake/PercalKernel.cmake).
#include "percal/solid/kernel/forces_and_motion.hpp"

namespace percal::PERCAL_LEVEL {

template <class Real>
constexpr SolidKernel<Real> table_of_solid_functions{hex::internal_forces<Real>,
                                                     hex::internal_forces_layered<Real>,
                                                     hex::nodes_in_sphere<Real>,
                                                     hex::nodes_in_polyhedron<Real>,
                                                     hex::kick_and_drift<Real>,
                                                     hex::stored_energy<Real>,
                                                     Lane<typename VectorOf<Real>::type>::count};

extern const SolidKernel<float> single_solid_kernel;
extern const SolidKernel<double> double_solid_kernel;
const SolidKernel<float> single_solid_kernel = table_of_solid_functions<float>;
const SolidKernel<double> double_solid_kernel = table_of_solid_functions<double>;

}  // namespace percal::PERCAL_LEVEL
