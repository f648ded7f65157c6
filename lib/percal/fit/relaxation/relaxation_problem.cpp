#include "percal/fit/relaxation/relaxation_problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace percal {
namespace {

// Shares of one whole that are broken off one after another, and what is left.
struct Broken {
  Eigen::VectorXd share;
  Eigen::MatrixXd slope;  // d share_i / d s_m
  double rest = 1;
  Eigen::VectorXd rest_slope;
};

Broken broken(const Eigen::VectorXd& pieces) {
  const Eigen::Index n = pieces.size();
  Broken found{Eigen::VectorXd(n), Eigen::MatrixXd::Zero(n, n), 1, Eigen::VectorXd::Zero(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    found.share(i) = found.rest * pieces(i);
    found.slope.row(i) = found.rest_slope.transpose() * pieces(i);
    found.slope(i, i) = found.rest;
    found.rest_slope *= 1 - pieces(i);
    found.rest_slope(i) = -found.rest;
    found.rest *= 1 - pieces(i);
  }
  return found;
}

Eigen::VectorXd pieces_of(const std::vector<double>& shares, Eigen::Index count) {
  Eigen::VectorXd pieces(count);
  double rest = 1;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double share = shares[static_cast<std::size_t>(i)];
    pieces(i) = rest > 0 ? std::clamp(share / rest, 0.0, 1.0) : 0.0;
    rest -= share;
  }
  return pieces;
}

// What a searched vector means.
struct Meaning {
  double modulus;  // of all terms, instantaneous
  Broken weights;  // of the terms but the last, whose is the rest
  std::vector<double> alphas;
  Broken shares;  // in the order of the parameters
  std::vector<double> times;

  double weight(int term) const { return term < weights.share.size() ? weights.share(term) : weights.rest; }
  double weight_slope(int term, Eigen::Index piece) const {
    return term < weights.share.size() ? weights.slope(term, piece) : weights.rest_slope(piece);
  }
};

Meaning meaning_of(const RelaxationParameters& parameters, const Eigen::VectorXd& at) {
  Meaning meaning{std::exp(at[0]),
                  broken(at.segment(1, parameters.terms() - 1)),
                  fixed_alphas(parameters.model),
                  broken(at.segment(parameters.first_share(), parameters.relaxing())),
                  {}};
  for (int k = 0; k < parameters.alphas(); ++k) meaning.alphas.push_back(at[parameters.first_alpha() + k]);
  for (int k = 0; k < parameters.relaxing(); ++k) meaning.times.push_back(std::exp(at[parameters.first_time() + k]));
  if (parameters.leads == LeadingModulus::long_term) meaning.modulus /= meaning.shares.rest;
  return meaning;
}

// The weighted stresses of the points and their derivatives.                                            (5)
struct RelaxingModel {
  std::shared_ptr<const RelaxationData> data;
  RelaxationParameters parameters;

  ModelAnswer operator()(const Eigen::VectorXd& at, Want) const {
    const Meaning meaning = meaning_of(parameters, at);
    const auto rows = static_cast<Eigen::Index>(data->rows.size());
    Eigen::VectorXd stress = Eigen::VectorXd::Zero(rows);
    Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(rows, at.size());
    for (int k = 0; k < parameters.terms(); ++k) add_term(k, meaning, stress, slope);
    slope.col(0) = stress;
    if (parameters.leads == LeadingModulus::long_term)
      for (int m = 0; m < parameters.relaxing(); ++m)
        slope.col(parameters.first_share() + m) -= stress * (meaning.shares.rest_slope(m) / meaning.shares.rest);
    return of_points(stress, slope);
  }

 private:
  void add_term(int term, const Meaning& meaning, Eigen::VectorXd& stress, Eigen::MatrixXd& slope) const {
    const Broken& shares = meaning.shares;
    const UnitHistory unit = unit_history(data->rows, meaning.alphas[static_cast<std::size_t>(term)], meaning.times);
    const double modulus = meaning.modulus * meaning.weight(term);
    Eigen::VectorXd left = shares.rest * unit.elastic, by_alpha = shares.rest * unit.elastic_by_alpha;
    for (int i = 0; i < parameters.relaxing(); ++i) {
      const int whose = parameters.order[static_cast<std::size_t>(i)];
      left += shares.share(i) * unit.convolved.col(whose);
      by_alpha += shares.share(i) * unit.convolved_by_alpha.col(whose);
      slope.col(parameters.first_time() + whose) += modulus * shares.share(i) * unit.convolved_by_log_time.col(whose);
    }
    stress += modulus * left;
    for (Eigen::Index piece = 0; piece < meaning.weights.share.size(); ++piece)
      slope.col(1 + piece) += meaning.modulus * meaning.weight_slope(term, piece) * left;
    if (parameters.alphas() > 0) slope.col(parameters.first_alpha() + term) += modulus * by_alpha;
    for (int m = 0; m < parameters.relaxing(); ++m) {
      auto column = slope.col(parameters.first_share() + m);
      column += modulus * shares.rest_slope(m) * unit.elastic;
      for (int i = 0; i < parameters.relaxing(); ++i)
        column += modulus * shares.slope(i, m) * unit.convolved.col(parameters.order[static_cast<std::size_t>(i)]);
    }
  }

  ModelAnswer of_points(const Eigen::VectorXd& stress, const Eigen::MatrixXd& slope) const {
    const auto count = static_cast<Eigen::Index>(data->points.points.size());
    ModelAnswer answer{Eigen::VectorXd(count), Eigen::MatrixXd(count, slope.cols()), {}};
    for (Eigen::Index i = 0; i < count; ++i) {
      const WeightedPoint& point = data->points.points[static_cast<std::size_t>(i)];
      const double weight = point.weight / data->points.scale;
      const auto row = static_cast<Eigen::Index>(data->points.rows[static_cast<std::size_t>(i)]);
      answer.value[i] = weight * stress[row];
      answer.jacobian.row(i) = weight * slope.row(row);
    }
    return answer;
  }
};

FreeParameter parameter(std::string name, double low, double high) {
  FreeParameter free;
  free.name = std::move(name);
  free.low = low;
  free.high = high;
  free.logarithmic = false;
  return free;
}

FreeParameter positive_parameter(std::string name, std::string unit, double low, double high) {
  FreeParameter free = parameter(std::move(name), low, high);
  free.unit = std::move(unit);
  free.logarithmic = true;
  return free;
}

double modulus_of(const RelaxationParameters& parameters, const RelaxingSolid& solid) {
  const double instantaneous = small_strain_modulus(solid.instantaneous);
  return parameters.leads == LeadingModulus::instantaneous
             ? instantaneous
             : instantaneous * std::max(lasting_share(solid.series), 1 - largest_share);
}

std::string with_number(const std::string& symbol, int number) { return symbol + "_" + std::to_string(number); }

std::vector<FreeParameter> free_parameters(const RelaxationData& data, const RelaxationParameters& parameters,
                                           const RelaxingSolid& start) {
  const double modulus = modulus_of(parameters, start);
  const bool even = even_in_alpha(data.points), several = parameters.terms() > 1;
  std::vector<FreeParameter> all;
  all.push_back(positive_parameter(parameters.leads == LeadingModulus::instantaneous ? "mu_0" : "mu_inf", "Pa",
                                   modulus / modulus_reach, modulus * modulus_reach));
  for (int k = 1; k < parameters.terms(); ++k) all.push_back(parameter(with_number("part", k), 0, 1));
  for (int k = 0; k < parameters.alphas(); ++k) {
    const double alpha = start.instantaneous.terms[static_cast<std::size_t>(k)].alpha;
    all.push_back(parameter(several ? with_number("alpha", k + 1) : "alpha", even && alpha >= 0 ? 0 : -largest_alpha,
                            even && alpha < 0 ? 0 : largest_alpha));
  }
  for (const int whose : parameters.order) all.push_back(parameter(with_number("g", whose + 1), 0, largest_share));
  for (int k = 0; k < parameters.relaxing(); ++k)
    all.push_back(positive_parameter(with_number("tau", k + 1), "s", data.scales.shortest_interval / beyond_the_record,
                                     data.scales.longest_record * beyond_the_record));
  return all;
}

}  // namespace

CalibrationProblem relaxation_problem(std::shared_ptr<const RelaxationData> data,
                                      const RelaxationParameters& parameters, const RelaxingSolid& start,
                                      ErrorSource errors) {
  const bool known = errors == ErrorSource::standard_errors;
  CalibrationProblem problem;
  problem.groups.push_back({.name = "points", .estimated = !known, .fixed = 0});
  for (const auto& point : data->points.points)
    problem.data.push_back({.label = "", .value = point.weight * point.stress, .error = known ? 1.0 : 0.0});
  problem.parameters = free_parameters(*data, parameters, start);
  problem.model = RelaxingModel{std::move(data), parameters};
  return problem;
}

Eigen::VectorXd searched(const CalibrationProblem& problem, const RelaxationParameters& parameters,
                         const RelaxingSolid& solid) {
  Eigen::VectorXd natural(parameters.count());
  natural[0] = modulus_of(parameters, solid);
  std::vector<double> weights, shares;
  for (const Ogden& term : solid.instantaneous.terms)
    weights.push_back(term.mu / small_strain_modulus(solid.instantaneous));
  for (const int whose : parameters.order) shares.push_back(solid.series.terms[static_cast<std::size_t>(whose)].share);
  natural.segment(1, parameters.terms() - 1) = pieces_of(weights, parameters.terms() - 1);
  for (int k = 0; k < parameters.alphas(); ++k)
    natural[parameters.first_alpha() + k] = solid.instantaneous.terms[static_cast<std::size_t>(k)].alpha;
  natural.segment(parameters.first_share(), parameters.relaxing()) = pieces_of(shares, parameters.relaxing());
  for (int k = 0; k < parameters.relaxing(); ++k)
    natural[parameters.first_time() + k] = solid.series.terms[static_cast<std::size_t>(k)].time;
  Eigen::VectorXd at(natural.size());
  for (Eigen::Index k = 0; k < at.size(); ++k) {
    const FreeParameter& free = problem.parameters[static_cast<std::size_t>(k)];
    at[k] = free.searched(std::clamp(natural[k], free.low, free.high));
  }
  return at;
}

RelaxingSolid solid_at(const RelaxationParameters& parameters, const Eigen::VectorXd& at) {
  const Meaning meaning = meaning_of(parameters, at);
  RelaxingSolid solid;
  for (int k = 0; k < parameters.terms(); ++k)
    solid.instantaneous.terms.push_back(
        {meaning.modulus * meaning.weight(k), meaning.alphas[static_cast<std::size_t>(k)]});
  solid.series.terms.resize(parameters.order.size());
  for (int i = 0; i < parameters.relaxing(); ++i) {
    const auto whose = static_cast<std::size_t>(parameters.order[static_cast<std::size_t>(i)]);
    solid.series.terms[whose] = {meaning.shares.share(i), meaning.times[whose]};
  }
  return solid;
}

}  // namespace percal
