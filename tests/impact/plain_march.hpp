// A march without the shortcuts, at one rate: every row moves from the first step on, contact is sought everywhere, and which
// elements go is judged here, element by element. It shares the kernel's forces and the rule for the step with the real one.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "impact/element_reference.hpp"
#include "percal/impact/particle/particle.hpp"
#include "percal/impact/settings.hpp"

namespace percal {

// Largest squared principal stretch of an element, the hoop's included.
inline double largest_squared_stretch(const Block<double>& block, int column, int row) {
  const auto& shape = block.shapes()[column];
  scalar::Gradient<double> F{1, 0, 0, 1, 1};
  for (int a = 0; a < 4; ++a) {
    const long n = block.at(column + corner_column[a], row + corner_row[a]);
    const double ur = block.view().u_r[n], uz = block.view().u_z[n];
    F.rr += along_r[a] * ur / shape.width;
    F.rz += along_z[a] * ur / shape.height;
    F.zr += along_r[a] * uz / shape.width;
    F.zz += along_z[a] * uz / shape.height;
    F.hoop += ur * shape.per_radius / 4;
  }
  return std::max(scalar::stretches(F).first2, F.hoop * F.hoop);
}

class PlainMarch {
 public:
  explicit PlainMarch(const Problem& problem)
      : problem_(problem),
        first_step_(undeformed_step(problem.bulk())),
        block_(problem, mesh_of(problem), kernel<double>().lanes),
        last_stretch2_(static_cast<std::size_t>(block_.mesh().columns()) * block_.view().stride, 1.0),
        speed_(problem.speed_factor),
        mass_(2.0 / 3 * problem.density_ratio) {
    material_ = constants_of(problem);
    material_.linear_viscosity = problem.linear_viscosity * std::sqrt(problem.bulk() + 4.0 / 3 * problem.mu());
    material_.quadratic_viscosity = problem.quadratic_viscosity * problem.quadratic_viscosity;
  }

  void run() {
    const auto& mesh = block_.mesh();
    const auto& lanes = kernel<double>().lanes;
    const Rows rows{0, (mesh.rows + lanes) / lanes * lanes};
    double time = 0, last = 0;
    for (;;) {
      erode();
      const auto forces = all_internal_forces(kernel<double>(), block_, material_, last);
      const bool done = time >= problem_.end_time;
      double step = problem_.time_step_factor / std::max(forces.largest_inverse_step, 1 / first_step_);
      if (last > 0) step = std::min(step, step_growth * last);
      const double kick = 0.5 * (last + (done ? 0 : step)), drift = done ? 0 : step;
      for (int i = 0; i < mesh.columns(); ++i)
        kernel<double>().kick_and_drift(block_.view(), block_.far_forces(), i, rows, i == 0, kick, drift);
      if (done) return stay_together();
      keep_nodes_out(drift);
      tip_ += speed_ * drift;
      time += drift;
      last = drift;
    }
  }

  double speed() const { return speed_; }
  double tip() const { return tip_; }
  long eroded() const { return eroded_; }

 private:
  double undeformed_step(double bulk) const {
    const double width = mesh_of(problem_).radius[1], height = mesh_of(problem_).row_height;
    return 1 / std::sqrt((bulk + 4.0 / 3 * problem_.mu()) * (1 / (width * width) + 1 / (height * height)));
  }

  // One node that has to part from the sphere along (x, z), of length 1 but on the axis, at `rate`, over what it does now.
  struct Touching {
    long node;
    double mass, rate, x, z;
    double heavy() const { return mass / (x * x + z * z); }
  };

  // The least impulses that do it, and the sphere as much in all: who needs none once it has slowed down is struck off.
  void part(double drift) {
    double slower = 0;
    for (bool found = true; found;) {
      double sum = 0, mass = mass_;
      for (const Touching& node : touching_) {
        sum += node.heavy() * node.z * node.rate;
        mass += node.heavy() * node.z * node.z;
      }
      slower = sum / mass;
      found = std::erase_if(touching_, [&](const Touching& node) { return node.rate <= slower * node.z; }) > 0;
    }
    const auto& view = block_.view();
    for (const Touching& node : touching_) {
      const double faster = (node.rate - slower * node.z) * node.heavy() / node.mass;
      view.v_r[node.node] += faster * node.x;
      view.v_z[node.node] += faster * node.z;
      view.u_r[node.node] += faster * node.x * drift;
      view.u_z[node.node] += faster * node.z * drift;
    }
    speed_ -= slower;
  }

  // Nodes that this step would leave inside the sphere are kept at its surface.
  void keep_nodes_out(double drift) {
    touching_.clear();
    const double centre = tip_ - 1 + speed_ * drift;
    for (int i = 0; i <= block_.mesh().columns(); ++i)
      for (int j = 0; j <= block_.mesh().rows; ++j) {
        const long n = block_.at(i, j);
        const double x = block_.mesh().radius[i] + block_.view().u_r[n];
        const double z = j * block_.mesh().row_height + block_.view().u_z[n] - centre, distance = std::hypot(x, z);
        if (distance < 1 && block_.view().touchable[n] > 0)
          touching_.push_back({n, block_.mass(i, j), (1 - distance) / drift, i == 0 ? 0 : x / distance, z / distance});
      }
    part(drift);
  }

  // Half a kick alone has moved velocities: nodes that pushed in the last step stay with the sphere.
  void stay_together() {
    for (Touching& node : touching_)
      node.rate = node.z * speed_ - node.x * block_.view().v_r[node.node] - node.z * block_.view().v_z[node.node];
    std::erase_if(touching_, [&](const Touching& node) { return !(block_.view().touchable[node.node] > 0); });
    part(0);
  }

  // An element goes when its largest stretch would pass the limit within the next half step, at the pace of the last one.
  void erode() {
    const auto* erosion = std::get_if<StrainErosion>(&problem_.erosion);
    if (!erosion) return;
    const double limit = stretch_at(erosion->limit, erosion->measure);
    for (int i = 0; i < block_.mesh().columns(); ++i)
      for (int j = 0; j < block_.mesh().rows; ++j) {
        if (!(block_.view().alive[block_.at(i, j)] > 0)) continue;
        const double now = largest_squared_stretch(block_, i, j), before = last_stretch2_[block_.at(i, j)];
        last_stretch2_[block_.at(i, j)] = now;
        if (now + (now - before) / 2 <= limit * limit) continue;
        block_.take_out(i, j, false);
        ++eroded_;
      }
  }

  const Problem problem_;
  const double first_step_;
  Block<double> block_;
  std::vector<double> last_stretch2_;
  std::vector<Touching> touching_;  // of the last step
  MaterialConstants material_;
  double speed_, mass_, tip_ = 0;
  long eroded_ = 0;
};

}  // namespace percal
