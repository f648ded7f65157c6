#include "percal/fit/relaxation/fit_relaxation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "percal/base/error.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr int scanned_in_full = 2;          // terms up to which every exponent is scanned with every set of times
constexpr double widest_known_share = 0.5;  // a share whose interval is wider is as good as unknown

void refuse_what_does_not_relax(const CurveData& data, const CurveOptions& options) {
  if (options.loss != Loss::squares)
    throw BadInput({"", 0, "--loss"}, word(options.loss) + " beside --relaxation", "squares");
  if (options.signs == Signs::free)
    throw BadInput({"", 0, "--unconstrained"}, "moduli of any sign beside --relaxation", "positive moduli");
  for (const StressPoint& point : data.points)
    if (!point.time)
      throw BadInput("found rows without times; accepted: the time of every row beside a relaxation that is fitted");
}

std::shared_ptr<const RelaxationData> data_of(const CurveData& data, const CurveOptions& options,
                                              const std::vector<History>& histories) {
  return std::make_shared<const RelaxationData>(RelaxationData{curve_problem(data, options.residual, options.weighting),
                                                               relaxing_rows(data, histories),
                                                               time_scales(data, histories)});
}

// 1 - SSE/SST in nominal stress, unweighted.                                          docs/theory/curves.md (15)
std::optional<double> r2_of(const CurveProblem& problem, const Eigen::VectorXd& model) {
  double sum = 0, sse = 0, sst = 0;
  for (const auto& point : problem.points) sum += point.stress;
  const double mean = sum / static_cast<double>(problem.points.size());
  for (std::size_t k = 0; k < problem.points.size(); ++k) {
    const double stress = problem.points[k].stress;
    const double error = stress - model[static_cast<Eigen::Index>(problem.rows[k])] / problem.scale;
    sse += error * error;
    sst += (stress - mean) * (stress - mean);
  }
  return sst > 0 && std::isfinite(sse / sst) ? std::optional(1 - sse / sst) : std::nullopt;
}

RelaxationRung rung_of(const RelaxationData& data, const RelaxationParameters& parameters,
                       const RelaxationMinimum& best) {
  const double sum = best.sum_of_squares();
  return {.terms = parameters.relaxing(),
          .objective = sum * data.points.objective_unit,
          .aicc = aicc(sum, data.points.points.size(), parameters.count()),
          .r2 = r2_of(data.points, relaxing_stress(data.rows, best.solid))};
}

struct Ladder {
  std::vector<RelaxationRung> rungs;
  std::vector<std::vector<RelaxationMinimum>> minima;  // of 0 terms, 1, ..
};

// Up from the solid that knows no time, as far as asked or as the points hold the parameters.
Ladder climbed(const std::shared_ptr<const RelaxationData>& data, const CurveFit& rate_blind, int most) {
  const Model model = rate_blind.options.model;
  Ladder ladder;
  ladder.minima.push_back({});
  if (!rate_blind.minima.empty())
    ladder.rungs.push_back({.terms = 0,
                            .objective = rate_blind.minima[0].objective,
                            .aicc = rate_blind.aicc,
                            .r2 = rate_blind.minima[0].r2});
  for (int terms = 1; terms <= most; ++terms) {
    const RelaxationParameters parameters = usual_parameters(model, terms);
    if (static_cast<int>(data->points.points.size()) <= parameters.count() + 1) break;
    const auto shapes =
        terms <= scanned_in_full ? shapes_to_scan(model, rate_blind) : shapes_about(model, ladder.minima.back());
    auto minima = relaxation_minima(data, model, terms, shapes);
    if (minima.empty()) break;
    ladder.rungs.push_back(rung_of(*data, parameters, minima.front()));
    ladder.minima.push_back(std::move(minima));
  }
  return ladder;
}

int best_by_aicc(const std::vector<RelaxationRung>& rungs) {
  const RelaxationRung* best = nullptr;
  for (const RelaxationRung& rung : rungs)
    if (rung.aicc && (!best || *rung.aicc < *best->aicc)) best = &rung;
  return best ? best->terms : rungs.back().terms;
}

int chosen_terms(const Ladder& ladder, const RelaxationChoice& choice, Model model) {
  const int reached = static_cast<int>(ladder.minima.size()) - 1;
  if (!choice.terms) return ladder.rungs.empty() ? 0 : best_by_aicc(ladder.rungs);
  if (reached < *choice.terms)
    throw BadInput({"", 0, "--relaxation"},
                   fmt::format("{} terms, of which {} can be fitted to these points", *choice.terms, reached),
                   fmt::format("fewer terms, or more rows than the {} parameters of {} with {} terms",
                               usual_parameters(model, *choice.terms).count(), word(model), *choice.terms));
  return *choice.terms;
}

// The interval of one parameter in a set of parameters of its own.
class Intervals {
 public:
  Intervals(const std::shared_ptr<const RelaxationData>& data, RelaxationFit& fit) : data_(data), fit_(fit) {}

  void add(const RelaxationParameters& parameters, std::initializer_list<int> which) {
    const CalibrationProblem problem = relaxation_problem(data_, parameters, fit_.minima.front().solid, fit_.errors);
    std::vector<Minimum> minima;
    for (const RelaxationMinimum& one : fit_.minima)
      if (&one == &fit_.minima.front() || one.minimum.converged)
        minima.push_back(refine(problem, searched(problem, parameters, one.solid), {}, {}));
    for (const int k : which) add(problem, minima, k);
  }

 private:
  void add(const CalibrationProblem& problem, const std::vector<Minimum>& minima, int k) {
    const FreeParameter& free = problem.parameters[static_cast<std::size_t>(k)];
    const ProfileInterval found = region_interval(problem, minima, k, fit_.level);
    const double width = found.interval.high - found.interval.low;
    const bool known =
        !free.unit.empty() || width <= (free.name.starts_with("g_") ? widest_known_share : hopeless_width);
    fit_.parameters.push_back({.name = free.name,
                               .unit = free.unit,
                               .value = free.natural(minima.front().searched[k]),
                               .interval = found.interval,
                               .searched_low = free.low,
                               .searched_high = free.high,
                               .identifiable = found.identifiable && known,
                               .bootstrap = {}});
    fit_.regions.push_back(found.region);
  }

  const std::shared_ptr<const RelaxationData>& data_;
  RelaxationFit& fit_;
};

// mu_0, mu_inf, the exponents, the shares, the times.
void add_intervals(const std::shared_ptr<const RelaxationData>& data, Model model, RelaxationFit& fit) {
  const RelaxationParameters usual = usual_parameters(model, fit.terms);
  Intervals intervals(data, fit);
  intervals.add(usual, {0});
  RelaxationParameters other = usual;
  other.leads = LeadingModulus::long_term;
  intervals.add(other, {0});
  for (int k = 0; k < usual.alphas(); ++k) intervals.add(usual, {usual.first_alpha() + k});
  for (int k = 0; k < fit.terms; ++k) {
    other = usual;
    std::rotate(other.order.begin(), other.order.begin() + k, other.order.begin() + k + 1);
    intervals.add(other, {usual.first_share()});
  }
  for (int k = 0; k < fit.terms; ++k) intervals.add(usual, {usual.first_time() + k});
}

void add_statistics(const std::shared_ptr<const RelaxationData>& data, const CurveFit& rate_blind, RelaxationFit& fit,
                    const std::optional<UncertaintyOptions>& intervals) {
  const CurveProblem& problem = data->points;
  const Minimum& best = fit.minima.front().minimum;
  const double sum = best.residual.squaredNorm();
  fit.degrees_of_freedom =
      static_cast<int>(problem.points.size()) - usual_parameters(rate_blind.options.model, fit.terms).count();
  fit.errors = error_source(problem, rate_blind.options, sum, fit.degrees_of_freedom);
  fit.scatter = std::sqrt(sum / fit.degrees_of_freedom * problem.objective_unit);
  fit.neighbour_correlation = neighbour_correlation(problem, best.residual);
  if (!intervals || lies_on_the_model(problem, sum)) return;
  fit.level = intervals->level;
  add_intervals(data, rate_blind.options.model, fit);
}

std::vector<FittedHistory> fitted(const CurveData& data, const std::vector<History>& histories,
                                  const Eigen::VectorXd& model) {
  std::vector<FittedHistory> all;
  for (const History& history : histories) {
    std::string name = fmt::format("test {}", all.size() + 1);
    if (data.sources.size() > 1)
      name += fmt::format(
          " ({})", std::filesystem::path(data.sources[static_cast<std::size_t>(history.source)].file).stem().string());
    all.push_back({history,
                   name,
                   {model.begin() + static_cast<std::ptrdiff_t>(history.begin),
                    model.begin() + static_cast<std::ptrdiff_t>(history.end)}});
  }
  return all;
}

}  // namespace

std::optional<RelaxationChoice> relaxation_choice_of(const std::string& text) {
  RelaxationChoice choice;
  if (text == "auto") return choice;
  if (text.size() == 1 && text[0] >= '1' && text[0] <= static_cast<char>('0' + most_relaxation_terms))
    return RelaxationChoice{text[0] - '0'};
  return std::nullopt;
}

std::string word(const RelaxationChoice& choice) { return choice.terms ? std::to_string(*choice.terms) : "auto"; }

RelaxationFit fit_relaxation(const CurveData& data, const CurveFit& rate_blind, const RelaxationChoice& choice,
                             const std::optional<UncertaintyOptions>& intervals) {
  refuse_what_does_not_relax(data, rate_blind.options);
  const std::vector<History> histories = histories_of(data);
  const auto relaxing = data_of(data, rate_blind.options, histories);
  Ladder ladder = climbed(relaxing, rate_blind, choice.terms.value_or(static_cast<int>(most_relaxation_terms)));
  RelaxationFit fit{.choice = choice,
                    .rungs = ladder.rungs,
                    .terms = chosen_terms(ladder, choice, rate_blind.options.model),
                    .scales = relaxing->scales};
  fit.minima = std::move(ladder.minima[static_cast<std::size_t>(fit.terms)]);
  const RelaxingSolid solid = !fit.minima.empty()          ? fit.minima.front().solid
                              : !rate_blind.minima.empty() ? RelaxingSolid{rate_blind.minima.front().solid}
                                                           : RelaxingSolid{};
  fit.histories = fitted(data, histories, relaxing_stress(relaxing->rows, solid));
  if (!fit.minima.empty()) add_statistics(relaxing, rate_blind, fit, intervals);
  fit.findings = relaxation_findings(fit);
  const auto starts = starts_in_words(data, histories);
  fit.findings.insert(fit.findings.end(), starts.begin(), starts.end());
  return fit;
}

}  // namespace percal
