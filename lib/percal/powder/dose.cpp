#include "percal/powder/dose.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

#include "percal/math/distributions.hpp"
#include "percal/math/draws.hpp"

namespace percal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int fewest_draws = 240;
constexpr int curve_points = 60;
constexpr double most_scatter = 1.5;     // of ln depth: a few degrees of freedom allow any, and more is no model
constexpr double deepest_shown = 0.995;  // of the mass that ends within the layer

// Takes a row of readings apart in the order in which it was made.
class Taken {
 public:
  Taken(const MatrixXd& readings, double level) : readings_(readings), level_(level) {}
  DoseEstimate next() { return estimate_of(readings_.col(column_++), level_); }

 private:
  const MatrixXd& readings_;
  double level_;
  Index column_ = 0;
};

// bounced, above each end, above the layer's depth
void read_shares(const DepthDistribution& found, By by, const DoseQuestion& question, std::vector<double>& row) {
  row.push_back(found.bounced(by));
  double above = 0;
  for (const double end : question.ends) {
    const double here = found.above(by, end);
    row.push_back(here - above);
    above = here;
  }
  const double within = found.above(by, question.layer_depth);
  row.push_back(within - above);
  row.push_back(1 - found.bounced(by) - within);
  row.push_back(question.band ? found.above(by, question.band->to) - found.above(by, question.band->from) : 0);
  row.push_back(question.known_depth > 0 ? 1 - found.bounced(by) - found.above(by, question.known_depth) : 0);
}

DoseShares take_shares(Taken& taken, std::size_t layers) {
  DoseShares shares;
  shares.bounced = taken.next();
  for (std::size_t k = 0; k < layers; ++k) shares.layers.push_back(taken.next());
  for (DoseEstimate* one : {&shares.deeper, &shares.passed, &shares.in_band, &shares.beyond_known}) *one = taken.next();
  return shares;
}

void read_depths(const DepthDistribution& found, By by, double layer_depth, std::vector<double>& row) {
  const auto [mean, deviation] = found.moments_above(by, layer_depth);
  row.insert(row.end(), {mean, deviation});
  for (const double share : {0.1, 0.5, 0.9}) row.push_back(found.quantile_above(by, layer_depth, share));
}

DoseDepths take_depths(Taken& taken) {
  DoseDepths depths;
  for (DoseEstimate* one : {&depths.mean, &depths.deviation, &depths.tenth, &depths.median, &depths.ninetieth})
    *one = taken.next();
  return depths;
}

VectorXd as_vector(const std::vector<double>& row) {
  return Eigen::Map<const VectorXd>(row.data(), static_cast<Index>(row.size()));
}

VectorXd all_shares(const DepthDistribution& found, const DoseQuestion& question) {
  std::vector<double> row;
  for (const By by : {By::number, By::mass}) read_shares(found, by, question, row);
  return as_vector(row);
}

// Even steps down to where nearly all of it ends.
std::vector<double> depths_to_show(const DepthDistribution& best, const DoseQuestion& question) {
  double deepest = std::max(best.quantile_above(By::mass, question.layer_depth, deepest_shown),
                            best.quantile_above(By::number, question.layer_depth, deepest_shown));
  if (!std::isfinite(deepest)) deepest = question.layer_depth;
  if (question.band) deepest = std::max(deepest, question.band->to);
  if (!question.ends.empty()) deepest = std::max(deepest, question.ends.back());
  std::vector<double> depths;
  for (int k = 0; k <= curve_points; ++k)
    depths.push_back(std::min(question.layer_depth, 1.02 * deepest) * k / curve_points);
  return depths;
}

}  // namespace

std::vector<Draw> draws_of(const ForwardModel& model, Index points, int fewest) {
  const auto rounds = static_cast<int>((fewest + points - 1) / points), count = rounds * static_cast<int>(points);
  const MatrixXd uniform = sobol_points(count, 2, 1);
  std::vector<Draw> draws;
  for (int k = 0; k < count; ++k) {
    Draw draw{.point = k % points, .error = normal_quantile(uniform(k, 0)), .scatter = model.scatter};
    if (model.freedom > 0)
      draw.scatter = std::min(
          most_scatter, model.scatter * std::sqrt(model.freedom / chi_squared_quantile(uniform(k, 1), model.freedom)));
    draws.push_back(draw);
  }
  draws.front() = {.point = 0, .error = 0, .scatter = model.scatter};
  return draws;
}

MatrixXd readings_of(const std::vector<ParticleClass>& classes, const DepthTable& table, const std::vector<Draw>& draws,
                     const Bounce& bounce, const Readings& readings) {
  std::vector<PowderParticle> lows, highs;
  for (const ParticleClass& one : classes) {
    lows.push_back(one.low);
    highs.push_back(one.high);
  }
  const MatrixXd low = table.at(lows), high = table.at(highs);
  MatrixXd found;
  for (std::size_t k = 0; k < draws.size(); ++k) {
    const auto& [point, error, scatter] = draws[k];
    const VectorXd at_low = low.row(point) + error * low.row(table.points()),
                   at_high = high.row(point) + error * high.row(table.points());
    const VectorXd row = readings(DepthDistribution(classes, at_low, at_high, bounce, scatter));
    if (k == 0) found.resize(static_cast<Index>(draws.size()), row.size());
    found.row(static_cast<Index>(k)) = row;
  }
  return found;
}

DoseEstimate estimate_of(const Eigen::Ref<const VectorXd>& of_draws, double level) {
  std::vector<double> sorted;
  for (const double one : of_draws)
    if (std::isfinite(one)) sorted.push_back(one);
  if (sorted.empty()) return {of_draws[0], of_draws[0], of_draws[0]};
  std::ranges::sort(sorted);
  const auto quantile = [&](double share) {
    return gsl_stats_quantile_from_sorted_data(sorted.data(), 1, sorted.size(), share);
  };
  return {of_draws[0], quantile(0.5 - level / 2), quantile(0.5 + level / 2)};
}

Dose dose_of(const Powder& powder, const ForwardModel& model, const DoseQuestion& question) {
  const Fineness fine;
  const auto classes = classes_of(powder, fine);
  const DepthTable table(model, box_of(classes));
  const auto draws = draws_of(model, table.points(), fewest_draws);
  const std::vector best{draws.front()};
  std::vector<double> depths;
  const auto look = [&](const DepthDistribution& found) {
    depths = depths_to_show(found, question);
    return all_shares(found, question);
  };
  const auto shares_at_best = readings_of(classes, table, best, question.bounce, look);
  const MatrixXd all = readings_of(classes, table, draws, question.bounce, [&](const DepthDistribution& found) {
    std::vector<double> row;
    for (const By by : {By::number, By::mass}) {
      read_shares(found, by, question, row);
      read_depths(found, by, question.layer_depth, row);
      for (const double depth : depths) row.push_back(found.above(by, depth));
    }
    return as_vector(row);
  });
  Dose dose;
  for (const double depth : depths) dose.curve.push_back({depth, {}, {}});
  Taken taken(all, question.level);
  dose.number_shares = take_shares(taken, question.ends.size());
  dose.number_depths = take_depths(taken);
  for (DosePoint& point : dose.curve) point.number = taken.next();
  dose.mass_shares = take_shares(taken, question.ends.size());
  dose.mass_depths = take_depths(taken);
  for (DosePoint& point : dose.curve) point.mass = taken.next();
  const auto fewer = classes_of(powder, {.cells = fine.cells / 2, .values = 3 * fine.values / 4});
  dose.integration_error =
      (readings_of(fewer, table, best, question.bounce, look) - shares_at_best).cwiseAbs().maxCoeff();
  return dose;
}

std::vector<SpreadSource> spread_by_source(const Powder& powder, const ForwardModel& model,
                                           const DoseQuestion& question) {
  std::vector<SpreadSource> sources;
  const auto add = [&](const std::string& name, const Powder& of, double scatter) {
    ForwardModel varied = model;
    varied.scatter = scatter;
    const auto classes = classes_of(of, {.cells = 240, .values = 8});
    const DepthTable table(varied, box_of(classes));
    const MatrixXd found = readings_of(classes, table, draws_of(varied, table.points(), fewest_draws), question.bounce,
                                       [&](const DepthDistribution& one) {
                                         const auto [mean, deviation] =
                                             one.moments_above(By::number, question.layer_depth);
                                         return VectorXd(Eigen::Vector2d(mean, deviation));
                                       });
    sources.push_back({name, estimate_of(found.col(1), question.level), estimate_of(found.col(0), question.level)});
  };
  const Powder even{spread_by(powder.radius, 0), spread_by(powder.density, 0), spread_by(powder.speed, 0),
                    powder.by_size};
  const auto alone = [&](Distribution Powder::*which) {
    Powder one = even;
    one.*which = powder.*which;
    return one;
  };
  add("all", powder, model.scatter);
  if (!is_one_value(powder.radius)) add("size", alone(&Powder::radius), 0);
  if (!is_one_value(powder.density)) add("density", alone(&Powder::density), 0);
  if (!is_one_value(powder.speed)) add("speed", alone(&Powder::speed), 0);
  if (model.scatter > 0) add("scatter", even, model.scatter);
  return sources;
}

}  // namespace percal
