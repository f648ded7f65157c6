#include "percal/fit/search/search_terms.hpp"

#include <algorithm>
#include <cmath>

#include "percal/fit/search/exponent_scan.hpp"

namespace percal {
namespace {

constexpr int half_scan = 400;        // 0.1 in alpha: basins are about 1/ln(largest stretch) wide
constexpr double same_alpha = 1e-6;   // two results of one term closer than this are one minimum
constexpr double same_alphas = 1e-3;  // of several terms, whose valleys are flat
constexpr double vanishing = 1e-9;    // share of all stress below which a term is none
constexpr int extended = 4;           // minima of two terms that a third is added to
constexpr double by_chance = 2;  // what a term that stands for nothing gains in n ln S, the mean of chi squared of two

struct Task {
  const std::vector<WeightedPoint>& points;
  Signs signs;
  ScaledLoss loss;
};

std::vector<double> alphas_of(const Polished& minimum) {
  std::vector<double> alphas;
  for (const auto& term : minimum.terms) alphas.push_back(term.alpha);
  return alphas;
}

// Alphas from high to low, terms that carry no stress left out.
Polished tidied(Polished minimum, const Task& task) {
  const double all = weighted_stress(task.points).norm();
  std::erase_if(minimum.terms, [&](const Ogden& term) {
    return term.mu == 0 || std::abs(term.mu) * term_columns(task.points, {term.alpha}).stress.norm() < vanishing * all;
  });
  std::stable_sort(minimum.terms.begin(), minimum.terms.end(),
                   [](const Ogden& a, const Ogden& b) { return a.alpha > b.alpha; });
  return minimum;
}

bool same(const Polished& a, const Polished& b) {
  if (a.terms.size() != b.terms.size()) return false;
  const double near = a.terms.size() == 1 ? same_alpha : same_alphas;
  for (std::size_t k = 0; k < a.terms.size(); ++k)
    if (std::abs(a.terms[k].alpha - b.terms[k].alpha) >= near * (1 + std::abs(b.terms[k].alpha))) return false;
  return true;
}

// Whether the moduli add up to a positive one. Of those that do not the best is kept, which says why there is no solid.
bool is_solid(FoundMinima& found, const Polished& minimum) {
  double mu = 0;
  for (const auto& term : minimum.terms) mu += term.mu;
  if (!std::isfinite(minimum.objective)) return false;
  if (mu > 0) return true;
  if (!minimum.terms.empty() && (!found.refused || minimum.objective < found.refused->objective))
    found.refused = minimum;
  return false;
}

void polish_into(FoundMinima& found, const Task& task, const std::vector<SearchedAlpha>& start) {
  ++found.starts;
  const Polished minimum = tidied(polish(task.points, start, task.signs, task.loss), task);
  if (minimum.terms.size() < start.size() || !is_solid(found, minimum)) return;
  const auto known = std::find_if(found.minima.begin(), found.minima.end(),
                                  [&](const Polished& other) { return same(other, minimum); });
  if (known == found.minima.end()) return found.minima.push_back(minimum);
  if (minimum.objective < known->objective) *known = minimum;
}

std::vector<SearchedAlpha> anywhere(const std::vector<double>& alphas) {
  std::vector<SearchedAlpha> searched;
  for (const double alpha : alphas) searched.push_back({alpha, -largest_alpha, largest_alpha});
  return searched;
}

// Where more terms gain no more than chance gives, the solid of fewer is the answer. Other minima that Ceres did not settle are
// no minima.                                                                             docs/theory/curves.md (19b)
FoundMinima completed(FoundMinima found, const FoundMinima& fewer, const Task& task) {
  const double not_better = std::exp(-by_chance / static_cast<double>(task.points.size()));
  const Polished* simpler = best_of(fewer);
  const Polished* best = best_of(found);
  if (simpler && (!best || !(best->objective < not_better * simpler->objective))) {
    const Polished kept = *simpler;
    std::erase_if(found.minima, [&](const auto& minimum) { return !(minimum.objective > kept.objective); });
    found.minima.push_back(kept);
  }
  if (const Polished* lowest = best_of(found)) {
    const double objective = lowest->objective;
    std::erase_if(found.minima, [&](const auto& m) { return !m.converged && m.objective > objective; });
  }
  return found;
}

FoundMinima with_given_alphas(const Task& task, const std::vector<double>& alphas) {
  const Moduli moduli =
      best_moduli(term_columns(task.points, alphas).stress, weighted_stress(task.points), task.signs, task.loss);
  Polished minimum{{}, moduli.objective, true, 0};
  for (std::size_t k = 0; k < alphas.size(); ++k) minimum.terms.push_back({moduli.mu(k), alphas[k]});
  minimum = tidied(minimum, task);
  FoundMinima found{.scanned = 1};
  if (is_solid(found, minimum)) found.minima.push_back(minimum);
  return found;
}

FoundMinima one_term(const Task& task) {
  const auto scan = profile(task.points, task.loss, largest_alpha, half_scan);
  FoundMinima found{.scanned = static_cast<int>(scan.size())};
  const Task positive{task.points, Signs::positive, task.loss};
  for (const auto& [start, low, high] : minima_of(scan, weighted_stress(task.points).squaredNorm()))
    polish_into(found, positive, {{start.alpha, low, high}});
  return found;
}

// Weights that a robust loss gives to the points beside a fit; 1 with squares.
Eigen::VectorXd root_weights(const Task& task, const Polished* fit) {
  Eigen::VectorXd root = weighted_stress(task.points);
  if (!fit || task.loss.loss == Loss::squares) return root.setOnes();
  for (const auto& term : fit->terms) root -= term.mu * term_columns(task.points, {term.alpha}).stress.col(0);
  for (double& entry : root) entry = std::sqrt(weight_of(task.loss, entry));
  return root;
}

FoundMinima two_terms(const Task& task) {
  const FoundMinima fewer = one_term(task);
  const TermScan scan = scan_pairs(task.points, root_weights(task, best_of(fewer)), task.signs, largest_alpha);
  FoundMinima found{.scanned = fewer.scanned + scan.scanned};
  for (const auto& alphas : scan.minima) polish_into(found, task, anywhere(alphas));
  return completed(found, fewer, task);
}

// The exponents of a fit, and a third at every minimum of a scan of it.
void add_a_third(FoundMinima& found, const Task& task, const std::vector<double>& two) {
  const Eigen::VectorXd data = weighted_stress(task.points);
  std::vector<ProfileValue> scan;
  for (double alpha = -largest_alpha; alpha <= largest_alpha; alpha += 0.5) {
    std::vector<double> three = two;
    three.push_back(alpha);
    const Moduli moduli = best_moduli(term_columns(task.points, three).stress, data, task.signs, task.loss);
    scan.push_back({alpha, moduli.mu(2), moduli.mu(2) == 0 ? INFINITY : moduli.objective});
  }
  found.scanned += static_cast<int>(scan.size());
  for (const auto& bracket : minima_of(scan, data.squaredNorm())) {
    std::vector<double> three = two;
    three.push_back(bracket.start.alpha);
    polish_into(found, task, anywhere(three));
  }
}

FoundMinima three_terms(const Task& task) {
  FoundMinima fewer = two_terms(task);
  const TermScan scan = scan_triples(task.points, root_weights(task, best_of(fewer)), task.signs, largest_alpha);
  FoundMinima found{.scanned = fewer.scanned + scan.scanned};
  for (const auto& alphas : scan.minima) polish_into(found, task, anywhere(alphas));
  std::stable_sort(fewer.minima.begin(), fewer.minima.end(),
                   [](const auto& a, const auto& b) { return a.objective < b.objective; });
  for (std::size_t i = 0; i < std::min<std::size_t>(extended, fewer.minima.size()); ++i)
    if (fewer.minima[i].terms.size() == 2) add_a_third(found, task, alphas_of(fewer.minima[i]));
  return completed(found, fewer, task);
}

}  // namespace

const Polished* best_of(const FoundMinima& found) {
  const auto best = std::min_element(found.minima.begin(), found.minima.end(),
                                     [](const auto& a, const auto& b) { return a.objective < b.objective; });
  return best == found.minima.end() ? nullptr : &*best;
}

FoundMinima search_terms(Model model, const std::vector<WeightedPoint>& points, Signs signs, const ScaledLoss& loss) {
  const Task task{points, signs, loss};
  switch (model) {
    case Model::ogden: return one_term(task);
    case Model::ogden2: return two_terms(task);
    case Model::ogden3: return three_terms(task);
    default: return with_given_alphas(task, fixed_alphas(model));
  }
}

}  // namespace percal
