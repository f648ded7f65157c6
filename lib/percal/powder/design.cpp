#include "percal/powder/design.hpp"

#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

#include "percal/math/root.hpp"

namespace percal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Fineness quick{.cells = 160, .values = 8};
constexpr int quick_draws = 40;
constexpr int search_evaluations = 150;
constexpr double slack = 1e-9;         // of a limit
constexpr double furthest_factor = 4;  // that a tolerance is looked for
constexpr int speeds_of_line = 41;

// What is read of each draw, in this order.
enum { read_dose, read_bounced, read_passed, read_deeper, reads };

// Shares of the mass for middle particles within the box of the search.
class Candidates {
 public:
  Candidates(const Powder& powder, const ForwardModel& model, const DoseQuestion& question,
             const DesignQuestion& design, double density, const Fineness& fineness, int fewest_draws)
      : model_(model),
        question_(question),
        design_(design),
        middle_(middle_particle(powder)),
        density_(density),
        classes_(classes_of(powder, fineness)),
        table_(model, box()),
        draws_(draws_of(model, table_.points(), fewest_draws)) {
    // Evenly from all of them: each quick draw has a point of its own.
    if (const auto every = draws_.size() / static_cast<std::size_t>(fewest_draws); every > 1)
      for (std::size_t k = 0; k * every < draws_.size(); ++k) draws_[k] = draws_[k * every];
    draws_.resize(std::min<std::size_t>(draws_.size(), static_cast<std::size_t>(fewest_draws)));
  }

  // Draws in rows.
  MatrixXd all(double radius, double speed) const {
    const auto classes = scaled(classes_, factors(radius, speed));
    return readings_of(classes, table_, draws_, question_.bounce, [&](const DepthDistribution& found) {
      Eigen::VectorXd row(Index{reads});
      const double bounced = found.bounced(By::mass), within = found.above(By::mass, question_.layer_depth);
      row[read_dose] = found.above(By::mass, question_.band->to) - found.above(By::mass, question_.band->from);
      row[read_bounced] = bounced;
      row[read_passed] = 1 - bounced - within;
      row[read_deeper] =
          design_.limits.deeper_than ? 1 - bounced - found.above(By::mass, *design_.limits.deeper_than) : 0;
      return row;
    });
  }

  DesignPoint at(double radius, double speed) const {
    const Eigen::RowVectorXd mean = all(radius, speed).colwise().mean();
    DesignPoint point{
        {radius, density_, speed},
        {mean[read_dose], mean[read_bounced], mean[read_passed], mean[read_deeper], beyond(radius, speed)}};
    for (const double excess : excesses(point)) point.allowed = point.allowed && excess <= slack;
    return point;
  }

  // Over the limits, in their order: above 0 where one is broken.
  std::vector<double> excesses(const DesignPoint& point) const {
    const DoseLimits& limits = design_.limits;
    std::vector<double> found;
    if (limits.bounced) found.push_back(point.shares.bounced - *limits.bounced);
    if (limits.passed) found.push_back(point.shares.passed - *limits.passed);
    if (limits.deeper) found.push_back(point.shares.deeper - *limits.deeper);
    if (limits.beyond) found.push_back(point.shares.beyond - *limits.beyond);
    if (limits.most_impact) found.push_back(impact_parameter(point.middle) / *limits.most_impact - 1);
    return found;
  }

  const SearchRange& radii() const { return design_.radius; }
  const SearchRange& speeds() const { return design_.speed; }

 private:
  PowderParticle factors(double radius, double speed) const {
    return {radius / middle_.radius, density_ / middle_.density, speed / middle_.speed};
  }
  // As far as a tolerance is looked for.
  ParticleBox box() const {
    const auto low = box_of(scaled(classes_, factors(design_.radius.low, design_.speed.low)));
    const auto high = box_of(scaled(classes_, factors(design_.radius.high, design_.speed.high)));
    return {low.low, high.high};
  }

  // Share of the mass.
  double beyond(double radius, double speed) const {
    double share = 0;
    if (model_.has_seen)
      for (const ParticleClass& one : scaled(classes_, factors(radius, speed)))
        if (!model_.has_seen(middle_of(one))) share += one.mass;
    return share;
  }

  const ForwardModel& model_;
  const DoseQuestion& question_;
  const DesignQuestion& design_;
  PowderParticle middle_;
  double density_;
  std::vector<ParticleClass> classes_;
  DepthTable table_;
  std::vector<Draw> draws_;
};

std::vector<double> log_spaced(const SearchRange& range, int count) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(range.low * std::pow(range.high / range.low, k / (count - 1.0)));
  return values;
}

std::vector<DesignPoint> map_of(const Candidates& candidates, int count) {
  std::vector<DesignPoint> map;
  for (const double radius : log_spaced(candidates.radii(), count))
    for (const double speed : log_spaced(candidates.speeds(), count)) map.push_back(candidates.at(radius, speed));
  return map;
}

// The allowed one of the largest dose.
const DesignPoint* best_of(std::span<const DesignPoint> points) {
  const DesignPoint* best = nullptr;
  for (const DesignPoint& point : points)
    if (point.allowed && (!best || point.shares.dose > best->shares.dose)) best = &point;
  return best;
}

// Climbs by linear approximations (COBYLA) from a point of the map; over the logarithms of radius and speed, 0 to 1 in their ranges.
class Climb {
 public:
  Climb(const Candidates& candidates, const DesignPoint& start) : candidates_(candidates), best_(start), seen_(start) {}

  // `step`: of the map.
  DesignPoint best(double step) {
    nlopt::opt search(nlopt::LN_COBYLA, 2);
    search.set_lower_bounds(0.0);
    search.set_upper_bounds(1.0);
    search.set_initial_step(step);
    search.set_xtol_abs(1e-5);
    search.set_maxeval(search_evaluations);
    search.set_max_objective([](const std::vector<double>& at, std::vector<double>&,
                                void* self) { return static_cast<Climb*>(self)->look(at).shares.dose; },
                             this);
    if (const auto limits = candidates_.excesses(best_).size(); limits > 0)
      search.add_inequality_mconstraint(
          [](unsigned count, double* excess, unsigned dimensions, const double* at, double*, void* self) {
            auto& climb = *static_cast<Climb*>(self);
            const auto found = climb.candidates_.excesses(climb.look({at, at + dimensions}));
            std::copy_n(found.begin(), count, excess);
          },
          this, std::vector(limits, 0.0));
    std::vector<double> at{along(candidates_.radii(), best_.middle.radius),
                           along(candidates_.speeds(), best_.middle.speed)};
    double reached = 0;
    try {
      search.optimize(at, reached);
    } catch (const std::runtime_error&) {  // rounding: the best so far stands
    }
    return best_;
  }

 private:
  static double along(const SearchRange& range, double value) {
    return std::clamp(std::log(value / range.low) / std::log(range.high / range.low), 0.0, 1.0);
  }

  const DesignPoint& look(const std::vector<double>& at) {
    if (at == looked_at_) return seen_;
    const auto value = [](const SearchRange& range, double share) {
      return range.low * std::pow(range.high / range.low, share);
    };
    seen_ = candidates_.at(value(candidates_.radii(), at[0]), value(candidates_.speeds(), at[1]));
    looked_at_ = at;
    if (seen_.allowed && seen_.shares.dose > best_.shares.dose) best_ = seen_;
    return seen_;
  }

  const Candidates& candidates_;
  DesignPoint best_, seen_;
  std::vector<double> looked_at_;
};

// Where ln of a number, from that of the best on, leaves `enough` of the dose.
template <class Dose>
Tolerance tolerance(double best, const SearchRange& range, const Dose& dose_at, double enough) {
  const double whole = dose_at(best);
  const auto left = [&](double log_value) { return dose_at(std::exp(log_value)) - enough * whole; };
  constexpr double close = 1e-4;
  Tolerance found{range.low, range.high, true, true};
  const double middle = std::log(best), low = std::log(range.low), high = std::log(range.high);
  // In steps: the dose need not fall for good.
  constexpr int steps = 24;
  const auto end = [&](double furthest, double& value, bool& open) {
    for (int k = 1; k <= steps && open; ++k) {
      const double near = middle + (furthest - middle) * (k - 1) / steps,
                   far = middle + (furthest - middle) * k / steps;
      if (left(far) >= 0) continue;
      value = std::exp(root(left, std::min(near, far), std::max(near, far), close));
      open = false;
    }
  };
  if (low < middle) end(low, found.low, found.low_open);
  if (high > middle) end(high, found.high, found.high_open);
  return found;
}

// Where the parabola through three values at even steps is largest, in steps from the middle one.
double top_of_parabola(double before, double middle, double after) {
  const double bend = before - 2 * middle + after;
  return bend < 0 ? std::clamp(0.5 * (before - after) / bend, -1.0, 1.0) : 0;
}

// For each radius of the map the speed of the largest dose that is allowed.
std::vector<DesignPoint> best_line(const Candidates& candidates, std::span<const DesignPoint> map, int side) {
  std::vector<DesignPoint> line;
  for (auto row = map; !row.empty(); row = row.subspan(static_cast<std::size_t>(side))) {
    const auto speeds = row.first(static_cast<std::size_t>(side));
    const DesignPoint* best = best_of(speeds);
    if (!best) continue;
    line.push_back(*best);
    if (best == &speeds.front() || best == &speeds.back()) continue;
    const double shift = top_of_parabola(best[-1].shares.dose, best->shares.dose, best[1].shares.dose),
                 speed = best->middle.speed * std::pow(best[1].middle.speed / best->middle.speed, shift);
    const DesignPoint between = candidates.at(best->middle.radius, speed);
    if (between.allowed && between.shares.dose > best->shares.dose) line.back() = between;
  }
  return line;
}

// The speed of the largest dose at this radius, for each draw.
Tolerance best_speeds(const Candidates& candidates, double radius, double level) {
  const auto speeds = log_spaced(candidates.speeds(), speeds_of_line);
  MatrixXd doses;
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    const MatrixXd here = candidates.all(radius, speeds[k]);
    if (k == 0) doses.resize(here.rows(), static_cast<Index>(speeds.size()));
    doses.col(static_cast<Index>(k)) = here.col(read_dose);
  }
  Eigen::VectorXd best(doses.rows());
  for (Index draw = 0; draw < doses.rows(); ++draw) {
    Index at = 0;
    doses.row(draw).maxCoeff(&at);
    const bool is_inside = at > 0 && at + 1 < doses.cols();
    const double shift = is_inside ? top_of_parabola(doses(draw, at - 1), doses(draw, at), doses(draw, at + 1)) : 0;
    best[draw] = speeds[static_cast<std::size_t>(at)] * std::pow(speeds[1] / speeds[0], shift);
  }
  const DoseEstimate found = estimate_of(best, level);
  return {found.low, found.high, found.low <= speeds.front(), found.high >= speeds.back()};
}

// The best with sizes and speeds that spread half and twice as much; where speeds have no spread, by 5 to 20 %.
std::vector<OtherSpread> other_spreads(const Powder& powder, const ForwardModel& model, const DoseQuestion& question,
                                       const DesignQuestion& design, const DesignPoint& best) {
  std::vector<OtherSpread> found;
  DesignQuestion here = design;
  here.radius = {best.middle.radius, best.middle.radius};
  here.speed = {best.middle.speed, best.middle.speed};
  const auto add = [&](const std::string& name, Powder other, double log_deviation) {
    const Candidates candidates(other, model, question, here, best.middle.density, quick, quick_draws);
    found.push_back({name, std::exp(log_deviation), candidates.at(best.middle.radius, best.middle.speed).shares.dose});
  };
  for (const auto& [name, number] : {std::pair{"size", &Powder::radius}, {"speed", &Powder::speed}})
    if (is_one_value(powder.*number)) {
      for (const double deviation : {0.05, 0.1, 0.2}) {
        Powder other = powder;
        other.*number = Lognormal{median_of(powder.*number), deviation};
        add(name, other, deviation);
      }
    } else {
      for (const double factor : {0.0, 0.5, 1.0, 1.5, 2.0}) {
        Powder other = powder;
        other.*number = spread_by(powder.*number, factor);
        add(name, other, factor * log_deviation_of(powder.*number));
      }
    }
  return found;
}

void look_about(const Candidates& candidates, const DoseQuestion& question, const DesignQuestion& asked,
                PowderDesign& design) {
  const PowderParticle& best = design.best->middle;
  const auto about = [](double value, const SearchRange& range) {
    return SearchRange{std::max(range.low, value / furthest_factor), std::min(range.high, value * furthest_factor)};
  };
  design.radius = tolerance(
      best.radius, about(best.radius, asked.radius),
      [&](double radius) { return candidates.at(radius, best.speed).shares.dose; }, asked.enough);
  design.speed = tolerance(
      best.speed, about(best.speed, asked.speed),
      [&](double speed) { return candidates.at(best.radius, speed).shares.dose; }, asked.enough);
  design.best_speed = best_speeds(candidates, best.radius, question.level);
}

void estimate_best(const Powder& powder, const ForwardModel& model, const DoseQuestion& question, DesignQuestion asked,
                   PowderDesign& design) {
  const PowderParticle& best = design.best->middle;
  asked.radius = {best.radius, best.radius};
  asked.speed = {best.speed, best.speed};
  const Candidates here(powder, model, question, asked, best.density, {}, 240);
  const MatrixXd all = here.all(best.radius, best.speed);
  const auto estimate = [&](int read) { return estimate_of(all.col(read), question.level); };
  design.dose = estimate(read_dose);
  design.bounced = estimate(read_bounced);
  design.passed = estimate(read_passed);
  design.deeper = estimate(read_deeper);
}

}  // namespace

PowderDesign design_of(const Powder& powder, const ForwardModel& model, const DoseQuestion& question,
                       const DesignQuestion& asked) {
  PowderDesign design;
  std::vector<double> densities = asked.densities;
  if (densities.empty()) densities.push_back(middle_particle(powder).density);
  for (const double density : densities) {
    const Candidates candidates(powder, model, question, asked, density, quick, quick_draws);
    auto map = map_of(candidates, asked.map);
    const DesignPoint* start = best_of(map);
    if (start) design.by_density.push_back(Climb(candidates, *start).best(1.0 / (asked.map - 1)));
    const bool is_best = start && (!design.best || design.by_density.back().shares.dose > design.best->shares.dose);
    if (!is_best && !design.map.empty()) continue;
    design.map = std::move(map);
    if (!is_best) continue;
    design.best = design.by_density.back();
    design.line = best_line(candidates, design.map, asked.map);
    look_about(candidates, question, asked, design);
  }
  if (!design.best) return design;
  estimate_best(powder, model, question, asked, design);
  design.spreads = other_spreads(powder, model, question, asked, *design.best);
  return design;
}

}  // namespace percal
