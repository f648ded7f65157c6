#include "percal/study/omissions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace percal {
namespace {

constexpr double possible_from = 2, clear_from = 3;  // standard errors
constexpr double clearly_cheaper = 0.9;              // of the baseline's processor time

std::optional<double> depth_of(const Rung& rung) { return rung.penetration.depth; }

double pooled_spread(const Rung& baseline, const std::vector<AuditedOmission>& omissions) {
  double squares = 0, freedom = 0;
  const auto add = [&](const Rung& rung) {
    const auto& p = rung.penetration;
    if (!p.depth || !p.spread || *p.depth == 0) return;
    squares += (rung.replicates - 1) * std::pow(*p.spread / *p.depth, 2);
    freedom += rung.replicates - 1;
  };
  add(baseline);
  for (const auto& omission : omissions) add(omission.rung);
  return freedom > 0 ? std::sqrt(squares / freedom) : 0;
}

std::string outcomes_of(const Rung& rung) {
  const auto& outcomes = rung.penetration.outcomes;
  std::vector<std::string> words;
  for (const Outcome outcome : outcomes)
    if (std::ranges::find(words, word(outcome)) == words.end()) words.push_back(word(outcome));
  for (auto& one : words)
    one += fmt::format(" ({} of {} runs)",
                       std::ranges::count_if(outcomes, [&](Outcome outcome) { return word(outcome) == one; }),
                       outcomes.size());
  return fmt::format("{}", fmt::join(words, ", "));
}

void judge(AuditedOmission& omission, bool baseline_stopped) {
  const Change& change = omission.change;
  if (!change.share) {
    omission.effect = Effect::ends_otherwise;
    omission.verdict = (baseline_stopped ? "ends otherwise: " : "no comparison: ") + outcomes_of(omission.rung);
    return;
  }
  const double size = std::abs(*change.share), error = *change.standard_error;
  omission.effect = size <= possible_from * error ? Effect::none
                    : size < clear_from * error   ? Effect::possible
                                                  : Effect::clear;
  const auto figures = fmt::format("{:+.1f} +- {:.1f} %", 100 * *change.share, 100 * error);
  switch (omission.effect) {
    case Effect::none: omission.verdict = "no effect beyond noise: " + figures; break;
    case Effect::possible: omission.verdict = "perhaps an effect: " + figures; break;
    default: omission.verdict = "an effect of " + figures;
  }
}

double size_for_sorting(const AuditedOmission& omission) {
  return omission.change.share ? std::abs(*omission.change.share) : std::numeric_limits<double>::infinity();
}

std::string why_no_variant(const std::string& left_out, const std::vector<SkippedVariant>& skipped) {
  for (const auto& variant : skipped)
    if (variant.left_out == left_out) return variant.why;
  if (left_out == "history") return "it is read off the run and changes no number of it";
  if (left_out == "erosion") return "the scene gives no limit to switch it on with";
  if (left_out == "rotation") return "a round particle that goes straight down, or a body of revolution, has none";
  return "there is no switch for it";
}

std::vector<AuditedLeftOut> audited(const std::vector<LeftOut>& left_out, const OmissionPlan& plan) {
  std::vector<AuditedLeftOut> list;
  for (const LeftOut& one : left_out) {
    AuditedLeftOut entry{.left_out = one, .audited_by = {}, .why_not = ""};
    for (const auto& variant : plan.variants)
      if (variant.left_out == one.what) entry.audited_by.push_back(variant.name);
    if (entry.audited_by.empty()) entry.why_not = why_no_variant(one.what, plan.skipped);
    list.push_back(entry);
  }
  return list;
}

std::string names(const Omissions& audit, const std::function<bool(const AuditedOmission&)>& wanted) {
  std::vector<std::string> found;
  for (const auto& one : audit.omissions)
    if (wanted(one))
      found.push_back(one.change.share ? fmt::format("{} ({:+.1f} +- {:.1f} %)", one.variant.name,
                                                     100 * *one.change.share, 100 * *one.change.standard_error)
                                       : one.variant.name);
  return fmt::format("{}", fmt::join(found, ", "));
}

bool of_kind(const AuditedOmission& one, OmissionKind kind) { return one.variant.kind == kind; }

// More than half of all changes on one side of zero by more than an error of a mean: the baseline itself is off.
std::optional<double> common_shift(const Omissions& audit) {
  std::vector<double> shares;
  for (const auto& one : audit.omissions)
    if (one.change.share) shares.push_back(*one.change.share);
  if (shares.size() < 5) return std::nullopt;
  const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
  std::ranges::nth_element(shares, middle);
  const double error_of_mean = audit.spread_of_a_run / std::sqrt(audit.baseline.replicates);
  return std::abs(*middle) > error_of_mean ? std::optional(*middle) : std::nullopt;
}

void conclude(Omissions& audit) {
  const auto say = [&](const std::string& what, const std::string& list) {
    if (!list.empty()) audit.conclusions.push_back(what + ": " + list);
  };
  if (!depth_of(audit.baseline)) {
    audit.conclusions.push_back(
        fmt::format("the scene as it is ends as {}: there is no depth to compare with", outcomes_of(audit.baseline)));
    return;
  }
  using Kind = OmissionKind;
  const auto with = [&](Kind kind, Effect effect) {
    return names(audit, [=](const auto& one) { return of_kind(one, kind) && one.effect == effect; });
  };
  say("changes how the particle ends",
      names(audit, [](const auto& one) { return one.effect == Effect::ends_otherwise; }));
  say("physics that counts here", with(Kind::physics, Effect::clear));
  say("physics that may count: more replicates would tell", with(Kind::physics, Effect::possible));
  say("physics that makes no difference beyond noise, and can stay as it is", with(Kind::physics, Effect::none));
  say("the domain is too small or its edge counts", with(Kind::domain, Effect::clear));
  say("the domain may count: more replicates would tell", with(Kind::domain, Effect::possible));
  say("the domain is large enough", with(Kind::domain, Effect::none));
  say("numerical settings that the depth depends on", with(Kind::numerics, Effect::clear));
  say("numerical settings that may count: more replicates would tell", with(Kind::numerics, Effect::possible));
  say("numerical settings without effect beyond noise", with(Kind::numerics, Effect::none));
  std::vector<std::string> savings;
  for (const auto& one : audit.omissions)
    if (one.effect == Effect::none && one.change.cost_ratio < clearly_cheaper)
      savings.push_back(fmt::format("{} ({:.2f} times the time)", one.variant.name, one.change.cost_ratio));
  say("would save time without an effect beyond noise", fmt::format("{}", fmt::join(savings, ", ")));
  if (const auto shift = common_shift(audit))
    audit.conclusions.push_back(
        fmt::format("half of all changes are {} {:+.1f} %: the mean of the scene as it is, from which all are "
                    "reckoned, is itself off by noise; more replicates would tell",
                    *shift > 0 ? "above" : "below", 100 * *shift));
}

}  // namespace

std::string word(Effect effect) {
  switch (effect) {
    case Effect::none: return "none";
    case Effect::possible: return "possible";
    case Effect::clear: return "clear";
    case Effect::ends_otherwise: return "ends otherwise";
  }
  return "";
}

Omissions audit_omissions(const Scene& scene, int replicates, const Replicator& evaluate) {
  Omissions audit;
  Scene as_it_is = scene;
  as_it_is.output = {};
  audit.reduction = reduce(as_it_is);
  audit.baseline = rung_of(audit.reduction, evaluate({audit.reduction.problem}, replicates).front());
  OmissionPlan plan = plan_omissions(as_it_is, audit.reduction, depth_of(audit.baseline));

  std::vector<Reduction> reductions;
  std::vector<Problem> problems;
  for (const auto& variant : plan.variants) {
    reductions.push_back(reduce(variant.scene));
    problems.push_back(reductions.back().problem);
  }
  const auto runs = evaluate(problems, replicates);
  for (std::size_t i = 0; i < plan.variants.size(); ++i) {
    const Rung rung = rung_of(reductions[i], runs[i]);
    audit.omissions.push_back({plan.variants[i], rung, change(audit.baseline, rung), Effect::none, ""});
  }

  audit.left_out = audited(audit.reduction.left_out, plan);
  audit.skipped = std::move(plan.skipped);
  audit.spread_of_a_run = pooled_spread(audit.baseline, audit.omissions);
  const double pooled_error = audit.spread_of_a_run * std::sqrt(2.0 / replicates);
  for (auto& omission : audit.omissions) {
    if (omission.change.share)
      omission.change.standard_error = std::max(omission.change.standard_error.value_or(0), pooled_error);
    judge(omission, depth_of(audit.baseline).has_value());
  }
  std::ranges::stable_sort(audit.omissions, std::ranges::greater{}, size_for_sorting);
  conclude(audit);
  return audit;
}

}  // namespace percal
