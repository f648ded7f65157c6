#include "percal/fit/relaxation/relaxation_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "percal/fit/search/moduli.hpp"

namespace percal {
namespace {

constexpr int steps_of_alpha = 40;         // of the scan to either side of 0
constexpr double times_in_a_decade = 2.5;  // of the scan
constexpr int fewest_times = 6, most_times = 14;
constexpr std::size_t most_starts = 6;
constexpr double least_start_share = 0.01;  // a term of no share has no slope to leave from
constexpr double same_place = 1e-3;         // on the searched scale

std::vector<double> times_to_scan(const TimeScales& scales) {
  const double low = std::log(scales.shortest_interval), high = std::log(scales.longest_record);
  const int count =
      std::clamp(static_cast<int>((high - low) / std::log(10.0) * times_in_a_decade), fewest_times, most_times);
  std::vector<double> times;
  for (int k = 0; k < count; ++k) times.push_back(std::exp(low + (k + 0.5) / count * (high - low)));
  return times;
}

// Weighted stresses of the points for a shape: elastic, then convolved with each time.
Eigen::MatrixXd columns_of(const RelaxationData& data, const Hyperelastic& shape, const std::vector<double>& times) {
  Eigen::MatrixXd all =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(data.rows.size()), static_cast<Eigen::Index>(times.size()) + 1);
  for (const Ogden& term : shape.terms) {
    const UnitHistory unit = unit_history(data.rows, term.alpha, times);
    all.col(0) += term.mu * unit.elastic;
    all.rightCols(unit.convolved.cols()) += term.mu * unit.convolved;
  }
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(data.points.points.size()), all.cols());
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    columns.row(i) = data.points.points[k].weight * all.row(static_cast<Eigen::Index>(data.points.rows[k]));
  }
  return columns;
}

struct Scanned {
  int shape;
  std::vector<int> times;  // indices, rising
  Moduli moduli;           // long-term, then of each term
};

// All sets of `size` rising indices below `count`.
std::vector<std::vector<int>> index_sets(int size, int count) {
  std::vector<std::vector<int>> sets{{}};
  for (int k = 0; k < size; ++k) {
    std::vector<std::vector<int>> longer;
    for (const auto& set : sets)
      for (int i = set.empty() ? 0 : set.back() + 1; i < count; ++i) {
        longer.push_back(set);
        longer.back().push_back(i);
      }
    sets = std::move(longer);
  }
  return sets;
}

std::vector<Scanned> scanned(const RelaxationData& data, const std::vector<Hyperelastic>& shapes,
                             const std::vector<double>& times, int terms) {
  const Eigen::VectorXd stress = weighted_stress(data.points.points);
  const auto sets = index_sets(terms, static_cast<int>(times.size()));
  std::vector<Scanned> all;
  for (int s = 0; s < static_cast<int>(shapes.size()); ++s) {
    const Eigen::MatrixXd columns = columns_of(data, shapes[static_cast<std::size_t>(s)], times);
    if (!columns.allFinite()) continue;
    for (const auto& set : sets) {
      std::vector<int> chosen{0};
      for (const int i : set) chosen.push_back(i + 1);
      const Moduli moduli = best_moduli(columns(Eigen::all, chosen), stress, Signs::positive, {});
      if (std::isfinite(moduli.objective) && moduli.mu.sum() > 0) all.push_back({s, set, moduli});
    }
  }
  std::ranges::sort(all, {}, [](const Scanned& one) { return one.moduli.objective; });
  return all;
}

bool near(const Scanned& one, const Scanned& other) {
  if (std::abs(one.shape - other.shape) > 2) return false;
  for (std::size_t k = 0; k < one.times.size(); ++k)
    if (std::abs(one.times[k] - other.times[k]) > 1) return false;
  return true;
}

RelaxingSolid solid_of(const Scanned& candidate, const Hyperelastic& shape, const std::vector<double>& times,
                       double scale) {
  const double whole = candidate.moduli.mu.sum();
  RelaxingSolid solid{shape, {}};
  for (Ogden& term : solid.instantaneous.terms) term.mu *= whole * scale;
  const auto terms = static_cast<double>(candidate.times.size());
  for (std::size_t k = 0; k < candidate.times.size(); ++k) {
    const double share = candidate.moduli.mu[static_cast<Eigen::Index>(k) + 1] / whole;
    solid.series.terms.push_back({std::clamp(share, least_start_share, 1 - least_start_share * terms),
                                  times[static_cast<std::size_t>(candidate.times[k])]});
  }
  const double sum = 1 - lasting_share(solid.series);
  for (PronyTerm& term : solid.series.terms) term.share *= std::min(1.0, (1 - least_start_share) / sum);
  return solid;
}

void sort_by_time(RelaxingSolid& solid) { std::ranges::sort(solid.series.terms, {}, &PronyTerm::time); }

bool same(const RelaxationMinimum& one, const RelaxationMinimum& other) {
  return (one.minimum.searched - other.minimum.searched).cwiseAbs().maxCoeff() < same_place;
}

}  // namespace

std::vector<Hyperelastic> shapes_to_scan(Model model, const CurveFit& rate_blind) {
  std::vector<Hyperelastic> shapes;
  if (model == Model::neo_hooke) return {{{{1, 2}}}};
  if (model == Model::ogden) {
    for (int k = -steps_of_alpha; k <= steps_of_alpha; ++k)
      shapes.push_back({{{1, k * largest_alpha / steps_of_alpha}}});
    return shapes;
  }
  for (const CurveMinimum& minimum : rate_blind.minima) {
    if (static_cast<int>(minimum.solid.terms.size()) != terms_of(model)) continue;
    shapes.push_back(minimum.solid);
    for (Ogden& term : shapes.back().terms) term.mu /= small_strain_modulus(minimum.solid);
  }
  return shapes;
}

std::vector<Hyperelastic> shapes_about(Model model, const std::vector<RelaxationMinimum>& minima) {
  std::vector<Hyperelastic> shapes;
  for (const RelaxationMinimum& minimum : minima)
    for (const double step : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
      if (step != 0 && model != Model::ogden) continue;
      Hyperelastic shape = minimum.solid.instantaneous;
      const double modulus = small_strain_modulus(shape);
      for (Ogden& term : shape.terms) term.mu /= modulus, term.alpha += step;
      shapes.push_back(shape);
    }
  return shapes;
}

RelaxationParameters usual_parameters(Model model, int terms) {
  RelaxationParameters parameters{.model = model, .order = std::vector<int>(static_cast<std::size_t>(terms))};
  std::iota(parameters.order.begin(), parameters.order.end(), 0);
  return parameters;
}

std::vector<RelaxationMinimum> relaxation_minima(const std::shared_ptr<const RelaxationData>& data, Model model,
                                                 int terms, const std::vector<Hyperelastic>& shapes) {
  const std::vector<double> times = times_to_scan(data->scales);
  const RelaxationParameters parameters = usual_parameters(model, terms);
  std::vector<Scanned> starts;
  for (Scanned& candidate : scanned(*data, shapes, times, terms)) {
    if (starts.size() == most_starts) break;
    if (std::ranges::none_of(starts, [&](const Scanned& start) { return near(start, candidate); }))
      starts.push_back(std::move(candidate));
  }
  std::vector<RelaxationMinimum> minima;
  for (const Scanned& start : starts) {
    RelaxingSolid solid = solid_of(start, shapes[static_cast<std::size_t>(start.shape)], times, data->points.scale);
    const CalibrationProblem problem = relaxation_problem(data, parameters, solid, ErrorSource::residuals);
    Minimum minimum = refine(problem, searched(problem, parameters, solid), {}, {});
    solid = solid_at(parameters, minimum.searched);
    if (!std::ranges::is_sorted(solid.series.terms, {}, &PronyTerm::time)) {
      sort_by_time(solid);
      minimum = refine(problem, searched(problem, parameters, solid), {}, {});
      solid = solid_at(parameters, minimum.searched);
    }
    const RelaxationMinimum found{solid, minimum};
    if (std::ranges::none_of(minima, [&](const RelaxationMinimum& other) { return same(other, found); }))
      minima.push_back(found);
  }
  std::ranges::stable_sort(minima, {}, [](const RelaxationMinimum& one) { return one.minimum.deviance; });
  return minima;
}

}  // namespace percal
