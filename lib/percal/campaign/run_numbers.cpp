#include "percal/campaign/run_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace percal {
namespace {

std::optional<double> none_beside(const ImpactResult&) { return std::nullopt; }

std::optional<double> log_of_positive(double value) {
  return value > 0 ? std::optional(std::log(value)) : std::nullopt;
}

// Of a sphere that stopped in the target and stayed there.
std::optional<double> log_final_share(const ImpactResult& result) {
  if (result.outcome != Outcome::stopped || !result.aftermath || result.aftermath->ending != Ending::rests)
    return std::nullopt;
  return log_of_positive(result.aftermath->depth / result.depth);
}

std::optional<double> log_half_speed_share(const ImpactResult& result) {
  if (result.outcome != Outcome::stopped) return std::nullopt;
  return log_of_positive(result.half_speed_depth / result.depth);
}

std::optional<double> log_channel_radius(const ImpactResult& result) {
  if (result.outcome != Outcome::stopped || result.channel.largest.empty()) return std::nullopt;
  return log_of_positive(std::ranges::max(result.channel.largest));
}

void ask_nothing(OutputScene&) {}
bool always(const Problem&) { return true; }

constexpr RunNumberKind run_number_kinds[] = {
    {"depth", "depth", "the deepest depth over the radius", true, "", ask_nothing, always, none_beside},
    {"final_depth", "final depth", "the final depth over the deepest", true,
     " Nothing but the roughness of its channel holds a sphere in these runs: what really holds it, friction or "
     "relaxation, is not in them. A deepest depth tells more, and so does a final one as a bound (at_least).",
     [](OutputScene& output) { output.after = RunUntil::rest; },
     [](const Problem& problem) { return problem.until == RunUntil::rest; }, log_final_share},
    {"half_speed_depth", "depth at half the speed", "the depth at half of the impact speed over the deepest", true,
     " It is nearly the same share of the deepest depth whatever the material: it tells of a shot whose end was not "
     "seen how deep it goes, and next to nothing else.",
     [](OutputScene& output) { output.half_speed_depth = true; },
     [](const Problem& problem) { return problem.half_speed_depth; }, log_half_speed_share},
    {"channel_radius", "largest channel radius", "the largest radius of the channel over the sphere's", false,
     " It is that of the walls which erosion leaves, at ten depths, at its largest: no rim and no crack beside it.",
     [](OutputScene& output) { output.channel = true; }, [](const Problem& problem) { return problem.channel; },
     log_channel_radius}};

// Adds what one emulator says of the points `rows` of all.
void add(DepthAnswers& all, const DepthAnswers& some, const std::vector<Eigen::Index>& rows) {
  all.log_depth(rows) += some.log_depth;
  all.gradient(rows, Eigen::all) += some.gradient;
  if (some.covariance.size() > 0) all.covariance(rows, rows) += some.covariance;
}

}  // namespace

const RunNumberKind& kind_of(RunNumber number) { return run_number_kinds[static_cast<int>(number)]; }

std::optional<RunNumber> run_number_of(const std::string& key) {
  const auto found = std::ranges::find(run_number_kinds, key, &RunNumberKind::key);
  if (found == std::end(run_number_kinds)) return std::nullopt;
  return static_cast<RunNumber>(found - std::begin(run_number_kinds));
}

DepthAnswers Emulators::answers(const std::vector<SphereInputs>& at, const std::vector<EmulatorOf>& wanted, double h,
                                bool with_covariance) const {
  const auto is_depth = [&](const EmulatorOf& one) { return one == EmulatorOf{wanted.front().body}; };
  if (!wanted.empty() && std::ranges::all_of(wanted, is_depth))
    return depth(wanted.front().body).depth(at, h, with_covariance);
  const auto count = static_cast<Eigen::Index>(at.size());
  DepthAnswers all{Eigen::VectorXd::Zero(count), Eigen::MatrixXd::Zero(count, sphere_inputs), {}};
  if (with_covariance) all.covariance = Eigen::MatrixXd::Zero(count, count);
  for (const auto& [known, emulator] : of) {
    const bool of_depth = known.number == RunNumber::depth;
    std::vector<Eigen::Index> rows;
    std::vector<SphereInputs> there;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const bool counts = of_depth ? kind_of(wanted[i].number).over_depth : wanted[i].number == known.number;
      if (wanted[i].body != known.body || !counts) continue;
      rows.push_back(static_cast<Eigen::Index>(i));
      there.push_back(at[i]);
    }
    if (!rows.empty()) add(all, emulator.depth(there, h, with_covariance), rows);
  }
  return all;
}

double Emulators::noise(const EmulatorOf& one, double h) const {
  const double of_depth = kind_of(one.number).over_depth ? depth(one.body).noise(h) : 0;
  return one.number == RunNumber::depth ? of_depth : std::hypot(of_depth, of.at(one).noise(h));
}

}  // namespace percal
