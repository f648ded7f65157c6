#include "percal/impact/march.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "percal/impact/ledger.hpp"
#include "percal/impact/recorder.hpp"
#include "percal/impact/settings.hpp"
#include "percal/impact/state.hpp"

namespace percal {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The step of the undeformed square element at a bulk modulus, without the time-step factor.
double undeformed_step(const GradedMesh& mesh, double mu, double bulk) {
  const double width = mesh.radius[1], height = mesh.row_height;
  return 1 / std::sqrt((bulk + 4.0 / 3 * mu) * (1 / (width * width) + 1 / (height * height)));
}

MaterialConstants constants(const Problem& p, const NoErosion&, double) {
  const double wave_speed = std::sqrt(p.bulk() + 4.0 / 3 * p.mu());
  return {.mu = p.mu(),
          .bulk = p.bulk(),
          .alpha = p.alpha,
          .hourglass = p.hourglass,
          .linear_viscosity = p.linear_viscosity * wave_speed,
          .quadratic_viscosity = p.quadratic_viscosity * p.quadratic_viscosity,
          .erosion_stretch = infinite,
          .smallest_jacobian = inverted_jacobian,
          .largest_inverse_step = infinite};
}

MaterialConstants constants(const Problem& p, const StrainErosion& erosion, double first_step) {
  MaterialConstants c = constants(p, NoErosion{}, first_step);
  c.erosion_stretch = stretch_at(erosion.limit, erosion.measure);
  c.smallest_jacobian = distorted_jacobian;
  c.largest_inverse_step = 1 / (distorted_step * first_step);
  return c;
}

GradedMesh mesh_of(const Problem& p) {
  return graded_mesh({p.elements_per_radius, p.fine_width, p.graded_columns, p.width, p.depth});
}

// One run. Velocities stand half a step behind displacements until synchronise().
template <class Real, class ErosionOf, class HistoryOf>
class March {
 public:
  March(const Problem& problem, const ErosionOf& erosion, const HistoryOf& history)
      : problem_(problem),
        kernel_(kernel<Real>()),
        reference_step_(undeformed_step(mesh_of(problem), problem.mu(), reference_bulk_ratio * problem.mu())),
        first_step_(undeformed_step(mesh_of(problem), problem.mu(), problem.bulk())),
        material_(constants(problem, erosion, first_step_)),
        block_(problem, mesh_of(problem), problem.contact_stiffness / (reference_step_ * reference_step_),
               kernel_.lanes),
        doomed_(block_.view().stride),
        recorder_(history) {
    sphere_.speed = problem.speed_factor;
    sphere_.mass = 2.0 / 3 * problem.density_ratio;
    impact_energy_ = 0.5 * sphere_.mass * sphere_.speed * sphere_.speed;
    rows_moving_ = std::min(block_.mesh().rows, 2 * front_rows);
    while (contact_columns_ <= block_.mesh().columns() && block_.mesh().radius[contact_columns_] < search_radius)
      ++contact_columns_;
    result_.elements = block_.mesh().elements();
    result_.smallest_step = 1;
  }

  ImpactResult run() {
    for (;;) {
      find_internal_forces();
      find_contact_forces();
      if (has_ended()) break;
      const double step = choose_step();
      recorder_.record({time_, sphere_.tip, sphere_.speed, contact_.force});
      move(0.5 * (last_step_ + step), step);
      if (++result_.steps % front_interval == 0) extend_front();
    }
    synchronise();
    close_the_books();
    return std::move(result_);
  }

 private:
  void find_internal_forces() {
    forces_ = {};
    for (int i = 0; i < block_.mesh().columns(); ++i) {
      kernel_.internal_forces(block_.view(), i, rows_moving_, block_.shapes()[i], material_, last_step_, doomed_.data(),
                              forces_);
      for (int k = 0; k < forces_.doomed; ++k) erode(i, doomed_[k]);
    }
    viscous_work_ += forces_.viscous_work;
    result_.smallest_jacobian = std::min(result_.smallest_jacobian, forces_.smallest_jacobian);
    result_.element_steps += static_cast<double>(rows_moving_) * block_.mesh().columns();
  }

  // The energy that leaves with an element is what it stores plus what its forces, gone before the end of the last step, did
  // not do any more in that step's second half; so the books close to second order (docs/theory/impact.md, "Energy").
  void erode(int column, int row) {
    const auto energy = element_energy(block_, material_, column, row, last_step_);
    eroded_energy_ += energy.elastic + energy.hourglass + energy.last_work;
    ++result_.eroded;
    if (energy.largest_stretch < (1 - rounding_of_stretch) * material_.erosion_stretch) ++result_.distorted;
    block_.take_out(column, row, [this](int i, int j) { drop_contact(i, j); });
  }

  void drop_contact(int column, int row) {
    const auto& view = block_.view();
    const long n = block_.at(column, row);
    const double r = block_.mesh().radius[column] + view.u_r[n];
    const double z = row * block_.mesh().row_height + view.u_z[n] - sphere_.centre();
    const double distance = std::sqrt(r * r + z * z);
    if (distance >= 1 || distance == 0) return;
    const double gap = 1 - distance, stiffness = view.contact_stiffness[n];
    const double apart = (view.v_r[n] * r + (view.v_z[n] - sphere_.speed) * z) / distance;
    dropped_energy_ += 0.5 * stiffness * gap * gap + 0.5 * last_step_ * stiffness * gap * apart;
  }

  void find_contact_forces() {
    if (result_.steps % search_interval == 0) find_highest_contact_row();
    const double height = block_.mesh().row_height;
    const int row_end = std::min(rows_moving_, static_cast<int>((sphere_.tip + 1) / height) + 2);
    contact_ = {};
    for (int i = 0; i < contact_columns_; ++i)
      kernel_.sphere_contact(block_.view(), i, block_.mesh().radius[i], height, highest_contact_row_, row_end,
                             sphere_.centre(), contact_);
    result_.largest_gap = std::max(result_.largest_gap, contact_.largest_gap / height);
  }

  // The rows above are, and stay until the next search, higher than the sphere's top.
  void find_highest_contact_row() {
    const double height = block_.mesh().row_height;
    const double top = sphere_.tip - 2 - 0.25 - 4 * search_interval * first_step_;
    highest_contact_row_ = rows_moving_;
    for (int i = 0; i < contact_columns_; ++i)
      for (int j = 0; j < highest_contact_row_; ++j) {
        const long n = block_.at(i, j);
        if (block_.view().contact_stiffness[n] > 0 && j * height + block_.view().u_z[n] > top) highest_contact_row_ = j;
      }
  }

  bool has_ended() {
    result_.depth = std::max(result_.depth, sphere_.tip);
    const double speed_now = sphere_.speed - contact_.force / sphere_.mass * 0.5 * last_step_;
    if (!std::isfinite(contact_.force) || !std::isfinite(viscous_work_))
      return end(Outcome::unstable, "a force is not finite");
    if (std::is_same_v<ErosionOf, NoErosion> && result_.eroded > 0)
      return end(Outcome::unstable, "an element turned inside out");
    if (forces_.largest_inverse_step * first_step_ * collapsed_step > 1)
      return end(Outcome::unstable, "the time step collapsed");
    if (std::abs(sphere_.speed) > 10 * problem_.speed_factor)
      return end(Outcome::unstable, "the sphere is ten times faster than at impact");
    if (result_.steps >= most_steps) return end(Outcome::time_up, "");
    if (speed_now <= 0) return end(Outcome::stopped, "");
    if (sphere_.tip >= problem_.depth) return end(Outcome::passed_through, "");
    if (time_ >= problem_.end_time) return end(Outcome::time_up, "");
    return false;
  }

  bool end(Outcome outcome, const char* reason) {
    result_.outcome = outcome;
    result_.reason = reason;
    return true;
  }

  double choose_step() {
    const double of_elements = problem_.time_step_factor / std::max(forces_.largest_inverse_step, 1 / first_step_);
    // Contact springs add kappa/dt_ref^2 to a node's squared frequency.
    const double of_contact = 2 * reference_step_ / std::sqrt(problem_.contact_stiffness);
    double step = of_elements / std::sqrt(1 + (of_elements / of_contact) * (of_elements / of_contact));
    if (last_step_ > 0) step = std::min(step, step_growth * last_step_);
    result_.smallest_step = std::min(result_.smallest_step, step / (problem_.time_step_factor * first_step_));
    return step;
  }

  void move(double kick, double drift) {
    for (int i = 0; i < block_.mesh().columns(); ++i)
      kernel_.kick_and_drift(block_.view(), i, rows_moving_, kick, drift);
    sphere_.speed -= contact_.force / sphere_.mass * kick;
    sphere_.tip += sphere_.speed * drift;
    time_ += drift;
    last_step_ = drift;
  }

  // Rows join the march when the last of those that move is no longer at rest.
  void extend_front() {
    const int rows = block_.mesh().rows;
    if (rows_moving_ == rows) return;
    const auto& view = block_.view();
    for (int i = 0; i <= block_.mesh().columns(); ++i)
      for (int j = rows_moving_ - front_rows; j < rows_moving_; ++j) {
        const long n = block_.at(i, j);
        if (std::abs(view.v_r[n]) > Real(rest_speed) || std::abs(view.v_z[n]) > Real(rest_speed)) {
          rows_moving_ = std::min(rows, rows_moving_ + front_rows);
          return;
        }
      }
  }

  // Brings velocities to the time of the displacements: the second half of the last kick.
  void synchronise() { move(0.5 * last_step_, 0); }

  void close_the_books() {
    EnergyLedger energy = stored_energy(block_, material_);
    energy.particle = 0.5 * sphere_.mass * sphere_.speed * sphere_.speed;
    energy.viscosity = viscous_work_;
    energy.eroded = eroded_energy_;
    energy.contact = contact_.spring_energy;
    energy.contact_dropped = dropped_energy_;
    for (const auto& [key, share] : energy_terms) energy.*share /= impact_energy_;
    result_.energy = energy;
    result_.end_time = time_;
    result_.end_speed = sphere_.speed;
    recorder_.finish({time_, sphere_.tip, sphere_.speed, contact_.force});
    result_.history = recorder_.take();
    const bool closes = std::abs(energy.closure()) <= tolerated_energy_error;  // false for NaN
    if (result_.outcome != Outcome::unstable && !closes) end(Outcome::unstable, "energy was not conserved");
  }

  const Problem& problem_;
  const Kernel<Real>& kernel_;
  const double reference_step_, first_step_;
  const MaterialConstants material_;
  Block<Real> block_;
  Sphere sphere_;
  std::vector<int> doomed_;
  Recorder<HistoryOf> recorder_;
  ColumnReport forces_;
  SphereReport contact_;
  ImpactResult result_;
  double time_ = 0, last_step_ = 0, impact_energy_ = 0, viscous_work_ = 0, eroded_energy_ = 0, dropped_energy_ = 0;
  int rows_moving_ = 0, contact_columns_ = 0, highest_contact_row_ = 0;
};

template <class Real>
ImpactResult compose_and_run(const Problem& problem) {
  return std::visit(
      [&](const auto& erosion, const auto& history) {
        return March<Real, std::decay_t<decltype(erosion)>, std::decay_t<decltype(history)>>(problem, erosion, history)
            .run();
      },
      problem.erosion, problem.history);
}

}  // namespace

ImpactResult run_impact(const Problem& problem) {
  if (mach_number(problem) * problem.speed_factor >= 1) {
    ImpactResult refused;
    refused.outcome = Outcome::supersonic;
    return refused;
  }
  return problem.arithmetic == Arithmetic::single_precision ? compose_and_run<float>(problem)
                                                            : compose_and_run<double>(problem);
}

}  // namespace percal
