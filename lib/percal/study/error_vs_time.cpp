#include "percal/study/error_vs_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <span>

namespace percal {
namespace {

constexpr int resamples = 400;
constexpr double far_extrapolation = 0.1;  // of the depth, from the finest mesh
constexpr double two_sided_95 = 1.96;      // standard errors

bool stopped(const Rung& rung) { return rung.penetration.depth.has_value(); }

// Only meshes finer than the finest that did not stop: a depth that finer meshes do not confirm is none.
std::size_t first_usable(const Ladder& ladder) {
  std::size_t first = ladder.meshes.size();
  while (first > 0 && stopped(ladder.meshes[first - 1])) --first;
  return first;
}

// Pooled over the rungs, with its degrees of freedom.                       docs/theory/errors.md (6)
struct PooledNoise {
  RunNoise of_run;
  int freedom = 0;
};
PooledNoise pooled_noise(std::span<const Rung> rungs, double order) {
  PooledNoise noise{.of_run = {.on_usual_mesh = 1, .order = order}};
  double squares = 0;
  for (const Rung& rung : rungs) {
    const double share = *rung.penetration.spread / *rung.penetration.depth;
    squares += (rung.replicates - 1) * std::pow(share / noise.of_run.on(rung.elements_per_radius), 2);
    noise.freedom += rung.replicates - 1;
  }
  noise.of_run.on_usual_mesh = std::sqrt(squares / noise.freedom);
  return noise;
}

// Over its depth.
double error_of_mean(const Rung& rung, const RunNoise& noise) {
  return noise.on(rung.elements_per_radius) / std::sqrt(rung.replicates);
}

std::vector<GridPoint> points_of(std::span<const Rung> rungs, const RunNoise& noise) {
  std::vector<GridPoint> points;
  for (const Rung& rung : rungs) {
    const double depth = *rung.penetration.depth;
    points.push_back({1.0 / rung.elements_per_radius, depth, depth * error_of_mean(rung, noise)});
  }
  return points;
}

// With a length the order is that of two meshes, docs/theory/errors.md (14): a free one would follow the noise.
std::optional<ErrorForm> form_of(Refinement refinement) {
  return refinement == Refinement::second_order ? std::optional(ErrorForm::second_order) : std::nullopt;
}

// docs/theory/errors.md (7) and (8).
LadderModel model_of(std::span<const GridPoint> points, std::size_t left_out, const GridFit& fit,
                     const RunNoise& noise) {
  LadderModel model{
      .fit = fit, .discretisation = std::vector<double>(points.size()), .irregularity = 0, .noise = noise};
  const double limit = std::abs(fit.limit);
  double noise_squares = 0;
  for (const auto& point : points.subspan(left_out))
    noise_squares += point.standard_error * point.standard_error / static_cast<double>(points.size() - left_out);
  const double scatter = std::sqrt(std::max(0.0, fit.standard_deviation * fit.standard_deviation - noise_squares));
  model.irregularity = scatter / limit;
  double largest = scatter;
  for (std::size_t i = points.size(); i-- > 0;) {
    const auto& point = points[i];
    const double found = point.value - fit.limit, error = point.standard_error;
    const double fitted = i >= left_out ? std::abs(fit.error_at(point.h)) : 0;
    largest = std::max({largest, fitted, std::sqrt(std::max(0.0, found * found - error * error))});
    model.discretisation[i] = largest / limit;
  }
  return model;
}

// The finest meshes, as many as follow a curve; all where no four of them do.
std::size_t first_to_fit(std::span<const GridPoint> points, std::optional<ErrorForm> form) {
  for (std::size_t first = 0; first + fewest_grids <= points.size(); ++first)
    if (grid_convergence(points.subspan(first), form).is_smooth()) return first;
  return 0;
}

LadderModel model_of_noise(std::size_t meshes, const RunNoise& noise) {
  return {.fit = {}, .discretisation = std::vector<double>(meshes), .irregularity = 0, .noise = noise};
}

// As it could have been found: by the chi-squared distribution of its square.
RunNoise drawn(const PooledNoise& noise, std::mt19937_64& random) {
  std::gamma_distribution<double> chi_squared(noise.freedom / 2.0, 2);
  RunNoise other = noise.of_run;
  other.on_usual_mesh *= std::sqrt(chi_squared(random) / noise.freedom);
  return other;
}

// Meshes left out of the fit keep their depths but for their noise.
std::vector<LadderModel> resample(std::span<const GridPoint> points, std::size_t left_out, const GridFit& fit,
                                  std::optional<ErrorForm> form, const PooledNoise& noise) {
  std::mt19937_64 random(resampling_seed);
  std::normal_distribution<double> normal;
  std::vector<LadderModel> models;
  for (const auto& finer : resampled(points.subspan(left_out), fit, resamples, resampling_seed)) {
    std::vector<GridPoint> series(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(left_out));
    for (auto& point : series) point.value += point.standard_error * normal(random);
    series.insert(series.end(), finer.begin(), finer.end());
    models.push_back(model_of(series, left_out, grid_convergence(finer, form).fit, drawn(noise, random)));
  }
  return models;
}

// Without a limit a ladder has noise alone.
std::vector<LadderModel> resample(std::size_t meshes, const PooledNoise& noise) {
  std::mt19937_64 random(resampling_seed);
  std::vector<LadderModel> models;
  for (int k = 0; k < resamples; ++k) models.push_back(model_of_noise(meshes, drawn(noise, random)));
  return models;
}

ErrorBand interval_of(double value, const std::vector<double>& others) {
  return {value, std::min(value, quantile(others, 0.025)), std::max(value, quantile(others, 0.975))};
}

RungError error_of(const Rung& rung, std::size_t i, const ErrorVsTime& study) {
  const double depth = *rung.penetration.depth, h = 1.0 / rung.elements_per_radius;
  const double margin = two_sided_95 * depth * error_of_mean(rung, study.model.noise);
  const double high =
      study.limit.low > 0 ? (depth + margin) / study.limit.low - 1 : std::numeric_limits<double>::infinity();
  RungError error{.signed_error = {depth / study.limit.value - 1, (depth - margin) / study.limit.high - 1, high},
                  .fitted_depth = study.convergence.fit.at(h),
                  .uncertainty = {},
                  .discretisation = study.model.discretisation[i],
                  .combined = {}};
  const std::size_t left_out = study.first_fitted - study.first_used;
  if (i >= left_out) error.uncertainty = study.convergence.uncertainty[i - left_out];
  for (std::size_t c = 0; c < replicate_counts.size(); ++c) {
    const auto combined = [&](const LadderModel& model) {
      return combined_error(model.discretisation[i], model.noise.on(rung.elements_per_radius), replicate_counts[c]);
    };
    std::vector<double> others;
    for (const auto& model : study.resampled) others.push_back(combined(model));
    error.combined[c] = interval_of(combined(study.model), others);
  }
  return error;
}

// The finest mesh's own distance is 0, without noise.
ErrorBand distance_from(const Rung& finest, const Rung& rung, const RunNoise& noise) {
  if (&rung == &finest) return {};
  const double ratio = *rung.penetration.depth / *finest.penetration.depth;
  const double margin = two_sided_95 * ratio * std::hypot(error_of_mean(rung, noise), error_of_mean(finest, noise));
  return {ratio - 1, ratio - 1 - margin, ratio - 1 + margin};
}

// The depth that the used rungs converge to, and their errors against it.
void fit_limit(std::span<const Rung> rungs, const PooledNoise& noise, ErrorVsTime& study) {
  const auto points = points_of(rungs, noise.of_run);
  const auto form = form_of(study.refinement);
  const std::size_t left_out = first_to_fit(points, form);
  study.first_fitted = study.first_used + left_out;
  study.convergence = grid_convergence(std::span(points).subspan(left_out), form);
  if (!study.is_fitted()) return;
  const GridFit& fit = study.convergence.fit;
  study.model = model_of(points, left_out, fit, noise.of_run);
  study.resampled = resample(points, left_out, fit, form, noise);
  std::vector<double> limits;
  for (const auto& model : study.resampled) limits.push_back(model.fit.limit);
  study.limit = interval_of(fit.limit, limits);
  study.limit.low = std::max(0.0, study.limit.low);
  for (std::size_t i = 0; i < rungs.size(); ++i) study.errors.push_back(error_of(rungs[i], i, study));
}

std::string account(const Rung& rung) {
  const auto& outcomes = rung.penetration.outcomes;
  std::vector<std::string> words;
  for (const Outcome outcome : outcomes) words.push_back(word(outcome));
  if (!rung.penetration.mixed) words.resize(1);
  return fmt::format("{} elements per radius: {}{}", rung.elements_per_radius, fmt::join(words, ", "),
                     rung.penetration.mixed ? "" : fmt::format(" ({} runs)", rung.replicates));
}

// Significant ones are worth a sentence.
void add_changes(ErrorVsTime& study) {
  for (const auto& half : study.half_step)
    if (half.is_significant())
      study.findings.push_back(
          fmt::format("half the time step changes the depth by {:+.1f} % at {} elements per radius", 100 * *half.share,
                      half.elements_per_radius));
  if (study.double_precision.is_significant())
    study.findings.push_back(
        fmt::format("double precision changes the depth by {:+.1f} %, more than two standard errors: check single "
                    "precision on more replicates",
                    100 * *study.double_precision.share));
}

void add_findings(const Ladder& ladder, ErrorVsTime& study) {
  for (const Rung& rung : ladder.meshes)
    if (!stopped(rung)) study.findings.push_back(account(rung) + ": no depth");
  const std::size_t used = ladder.meshes.size() - study.first_used;
  if (study.first_used > 0 && used > 0)
    study.findings.push_back(fmt::format(
        "only the {} meshes finer than that are used: a depth that a finer mesh does not confirm is none", used));
  if (!study.has_limit()) {
    study.findings.push_back(
        used > 0
            ? "each element goes by its own value: such depths have no limit in the element's size. A depth belongs "
              "to its mesh, as the erosion limit does; the finest mesh is no better than the others"
            : "the finest mesh has no depth: nothing is said of the others");
    add_changes(study);
    return;
  }
  if (study.convergence.outcome == GridOutcome::fitted && !study.is_fitted()) {
    study.findings.push_back(
        "the depths converge to none above zero: no error is given; a ladder of finer meshes is needed");
    return;
  }
  if (!study.is_fitted()) {
    study.findings.push_back(
        fmt::format("{} meshes stopped; an extrapolation needs {}: no error is given. A depth needs a layer in which "
                    "the particle stops "
                    "(outcomes: docs/formats/impact.md)",
                    used, fewest_grids));
    return;
  }
  const auto& found = study.convergence;
  if (study.first_fitted > study.first_used)
    study.findings.push_back(fmt::format(
        "the fit is over {} elements per radius and more: with coarser meshes the depths scatter about it more "
        "than they change from mesh to mesh",
        ladder.meshes[study.first_fitted].elements_per_radius));
  if (!found.is_smooth())
    study.findings.push_back(fmt::format(
        "the depths scatter about the fitted curve by {:.2g} %, more than they change from mesh to mesh ({:.2g} "
        "%): the order is not known, and the extrapolated depth no better than its interval",
        100 * found.fit.standard_deviation / found.fit.limit, 100 * found.data_range / found.fit.limit));
  if (!found.order_is_reasonable)
    study.findings.push_back(fmt::format("the observed order {:.2g} is not between 0.5 and 2: fitted with {} instead",
                                         found.observed_order, word(found.fit.form)));
  const double beyond = ladder.meshes.back().penetration.depth.value() / study.limit.value - 1;
  if (std::abs(beyond) > far_extrapolation || study.limit.low <= 0)
    study.findings.push_back(fmt::format(
        "the finest mesh's depth is {:+.0f} % from the extrapolated one: a ladder of finer meshes is needed",
        100 * beyond));
  add_changes(study);
}

}  // namespace

Change change(const Rung& from, const Rung& to) {
  Change change;
  change.elements_per_radius = from.elements_per_radius;
  change.cost_ratio = to.cpu_seconds / from.cpu_seconds;
  if (!stopped(from) || !stopped(to)) return change;
  const auto &before = from.penetration, &after = to.penetration;
  change.share = *after.depth / *before.depth - 1;
  change.standard_error = std::hypot(*after.standard_error, *before.standard_error) / *before.depth;
  return change;
}

bool Change::is_significant() const { return share && std::abs(*share) > 2 * *standard_error; }

double RunNoise::on(double elements_per_radius) const {
  return on_usual_mesh * std::pow(usual_mesh / elements_per_radius, order);
}

double combined_error(double discretisation, double noise, int replicates) {
  return std::sqrt(discretisation * discretisation + noise * noise / replicates);
}

ErrorVsTime error_vs_time(const Ladder& ladder) {
  ErrorVsTime study;
  study.refinement = ladder.refinement;
  study.first_used = first_usable(ladder);
  for (const Rung& half : ladder.half_steps)
    study.half_step.push_back(change(ladder.on_mesh(half.elements_per_radius), half));
  study.double_precision = change(ladder.on_mesh(ladder.double_precision.elements_per_radius), ladder.double_precision);
  const auto rungs = std::span(ladder.meshes).subspan(study.first_used);
  if (!rungs.empty()) {
    const PooledNoise noise = pooled_noise(rungs, study.refinement == Refinement::any_order ? 0 : 1);
    for (const Rung& rung : rungs) study.from_finest.push_back(distance_from(rungs.back(), rung, noise.of_run));
    study.model = model_of_noise(rungs.size(), noise.of_run);
    if (study.has_limit())
      fit_limit(rungs, noise, study);
    else
      study.resampled = resample(rungs.size(), noise);
  }
  add_findings(ladder, study);
  return study;
}

}  // namespace percal
