#include "percal/fit/relaxation/relaxing_curves.hpp"

namespace percal {
namespace {

// The convolution of both components with one exponential, and its derivatives.
struct Memory {
  IsochoricStress stress{}, by_alpha{}, by_log_time{};

  void advance(const HereditaryStep& step, const UnitIsochoric& before, const UnitIsochoric& now) {
    for (std::size_t c = 0; c < 2; ++c) {
      const double change = now.stress[c] - before.stress[c];
      by_log_time[c] = step.decay * by_log_time[c] + step.decay_slope * stress[c] + step.taken_slope * change;
      stress[c] = step.decay * stress[c] + step.taken * change;
      by_alpha[c] = step.decay * by_alpha[c] + step.taken * (now.by_alpha[c] - before.by_alpha[c]);
    }
  }
};

}  // namespace

std::vector<RelaxingRow> relaxing_rows(const CurveData& data, const std::vector<History>& histories) {
  std::vector<RelaxingRow> rows;
  rows.reserve(data.points.size());
  for (const History& history : histories) {
    double last = history.start;
    for (std::size_t i = history.begin; i < history.end; ++i) {
      const StressPoint& point = data.points[i];
      rows.push_back({isochoric_state(point.strained), *point.time - last, i == history.begin});
      last = *point.time;
    }
  }
  return rows;
}

UnitHistory unit_history(const std::vector<RelaxingRow>& rows, double alpha, const std::vector<double>& times) {
  const auto count = static_cast<Eigen::Index>(rows.size()), terms = static_cast<Eigen::Index>(times.size());
  UnitHistory unit{Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::MatrixXd(count, terms),
                   Eigen::MatrixXd(count, terms), Eigen::MatrixXd(count, terms)};
  std::vector<Memory> memories(times.size());
  UnitIsochoric before{};
  for (Eigen::Index i = 0; i < count; ++i) {
    const RelaxingRow& row = rows[static_cast<std::size_t>(i)];
    if (row.first) before = {}, memories.assign(times.size(), {});
    const UnitIsochoric now = unit_isochoric(alpha, row.state);
    unit.elastic(i) = nominal_of(now.stress, row.state);
    unit.elastic_by_alpha(i) = nominal_of(now.by_alpha, row.state);
    for (std::size_t k = 0; k < times.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      memories[k].advance(hereditary_step(row.elapsed, times[k]), before, now);
      unit.convolved(i, column) = nominal_of(memories[k].stress, row.state);
      unit.convolved_by_alpha(i, column) = nominal_of(memories[k].by_alpha, row.state);
      unit.convolved_by_log_time(i, column) = nominal_of(memories[k].by_log_time, row.state);
    }
    before = now;
  }
  return unit;
}

Eigen::VectorXd relaxing_stress(const std::vector<RelaxingRow>& rows, const RelaxingSolid& solid) {
  std::vector<double> times;
  for (const PronyTerm& term : solid.series.terms) times.push_back(term.time);
  Eigen::VectorXd stress = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.size()));
  for (const Ogden& term : solid.instantaneous.terms) {
    const UnitHistory unit = unit_history(rows, term.alpha, times);
    Eigen::VectorXd sum = lasting_share(solid.series) * unit.elastic;
    for (std::size_t k = 0; k < times.size(); ++k)
      sum += solid.series.terms[k].share * unit.convolved.col(static_cast<Eigen::Index>(k));
    stress += term.mu * sum;
  }
  return stress;
}

}  // namespace percal
