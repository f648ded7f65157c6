#include "percal/powder/design_answer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "percal/page/numbers.hpp"

namespace percal {
namespace {

constexpr double as_good = 0.98;     // of the best dose
constexpr double much_beyond = 0.2;  // of the mass
constexpr double at_end = 1e-3;      // relative

std::string words_of(const PowderParticle& particle) {
  return fmt::format("radius {} at {}", page::length(particle.radius, 3),
                     page::quantity(particle.speed, dimension::speed, 3));
}

// Where the best is no point but a line.
void say_ridge(const PowderDesign& design, std::vector<std::string>& findings) {
  const DesignPoint *first = nullptr, *last = nullptr;
  for (const DesignPoint& point : design.line) {
    if (point.shares.dose < as_good * design.best->shares.dose) continue;
    if (!first) first = &point;
    last = &point;
  }
  if (first && first != last)
    findings.push_back(
        fmt::format("From {} to {} the best speed of each radius puts within 2 % as much there: size and "
                    "speed make up for each other along that line.",
                    words_of(first->middle), words_of(last->middle)));
}

void say_ends(const DesignQuestion& asked, const PowderParticle& best, std::vector<std::string>& findings) {
  const auto say = [&](const std::string& name, double value, const SearchRange& range) {
    if (value < range.low * (1 + at_end) || value > range.high * (1 - at_end))
      findings.push_back(
          fmt::format("The best {} lies at the end of the range that was searched: more may be had beyond.", name));
  };
  say("radius", best.radius, asked.radius);
  say("speed", best.speed, asked.speed);
}

void say_limits(const DesignQuestion& asked, const DesignPoint& best, std::vector<std::string>& findings) {
  const auto say = [&](const std::string& name, const std::optional<double>& limit, double value) {
    if (limit && value > *limit * (1 - at_end) - at_end)
      findings.push_back(fmt::format("The limit on what {} holds the dose back.", name));
  };
  say("bounces", asked.limits.bounced, best.shares.bounced);
  say("passes", asked.limits.passed, best.shares.passed);
  say("goes deeper", asked.limits.deeper, best.shares.deeper);
  say("lies beyond what was fitted", asked.limits.beyond, best.shares.beyond);
  if (!asked.limits.beyond && best.shares.beyond > much_beyond)
    findings.push_back("limits.beyond keeps a design within what was fitted.");
  if (asked.limits.most_impact && impact_parameter(best.middle) > *asked.limits.most_impact * (1 - at_end))
    findings.push_back("The limit on density times speed times radius holds the dose back.");
}

std::vector<BeyondFitted> beyond_at(const Powder& powder, const PowderModel& model, const PowderParticle& best) {
  const PowderParticle middle = middle_particle(powder);
  return beyond_fitted(scaled(classes_of(powder, {}),
                              {best.radius / middle.radius, best.density / middle.density, best.speed / middle.speed}),
                       model);
}

}  // namespace

void need_design(const PowderJob& job) {
  if (!job.design)
    throw BadInput({job.file, 0, "design"}, "no such table",
                   "[design] with radius and speed, each of two ends, and [band]");
}

DesignAnswer answer_design(const PowderJob& job, const ShotModel& calibration) {
  need_design(job);
  const PowderModel model = powder_model(job, calibration);
  DesignAnswer answer{.material = model.predictor.material().name,
                      .hypothesis = model.of_hypothesis().name,
                      .layer_depth = model.question.layer_depth,
                      .level = model.question.level,
                      .design = design_of(job.powder, model.forward, model.question, *job.design),
                      .beyond = {},
                      .findings = {},
                      .cost = {}};
  if (!answer.design.best) {
    answer.findings = {"No particle and speed of the map is within the limits."};
    return answer;
  }
  const DesignPoint& best = *answer.design.best;
  answer.beyond = beyond_at(job.powder, model, best.middle);
  answer.findings = model_findings(job, model, answer.beyond);
  say_ends(*job.design, best.middle, answer.findings);
  say_limits(*job.design, best, answer.findings);
  say_ridge(answer.design, answer.findings);
  return answer;
}

}  // namespace percal
