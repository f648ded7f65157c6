// A march without the shortcuts: every row moves from the first step on, contact is sought everywhere, nothing erodes. It shares the
// kernel and the rule for the step with the real one, and lets a test look at the nodes.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "impact/element_reference.hpp"
#include "percal/impact/settings.hpp"

namespace percal {

class PlainMarch {
 public:
  explicit PlainMarch(const Problem& problem)
      : problem_(problem),
        reference_step_(undeformed_step(reference_bulk_ratio * problem.mu())),
        first_step_(undeformed_step(problem.bulk())),
        block_(problem, mesh_of(problem), problem.contact_stiffness / (reference_step_ * reference_step_),
               kernel<double>().lanes) {
    material_ = constants_of(problem);
    material_.linear_viscosity = problem.linear_viscosity * std::sqrt(problem.bulk() + 4.0 / 3 * problem.mu());
    material_.quadratic_viscosity = problem.quadratic_viscosity * problem.quadratic_viscosity;
    sphere_.speed = problem.speed_factor;
    sphere_.mass = 2.0 / 3 * problem.density_ratio;
  }

  void run() {
    const auto& mesh = block_.mesh();
    double time = 0, last = 0;
    for (;;) {
      const auto forces = all_internal_forces(kernel<double>(), block_, material_, last);
      SphereReport contact;
      for (int i = 0; i <= mesh.columns(); ++i)
        kernel<double>().sphere_contact(block_.view(), i, mesh.radius[i], mesh.row_height, 0, mesh.rows + 1,
                                        sphere_.centre(), contact);
      const bool done = time >= problem_.end_time;
      double step = problem_.time_step_factor / std::max(forces.largest_inverse_step, 1 / first_step_);
      const double of_contact = 2 * reference_step_ / std::sqrt(problem_.contact_stiffness);
      step /= std::sqrt(1 + step * step / (of_contact * of_contact));
      if (last > 0) step = std::min(step, step_growth * last);
      const double kick = 0.5 * (last + (done ? 0 : step)), drift = done ? 0 : step;
      for (int i = 0; i < mesh.columns(); ++i)
        kernel<double>().kick_and_drift(block_.view(), i, mesh.rows, kick, drift);
      sphere_.speed -= contact.force / sphere_.mass * kick;
      sphere_.tip += sphere_.speed * drift;
      if (done) return;
      time += drift;
      last = drift;
    }
  }

  const Sphere& sphere() const { return sphere_; }
  // Of the block, downwards, per radian.
  double block_momentum() const {
    double sum = 0;
    for (int i = 0; i <= block_.mesh().columns(); ++i)
      for (int j = 0; j <= block_.mesh().rows; ++j) sum += block_.mass(i, j) * block_.view().v_z[block_.at(i, j)];
    return sum;
  }

 private:
  double undeformed_step(double bulk) const {
    const double width = mesh_of(problem_).radius[1], height = mesh_of(problem_).row_height;
    return 1 / std::sqrt((bulk + 4.0 / 3 * problem_.mu()) * (1 / (width * width) + 1 / (height * height)));
  }

  const Problem problem_;
  const double reference_step_, first_step_;
  Block<double> block_;
  MaterialConstants material_;
  Sphere sphere_;
};

}  // namespace percal
