#include "percal/powder/dose_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/math/distributions.hpp"
#include "percal/page/numbers.hpp"

namespace percal {
namespace {

constexpr double worth_saying = 5e-3;       // a share of the dose
constexpr double close_integration = 2e-3;  // of a share

const SpreadSource* source_named(const std::vector<SpreadSource>& sources, const std::string& name) {
  const auto found = std::ranges::find(sources, name, &SpreadSource::name);
  return found == sources.end() ? nullptr : &*found;
}

bool meet(const DoseEstimate& a, const DoseEstimate& b) { return a.low <= b.high && b.low <= a.high; }

// A sample's deviation is known to itself over the root of 2 (n - 1).
SpreadVerdict verdict_of(const MeasuredDepths& measured, const std::vector<SpreadSource>& sources, double level) {
  const double half =
      measured.particles ? normal_quantile(0.5 + level / 2) / std::sqrt(2.0 * (*measured.particles - 1)) : 0;
  SpreadVerdict verdict{.measured = {measured.deviation, measured.deviation * (1 - std::min(half, 1.0)),
                                     measured.deviation * (1 + half)}};
  if (const auto* size = source_named(sources, "size"); size)
    verdict.by_size_alone = meet(size->deviation, verdict.measured);
  verdict.by_all = meet(source_named(sources, "all")->deviation, verdict.measured);
  return verdict;
}

std::string words_of(const DoseEstimate& estimate) {
  return fmt::format("{} ({} to {})", page::length(estimate.best, 3), page::length(estimate.low, 3),
                     page::length(estimate.high, 3));
}

std::string held_against(const DoseEstimate& computed, const DoseEstimate& measured) {
  return meet(computed, measured) ? "as much as" : computed.high < measured.low ? "less than" : "more than";
}

// Of the measured spread, with the note of whoever gave it.
std::string verdict_in_words(const MeasuredDepths& measured, const SpreadVerdict& verdict,
                             const std::vector<SpreadSource>& sources) {
  std::string words;
  if (const auto* size = source_named(sources, "size"); size)
    words += fmt::format("The spread of sizes alone makes a standard deviation of {} of depth, {} the measured {}; ",
                         words_of(size->deviation), held_against(size->deviation, verdict.measured),
                         page::length(measured.deviation, 3));
  const DoseEstimate& all = source_named(sources, "all")->deviation;
  words += fmt::format("{} everything together {}, {} it.", words.empty() ? "Of depth makes" : "with", words_of(all),
                       held_against(all, verdict.measured));
  return measured.note.empty() ? words : words + " " + measured.note;
}

void add_findings(const PowderJob& job, const PowderModel& model, DoseAnswer& answer) {
  answer.findings = model_findings(job, model, answer.beyond);
  if (const double deeper = answer.dose.mass_shares.beyond_known.best; deeper >= worth_saying)
    answer.findings.push_back(fmt::format("{} of the mass ends deeper than the deepest fitted shot, {}.",
                                          page::percent(deeper), page::length(model.question.known_depth, 3)));
  const DoseEstimate& passed = answer.dose.mass_shares.passed;
  if (!model.calibration->passage && passed.best >= worth_saying)
    answer.findings.push_back(fmt::format(
        "{} of the mass goes as deep as the layer: near its lower face depths are those of a layer that holds.",
        page::percent(passed.best)));
  if (answer.dose.integration_error > close_integration)
    answer.findings.push_back(fmt::format("With half as many classes of particles a share changes by up to {}.",
                                          page::percent(answer.dose.integration_error, 2)));
  if (answer.verdict) answer.findings.push_back(verdict_in_words(*job.measured, *answer.verdict, answer.spread));
}

}  // namespace

DoseAnswer answer_dose(const PowderJob& job, const ShotModel& calibration) {
  const PowderModel model = powder_model(job, calibration);
  DoseAnswer answer{.material = model.predictor.material().name,
                    .hypothesis = model.of_hypothesis().name,
                    .layer_depth = model.question.layer_depth,
                    .level = model.question.level,
                    .scatter = model.forward.scatter,
                    .middle = middle_particle(job.powder),
                    .dose = dose_of(job.powder, model.forward, model.question),
                    .spread = spread_by_source(job.powder, model.forward, model.question),
                    .beyond = {},
                    .verdict = {},
                    .findings = {},
                    .cost = {}};
  answer.beyond = beyond_fitted(classes_of(job.powder, {}), model);
  if (job.measured) answer.verdict = verdict_of(*job.measured, answer.spread, answer.level);
  add_findings(job, model, answer);
  return answer;
}

}  // namespace percal
