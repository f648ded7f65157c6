#include "percal/one_depth/one_depth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/atlas/expected.hpp"
#include "percal/campaign/depth_search.hpp"
#include "percal/math/statistics.hpp"
#include "percal/one_depth/findings.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

constexpr int own_line = 2 * usual_replicates,
              other_lines = usual_replicates;  // answers that a line shall have where the atlas does not tell of it
constexpr double slope_of_strain = 1.2;        // |d ln depth/d ln erosion strain| that a search expects
constexpr double farthest_strain = 2.5;        // of ln erosion strain from where a search begins
constexpr double expected_exponent = 2;        // of 1/erosion strain, with which the modulus goes along a ridge

LayerMaterial with(LayerMaterial material, LayerNumber number, double value) {
  number_of(material, number) = value;
  return material;
}

// The materials in which the searches of the ridge begin.
std::vector<LayerMaterial> beginnings(const InvertRequest& request) {
  std::vector<LayerMaterial> materials;
  const double exponent = request.sought == LayerNumber::mu ? expected_exponent : 1 / expected_exponent;
  for (const double factor : ridge_factors) {
    materials.push_back(request.material);
    number_of(materials.back(), other(request.sought)) *= factor;
    number_of(materials.back(), request.sought) /= std::pow(factor, exponent);
  }
  return materials;
}

std::string why_not(const InvertRequest& request, const Inversion& search) {
  if (search.outcome == InversionOutcome::found) return "";
  const auto at = [&](const InversionPoint& point) { return words_of(request.sought, std::exp(point.log_modulus)); };
  if (search.outcome == InversionOutcome::failed) return search.why + " at " + at(search.points.back());
  if (search.outcome == InversionOutcome::out_of_evaluations)
    return fmt::format("not settled in {} runs", search.points.size());
  const auto [least, most] = std::ranges::minmax(search.points, {}, &InversionPoint::log_modulus);
  const bool too_deep = search.points.back().answer.depth > request.depth;
  const bool passes = std::ranges::all_of(search.points, [](const auto& point) { return point.answer.censored; });
  return fmt::format("out of reach: {} from {} to {}",
                     passes     ? "passes through"
                     : too_deep ? "deeper"
                                : "less deep",
                     at(least), at(most));
}

std::vector<ValueErrorPart> measured_shares(const OneDepth& found, const Inversion& search) {
  const InvertRequest& request = found.request;
  std::vector<ValueErrorPart> shares;
  if (request.depth_error) shares.push_back(depth_share("measured depth", *request.depth_error, "as given", search));
  if (!request.speed_error) return shares;
  // A depth hangs on rho v^2/mu alone; the erosion strain makes up for a modulus as the ridge says.
  if (request.sought == LayerNumber::mu)
    shares.push_back(
        value_share("speed", 2 * *request.speed_error, "as given: the modulus goes with its square", search));
  else if (found.ridge_exponent)
    shares.push_back(value_share("speed", 2 * *request.speed_error / std::abs(*found.ridge_exponent),
                                 "as given: with its square, by the ridge's slope", search));
  else
    shares.push_back({"speed", {}, {}, "not known without a ridge"});
  return shares;
}

// All but the solver's.
std::vector<ValueErrorPart> other_shares(const PairOfDepth& pair, const OneDepth& found, double worst_closure) {
  const InvertRequest& request = found.request;
  const Scene scene = scene_of(request, pair.material);
  Penetration at_root;
  at_root.depth = request.depth;
  at_root.worst_closure = worst_closure;
  auto others = measured_shares(found, pair.search);
  for (ValueErrorPart& share : rule_shares(depth_error(scene, reduce(scene), at_root), request.depth, pair.search))
    others.push_back(std::move(share));
  return others;
}

void add_errors(PairOfDepth& pair, const OneDepth& found, double worst_closure) {
  const InvertRequest& request = found.request;
  const auto others = other_shares(pair, found, worst_closure);
  const double half = half_width(pair.search, others, request.level), value = number_of(pair.material, request.sought);
  pair.interval = Between{value * std::exp(-half), value * std::exp(half)};
  pair.errors = {solver_share(pair.search)};
  pair.errors.insert(pair.errors.end(), others.begin(), others.end());
}

// A search whose end the atlas expects begins there, and its line has as many answers as the other errors ask for.
void begin_by_atlas(const InvertRequest& request, const LayerMaterial& begin, InversionOptions& options) {
  const auto material = [&](double log_value) { return with(begin, request.sought, std::exp(log_value)); };
  const auto root =
      expected_root([&](double log_value) { return reduce(scene_of(request, material(log_value))).problem; },
                    std::log(request.depth / request.shot.radius), options.start, options.most_step);
  if (!root) return;
  const PairOfDepth expected{.material = material(root->log_value), .search = {.slope = root->slope}};
  begin_at(*root, of_depth(other_shares(expected, {.request = request, .ridge = {}}, 0)), options);
}

std::optional<double> exponent_of(const std::vector<PairOfDepth>& ridge) {
  std::vector<double> strains, moduli;
  for (const PairOfDepth& pair : ridge)
    if (pair.found()) {
      strains.push_back(std::log(pair.material.erosion_strain));
      moduli.push_back(std::log(pair.material.mu_true));
    }
  if (strains.size() < 2) return std::nullopt;
  return linear_trend(strains, moduli).slope;
}

}  // namespace

OneDepth find_at_depth(const InvertRequest& request, Campaign& campaign) {
  const auto begin = beginnings(request);
  const int count = static_cast<int>(begin.size());
  std::vector<double> closures(count, 0);
  // The longest search first.
  const auto place = [](int k) { return k == 0 ? own_factor : k <= own_factor ? k - 1 : k; };
  auto searches = search_side_by_side(campaign, count, "searches", [&](int k) {
    const int at = place(k);
    InversionOptions options{.target = request.depth,
                             .start = std::log(number_of(begin[at], request.sought)),
                             .fewest_in_line = at == own_factor ? own_line : other_lines};
    if (request.sought == LayerNumber::erosion_strain) {
      options.expected_slope = slope_of_strain;
      options.most_step = farthest_strain;
    }
    begin_by_atlas(request, begin[at], options);
    const auto reduction = [&](double log_value) {
      return reduce(scene_of(request, with(begin[at], request.sought, std::exp(log_value))));
    };
    return invert_modulus(one_run_an_answer(campaign, reduction, closures[at]), options);
  });
  OneDepth found{.request = request, .ridge = std::vector<PairOfDepth>(count)};
  for (int k = 0; k < count; ++k) {
    PairOfDepth& pair = found.ridge[place(k)];
    pair.search = std::move(searches[k]);
    pair.why_not = why_not(request, pair.search);
    pair.material = with(begin[place(k)], request.sought, std::exp(pair.search.log_modulus));
  }
  found.ridge_exponent = exponent_of(found.ridge);
  for (int k = 0; k < count; ++k)
    if (found.ridge[k].found()) add_errors(found.ridge[k], found, closures[k]);
  add_findings(found);
  return found;
}

}  // namespace percal
