#include "percal/impact/march/march.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "percal/impact/march/channel_record.hpp"
#include "percal/impact/march/contact_zone.hpp"
#include "percal/impact/march/course.hpp"
#include "percal/impact/march/half_speed.hpp"
#include "percal/impact/march/layer_speeds.hpp"
#include "percal/impact/march/recorder.hpp"
#include "percal/impact/march/sweep.hpp"
#include "percal/impact/particle/elastic_sphere.hpp"
#include "percal/impact/particle/particle.hpp"
#include "percal/impact/settings.hpp"
#include "percal/impact/target/constants.hpp"
#include "percal/impact/target/contents.hpp"
#include "percal/impact/target/initial_stretch.hpp"

namespace percal {
namespace {

// One run: central differences in leapfrog form, velocities half a step behind displacements until synchronise(). Elements near
// the particle, and the particle, take `substeps_` short steps while the far ones take a long one.
template <class Real, class ParticleRun>
class March {
 public:
  March(const Problem& problem, FrameObserver* observer, int threads)
      : problem_(problem),
        kernel_(kernel<Real>()),
        limits_(step_limits(problem)),
        block_(problem, mesh_of(problem), kernel_.lanes),
        solid_(problem, block_.layers()),
        sweep_(problem, block_, kernel_, solid_, threads),
        particle_(problem),
        zone_(block_, kernel_, particle_, friction_coefficient(problem)),
        recorder_(problem.history_samples),
        layer_speeds_(problem),
        half_speed_(problem),
        channel_(problem.channel, block_.mesh().rows),
        course_(problem),
        observer_(observer),
        substeps_(rates_of(problem)) {
    if (solid_.is_stretched()) torn_ = !take_initial_state(block_, solid_);
    impact_energy_ = particle_.energy().kinetic;
    rows_moving_ = std::min(block_.mesh().rows, 2 * front_rows);
    if (substeps_ > 1)
      near_ = NearCells(block_.mesh().columns(), sweep_.whole_groups(block_.mesh().rows), kernel_.lanes);
    before_ = near_;
    result_.elements = block_.mesh().elements();
  }

  ImpactResult run() {
    for (;;) {
      find_all_forces();
      channel_.look(block_, result_.depth);
      if (course_.has_ended(sight()) && !goes_on()) break;
      choose_step();
      if (recorder_.is_due()) recorder_.keep(history_point());
      if (observer_ && observer_->is_due(moment())) observer_->see(frame());
      move_far(0.5 * (last_far_step_ + far_step()), far_step());
      move_near(0.5 * (last_step_ + step_), step_);
      for (int substep = 1; substep < substeps_; ++substep) {
        find_near_forces();
        move_near(step_, step_);
      }
      last_far_step_ = far_step();
      if (++result_.steps % front_interval == 0) extend_front();
    }
    synchronise();
    close_the_books();
    return course_.finished(place());
  }

 private:
  double far_step() const { return substeps_ * step_; }

  void find_all_forces() {
    if (result_.steps % search_interval == 0) zone_.search(rows_moving_, 0.25 + 3 * search_interval * step_);
    const bool choose = substeps_ > 1 && result_.steps % near_interval == 0;
    if (choose) choose_near_cells();
    sweep_.set_time(time_);
    take_in(sweep_.all(near_, rows_moving_, last_far_step_, last_step_));
    if (choose) settle_those_that_changed();
    far_inverse_step_ = forces_.far_inverse_step;
    result_.element_steps += static_cast<double>(rows_moving_) * block_.mesh().columns();
  }

  void find_near_forces() {
    sweep_.set_time(time_);
    take_in(sweep_.near_only(near_, last_step_));
    result_.element_steps += near_.elements_in_all();
  }

  void take_in(SweepReport report) {
    forces_ = std::move(report);
    viscous_work_ += forces_.viscous_work;
    relaxing_work_ += forces_.relaxing_work;
    result_.smallest_jacobian = std::min(result_.smallest_jacobian, forces_.smallest_jacobian);
    for (const int column : forces_.doomed_columns)
      for (int j = 0; j < rows_moving_; ++j)
        if (block_.view().alive[block_.at(column, j)] < 0) erode(column, j);
  }

  // Everything around the particle, and what has lately been too stiff for the long step.
  void choose_near_cells() {
    const double height = block_.mesh().row_height;
    const int end = sweep_.whole_groups(rows_moving_);
    const auto row_of = [&](double depth) {
      return std::min(end, std::max(0, static_cast<int>(depth / height)) / kernel_.lanes * kernel_.lanes);
    };
    const Rows around{row_of(particle_.tip() - near_behind), std::min(end, row_of(particle_.tip()) + kernel_.lanes)};
    const ContactColumns columns = zone_.columns();
    near_.clear();
    near_.add(std::max(0, columns.begin - 1), std::min(columns.end, block_.mesh().columns()), around);
    sweep_.add_stiff(near_);
    near_.close();
  }

  // Velocities stand half a last step behind, a long one for what was far, a short one for what was near; the next kick takes it that
  // everything was what it is now. What has changed gets the difference.
  void settle_those_that_changed() {
    sweep_.settle(near_, before_, 0.5 * (last_far_step_ - last_step_));
    before_ = near_;
  }

  // The energy that leaves with an element is what it stores plus what its forces, gone before the end of the last step, did
  // not do any more in that step's second half; so the books close to second order (docs/theory/impact.md, "Energy").
  void erode(int column, int row) {
    const auto energy = element_energy(block_, solid_, column, row,
                                       substeps_ > 1 && before_.has(column, row) ? last_step_ : last_far_step_);
    eroded_energy_ += energy.elastic + energy.hourglass + energy.last_work;
    ++result_.eroded;
    if (block_.view().alive[block_.at(column, row)] < -1)
      ++result_.distorted;
    else if (solid_.erosion_kind == ErosionKind::several)
      ++count_of(result_.eroded_by, leading_criterion(block_, solid_, column, row));
    if (!solid_.erodes(row)) inside_out_ = true;
    block_.take_out(column, row, problem_.eroded_nodes == ErodedNodes::in_contact);
  }

  Course::Sight sight() const {
    std::string failure = particle_.failure();
    if (inside_out_) failure = "an element turned inside out";
    if (torn_) failure = "the target's initial stretch alone reaches its limit of erosion";
    return {place(), std::isfinite(zone_.force()) && std::isfinite(viscous_work_ + relaxing_work_),
            std::max(forces_.near_inverse_step, far_inverse_step_) * limits_.first_step, std::move(failure)};
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

  // The step of the particle and of what is near it; the far elements take substeps_ times as much.
  void choose_step() {
    const double first = 1 / limits_.first_step;
    step_ =
        std::min(stable_step(forces_.near_inverse_step), stable_step(std::max(far_inverse_step_, first)) / substeps_);
    if (last_step_ > 0) step_ = std::min(step_, step_growth * last_step_);
    step_ = std::min(step_, largest_travel * block_.mesh().row_height / problem_.speed_factor / substeps_);
    result_.smallest_step = std::min(result_.smallest_step, step_ / (limits_.time_step_factor * limits_.first_step));
    if (substeps_ > 1)
      sweep_.watch(std::max(1 / (longest_far_step * limits_.first_step), forces_.near_inverse_step / substeps_));
  }

  double stable_step(double inverse_step) const { return limits_.time_step_factor / inverse_step; }
  void move_far(double kick, double drift) {
    if (!(drift > 0)) return sweep_.move_far(near_, rows_moving_, kick, drift);
    zone_.open_far(rows_moving_, drift);
    sweep_.move_far(near_, rows_moving_, kick, drift, [this](int column) { zone_.look_far(near_, column); });
    zone_.close_far(kick);
  }

  void move_near_nodes(double kick, double drift) {
    if (near_.empty()) return;
    if (!(drift > 0)) return sweep_.move_near(near_, kick, drift);
    zone_.open_near(drift);
    sweep_.move_near(near_, kick, drift, [this](int column) { zone_.look_near(near_, column); });
    zone_.close_near(kick);
  }

  void move_near(double kick, double drift) {
    move_near_nodes(kick, drift);
    const double tip = particle_.tip();
    particle_.drift(drift);
    time_ += drift;
    last_step_ = drift;
    if (!(drift > 0)) return;
    layer_speeds_.moved(time_, drift, tip, particle_.tip(), particle_.speed());
    half_speed_.moved(tip, particle_.tip(), particle_.speed());
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

  // Brings velocities to the time of the displacements: the second half of the last kicks.
  void synchronise() {
    const double short_step = last_step_;
    move_far(0.5 * last_far_step_, 0);
    move_near(0.5 * short_step, 0);
    zone_.hold();
  }

  // What look() makes of this moment, with velocities at the time of the displacements. Afterwards all stands where it stood.
  template <class Look>
  auto at_one_time(const Look& look) {
    const std::vector<Real> motion = block_.motion();
    const ParticleRun particle = particle_;
    const double last_step = last_step_;
    synchronise();
    auto seen = look();
    block_.put_back(motion);
    particle_ = particle;
    last_step_ = last_step;
    return seen;
  }

  HistoryPoint history_point() {
    const auto shares = [this] { return energy_shares(rows_moving_); };
    return {time_, particle_.tip(), particle_.speed(), zone_.force(), at_one_time(shares)};
  }

  ParticlePlace place() const { return {time_, particle_.tip(), particle_.top(), particle_.speed()}; }
  Moment moment() const { return {time_, particle_.tip(), result_.steps}; }
  // Velocities as they stand.
  Frame frame_as_is(bool is_last) const {
    return {moment(), is_last, target_piece(block_, solid_), particle_.piece(problem_)};
  }
  Frame frame() {
    return at_one_time([this] { return frame_as_is(false); });
  }

  // Of the rows down to this one; velocities stand at the time of the displacements.
  EnergyLedger energy_shares(int rows) const {
    EnergyLedger energy = stored_energy(block_, solid_, rows);
    const ParticleEnergy own = particle_.energy();
    energy.particle = own.kinetic;
    energy.particle_elastic = own.stored;
    energy.viscosity = viscous_work_ + own.viscous;
    energy.relaxation = relaxing_work_;
    energy.eroded = eroded_energy_;
    energy.collisions = zone_.collisions() + own.collisions;
    energy.friction = zone_.friction();
    for (const auto& [key, share, words] : energy_terms) energy.*share /= impact_energy_;
    return energy;
  }

  double target_momentum() const {
    double sum = 0;
    for (int i = 0; i <= block_.mesh().columns(); ++i)
      for (int j = 0; j <= block_.mesh().rows; ++j) sum += block_.mass(i, j) * block_.view().v_z[block_.at(i, j)];
    const double particle_mass = 2 * impact_energy_ / (problem_.speed_factor * problem_.speed_factor);
    return sum / particle_mass;
  }

  // Of this moment; velocities stand at the time of the displacements.
  void take_stock() {
    result_.energy = energy_shares(block_.mesh().rows);
    result_.end_time = time_;
    result_.end_speed = particle_.speed();
    result_.sideways = particle_.sideways();
    result_.turn = particle_.turn();
    result_.target_momentum = target_momentum();
    result_.speeds_behind = layer_speeds_.at_the_end(time_, particle_.speed());
    result_.half_speed_depth = half_speed_.depth();
    course_.judge_energy();
  }

  void close_the_books() {
    take_stock();
    recorder_.finish({time_, particle_.tip(), particle_.speed(), zone_.force(), result_.energy});
    if (observer_) observer_->see(frame_as_is(true));
    result_.history = recorder_.take();
    result_.channel = channel_.at_the_end(block_, result_.depth);
    result_.helper_cpu_seconds = sweep_.helper_cpu_seconds();
  }

  const Problem& problem_;
  const Kernel<Real>& kernel_;
  const StepLimits limits_;
  Block<Real> block_;
  const TargetSolid solid_;
  Sweep<Real> sweep_;
  ParticleRun particle_;
  ContactZone<Real, ParticleRun> zone_;
  Recorder recorder_;
  LayerSpeeds layer_speeds_;
  HalfSpeedDepth half_speed_;
  ChannelRecord<Real> channel_;
  Course course_;
  ImpactResult& result_ = course_.result();
  FrameObserver* const observer_;  // null where nobody looks on
  const int substeps_;
  NearCells before_;  // those of the last move
  NearCells near_;    // elements that take the short step
  SweepReport forces_;
  double time_ = 0, step_ = 0, last_step_ = 0, last_far_step_ = 0, far_inverse_step_ = 0;
  double impact_energy_ = 0, viscous_work_ = 0, relaxing_work_ = 0, eroded_energy_ = 0;
  int rows_moving_ = 0;
  bool inside_out_ = false;  // an element that does not erode
  bool torn_ = false;        // before the impact
};

// Which run each choice of a particle gets.
template <class Real>
struct MarchOf {
  const Problem& problem;
  FrameObserver* observer;
  int threads;

  ImpactResult operator()(const RigidSphere&) const { return with<SphereRun>(); }
  ImpactResult operator()(const RigidPolygon&) const { return with<PolygonRun>(); }
  ImpactResult operator()(const ElasticSphere&) const { return with<ElasticSphereRun>(); }
  ImpactResult operator()(const RigidPolyhedron&) const { throw std::logic_error("a polyhedron is a body of a block"); }
  template <class ParticleRun>
  ImpactResult with() const {
    return March<Real, ParticleRun>(problem, observer, threads).run();
  }
};

ImpactResult march(const Problem& problem, FrameObserver* observer, int threads) {
  return problem.arithmetic == Arithmetic::single_precision
             ? std::visit(MarchOf<float>{problem, observer, threads}, problem.particle)
             : std::visit(MarchOf<double>{problem, observer, threads}, problem.particle);
}

}  // namespace

ImpactResult run_impact(const Problem& problem, int threads) { return march(problem, nullptr, threads); }

ImpactResult run_impact(const Problem& problem, FrameObserver& observer, int threads) {
  return march(problem, &observer, threads);
}

}  // namespace percal
