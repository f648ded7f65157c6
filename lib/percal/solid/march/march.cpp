#include "percal/solid/march/march.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "percal/impact/march/course.hpp"
#include "percal/impact/march/layer_speeds.hpp"
#include "percal/impact/march/recorder.hpp"
#include "percal/impact/settings.hpp"
#include "percal/impact/target/constants.hpp"
#include "percal/solid/march/contact_zone.hpp"
#include "percal/solid/march/slabs.hpp"
#include "percal/solid/particle/polyhedron.hpp"
#include "percal/solid/target/contents.hpp"

namespace percal {
namespace {

// One run: central differences in leapfrog form, velocities half a step behind displacements until synchronise(). The words and their
// order are those of the march in impact/march/march.cpp, with one time step for all.
template <class Real, class Body>
class SolidMarch {
 public:
  SolidMarch(const Problem& problem, FrameObserver* observer, int threads)
      : problem_(problem),
        limits_(step_limits(problem)),
        block_(problem, solid_kernel<Real>().lanes),
        solid_(solid_of_block(problem, block_.layers())),
        slabs_(block_, solid_kernel<Real>(), solid_, threads),
        body_(problem),
        contact_(block_, solid_kernel<Real>(), body_, friction_coefficient(problem)),
        recorder_(problem.history_samples),
        layer_speeds_(problem),
        course_(problem),
        observer_(observer) {
    torn_ = !take_initial_state(block_, solid_);
    impact_energy_ = body_.energy().kinetic;
    rows_moving_ = std::min(block_.grid().rows(), 2 * front_rows);
    result_.elements = block_.grid().elements();
  }

  ImpactResult run() {
    for (;;) {
      find_forces();
      if (course_.has_ended(sight()) && !goes_on()) break;
      choose_step();
      if (recorder_.is_due()) recorder_.keep(history_point());
      if (observer_ && observer_->is_due(moment())) at_one_time([this] { show_as_is(false); });
      move(0.5 * (last_step_ + step_), step_);
      if (++result_.steps % front_interval == 0) extend_front();
    }
    synchronise();
    close_the_books();
    return course_.finished(place());
  }

 private:
  void find_forces() {
    if (result_.steps % search_interval == 0) contact_.search(rows_moving_, 0.25 + 3 * search_interval * step_);
    inverse_step_ = 0;
    int slab = 0;
    for (const SlabReport& report : slabs_.find_forces(rows_moving_, last_step_)) {
      viscous_work_ += report.viscous_work;
      inverse_step_ = std::max(inverse_step_, report.largest_inverse_step);
      result_.smallest_jacobian = std::min(result_.smallest_jacobian, report.smallest_jacobian);
      for (const int j : report.doomed_columns)
        for (int k = 0; k < rows_moving_; ++k)
          if (block_.fields().alive[block_.at(slab, j, k)] < 0) erode(slab, j, k);
      ++slab;
    }
    result_.element_steps += static_cast<double>(rows_moving_) * block_.grid().columns_x() * block_.grid().columns_y();
  }

  // What leaves with an element: docs/theory/impact.md, "Energy".
  void erode(int i, int j, int k) {
    const ElementEnergy energy = element_energy(block_, solid_, i, j, k, last_step_);
    eroded_energy_ += energy.elastic + energy.hourglass + energy.last_work;
    ++result_.eroded;
    if (block_.fields().alive[block_.at(i, j, k)] < -1)
      ++result_.distorted;
    else if (solid_.erosion_kind == ErosionKind::several)
      ++count_of(result_.eroded_by, leading_criterion(block_, solid_, i, j, k));
    if (!solid_.erodes(k)) inside_out_ = true;
    block_.take_out(i, j, k);
  }

  Course::Sight sight() const {
    std::string failure;
    if (inside_out_) failure = "an element turned inside out";
    if (is_beyond_a_wall()) failure = "the particle has gone into a side wall, which holds nothing that it could meet";
    if (torn_) failure = "the target's initial stretch alone reaches its limit of erosion";
    return {place(), std::isfinite(contact_.force()) && std::isfinite(viscous_work_),
            inverse_step_ * limits_.first_step, std::move(failure)};
  }

  bool is_beyond_a_wall() const {
    const auto beyond = [](double place, const std::vector<double>& planes) {
      return place > planes.back() || (planes.front() < 0 && place < planes.front());
    };
    return beyond(body_.sideways(), block_.grid().x) || beyond(body_.across(), block_.grid().y);
  }

  bool goes_on() {
    return course_.goes_on([this] {
      return std::pair(at_one_time([this] {
                         take_stock();
                         return result_;
                       }),
                       time_);
    });
  }

  void choose_step() {
    step_ = limits_.time_step_factor / std::max(inverse_step_, 1 / limits_.first_step);
    if (last_step_ > 0) step_ = std::min(step_, step_growth * last_step_);
    step_ = std::min(step_, largest_travel / problem_.elements_per_radius / problem_.speed_factor);
    result_.smallest_step = std::min(result_.smallest_step, step_ / (limits_.time_step_factor * limits_.first_step));
  }

  void move(double kick, double drift) {
    slabs_.move(rows_moving_, kick, drift);
    if (drift > 0) contact_.close(kick, drift);
    const double tip = body_.tip();
    body_.drift(drift);
    time_ += drift;
    last_step_ = drift;
    if (drift > 0) layer_speeds_.moved(time_, drift, tip, body_.tip(), body_.speed());
  }

  // Rows join the march when the last of those that move is no longer at rest.
  void extend_front() {
    const int rows = block_.grid().rows();
    if (rows_moving_ == rows) return;
    const auto& fields = block_.fields();
    for (int i = 0; i <= block_.slabs(); ++i)
      for (int j = 0; j <= block_.columns_y(); ++j)
        for (const Real* v : fields.v) {
          const Real* last = v + block_.at(i, j, rows_moving_ - front_rows);
          if (std::any_of(last, last + front_rows, [](Real x) { return std::abs(x) > Real(rest_speed); })) {
            rows_moving_ = std::min(rows, rows_moving_ + front_rows);
            return;
          }
        }
  }

  // Brings velocities to the time of the displacements: the second half of the last kick.
  void synchronise() {
    move(0.5 * last_step_, 0);
    contact_.hold();
  }

  // What look() makes of this moment, with velocities at the time of the displacements. Afterwards all stands where it stood.
  template <class Look>
  auto at_one_time(const Look& look) {
    struct PutBack {
      SolidMarch& march;
      std::vector<Real> motion = march.block_.motion();
      Body body = march.body_;
      double last_step = march.last_step_;
      ~PutBack() {
        march.block_.put_back(motion);
        march.body_ = std::move(body);
        march.last_step_ = last_step;
      }
    } put_back{*this};
    synchronise();
    return look();
  }

  HistoryPoint history_point() {
    const auto shares = [this] { return energy_shares(rows_moving_); };
    return {time_, body_.tip(), body_.speed(), contact_.force(), at_one_time(shares)};
  }

  Moment moment() const { return {time_, body_.tip(), result_.steps}; }
  ParticlePlace place() const { return {time_, body_.tip(), body_.top(), body_.speed()}; }

  // To the observer; velocities must stand at the time of the displacements.
  void show_as_is(bool is_last) const {
    const auto in_space = [this] { return SpaceFrame{space_piece(block_, solid_), body_.space_piece(problem_)}; };
    observer_->see({moment(), is_last, cut_piece(block_, solid_), body_.piece(problem_), in_space});
  }

  EnergyLedger energy_shares(int rows) const {
    EnergyLedger energy = stored_energy(block_, solid_, rows);
    energy.particle = body_.energy().kinetic;
    energy.viscosity = viscous_work_;
    energy.eroded = eroded_energy_;
    energy.collisions = contact_.collisions();
    energy.friction = contact_.friction();
    for (const auto& [key, share, words] : energy_terms) energy.*share /= impact_energy_;
    return energy;
  }

  void take_stock() {
    result_.energy = energy_shares(block_.grid().rows());
    result_.end_time = time_;
    result_.end_speed = body_.speed();
    result_.sideways = body_.sideways();
    result_.turn = body_.turn();
    result_.in_space = body_.in_space();
    result_.target_momentum = momentum(block_) * problem_.speed_factor * problem_.speed_factor / (2 * impact_energy_);
    result_.speeds_behind = layer_speeds_.at_the_end(time_, body_.speed());
    course_.judge_energy();
  }

  void close_the_books() {
    take_stock();
    recorder_.finish({time_, body_.tip(), body_.speed(), contact_.force(), result_.energy});
    if (observer_) show_as_is(true);
    result_.history = recorder_.take();
    result_.helper_cpu_seconds = slabs_.helper_cpu_seconds();
  }

  const Problem& problem_;
  const StepLimits limits_;
  SolidBlock<Real> block_;
  const TargetSolid solid_;
  Slabs<Real> slabs_;
  Body body_;
  SpaceContact<Real, Body> contact_;
  Recorder recorder_;
  LayerSpeeds layer_speeds_;
  Course course_;
  ImpactResult& result_ = course_.result();
  FrameObserver* const observer_;  // null where nobody looks on
  double time_ = 0, step_ = 0, last_step_ = 0, inverse_step_ = 0;
  double impact_energy_ = 0, viscous_work_ = 0, eroded_energy_ = 0;
  int rows_moving_ = 0;
  bool inside_out_ = false;  // an element that does not erode
  bool torn_ = false;        // before the impact
};

template <class Real>
ImpactResult run(const Problem& problem, FrameObserver* observer, int threads) {
  if (std::holds_alternative<RigidPolyhedron>(problem.particle))
    return SolidMarch<Real, PolyhedronRun>(problem, observer, threads).run();
  if (std::holds_alternative<RigidPolygon>(problem.particle))
    return SolidMarch<Real, BodyRun<PrismShape>>(problem, observer, threads).run();
  return SolidMarch<Real, BodyRun<SphereShape>>(problem, observer, threads).run();
}

ImpactResult run(const Problem& problem, FrameObserver* observer, int threads) {
  return problem.arithmetic == Arithmetic::single_precision ? run<float>(problem, observer, threads)
                                                            : run<double>(problem, observer, threads);
}

}  // namespace

ImpactResult run_solid(const Problem& problem, int threads) { return run(problem, nullptr, threads); }

ImpactResult run_solid(const Problem& problem, FrameObserver& observer, int threads) {
  return run(problem, &observer, threads);
}

}  // namespace percal
