// The optimum against a search that shares nothing with the fit: stresses by powers, moduli by elimination in extended
// precision, exponents by a grid, pattern moves and Newton's differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "percal/fit/read/read_curves.hpp"
#include "percal/fit/search/fit_curves.hpp"

namespace percal {
namespace {

using Real = long double;
using Reals = std::vector<Real>;
constexpr Real never = std::numeric_limits<Real>::infinity();

CurveData with_errors(const std::string& file) {
  auto data = read_curves({std::string(PERCAL_DATA "/public/") + file}, {});
  std::erase_if(data.points, [](const auto& point) { return point.nominal_stress == 0; });
  for (auto& point : data.points) point.standard_error = 0.03 * std::abs(point.nominal_stress) + 5e3;
  return data;
}

Real unit_stress(Real alpha, const Strained& strained) {
  const Real l = strained.amount;
  const auto power = [](Real base, Real exponent) { return std::pow(base, exponent); };
  switch (strained.deformation) {
    case Deformation::equibiaxial: return 2 / alpha * (power(l, alpha - 1) - power(l, -2 * alpha - 1));
    case Deformation::planar: return 2 / alpha * (power(l, alpha - 1) - power(l, -alpha - 1));
    default: return 2 / alpha * (power(l, alpha - 1) - power(l, -alpha / 2 - 1));
  }
}

struct Scan {
  const CurveData& data;
  Residual residual;

  Real weight(const StressPoint& point) const {
    if (residual == Residual::relative) return 1 / static_cast<Real>(point.nominal_stress);
    return residual == Residual::error ? 1 / static_cast<Real>(*point.standard_error) : 1;
  }
  Reals column(Real alpha) const {
    Reals column;
    for (const auto& point : data.points) column.push_back(weight(point) * unit_stress(alpha, point.strained));
    return column;
  }
  // Moduli by Gauss's elimination of the normal equations; infinite where one is not positive.
  Real objective(const std::vector<Reals>& columns, Reals* moduli = nullptr) const {
    const std::size_t terms = columns.size();
    std::vector<Reals> a(terms, Reals(terms + 1, 0));
    for (std::size_t i = 0; i < terms; ++i)
      for (std::size_t k = 0; k < data.points.size(); ++k) {
        for (std::size_t j = 0; j < terms; ++j) a[i][j] += columns[i][k] * columns[j][k];
        a[i][terms] += columns[i][k] * weight(data.points[k]) * data.points[k].nominal_stress;
      }
    for (std::size_t i = 0; i < terms; ++i)
      for (std::size_t row = 0; row < terms; ++row) {
        if (row == i) continue;
        const Real factor = a[row][i] / a[i][i];
        for (std::size_t j = i; j <= terms; ++j) a[row][j] -= factor * a[i][j];
      }
    Reals mu;
    for (std::size_t i = 0; i < terms; ++i) mu.push_back(a[i][terms] / a[i][i]);
    if (moduli) *moduli = mu;
    for (const Real one : mu)
      if (!(one > 0)) return never;
    Real sum = 0;
    for (std::size_t k = 0; k < data.points.size(); ++k) {
      Real error = weight(data.points[k]) * data.points[k].nominal_stress;
      for (std::size_t i = 0; i < terms; ++i) error -= mu[i] * columns[i][k];
      sum += error * error;
    }
    return sum;
  }
  Real at(const Reals& alphas, Reals* moduli = nullptr) const {
    std::vector<Reals> columns;
    for (const Real alpha : alphas) columns.push_back(column(alpha));
    return objective(columns, moduli);
  }
};

// The best sets of `terms` exponents out of a grid that never meets 0.
std::vector<Reals> grid_search(const Scan& scan, int terms, Real step) {
  Reals grid;
  std::vector<Reals> columns;
  for (Real alpha = -40 + step / 3; alpha < 40; alpha += step)
    grid.push_back(alpha), columns.push_back(scan.column(alpha));
  std::vector<std::pair<Real, Reals>> found;
  std::vector<std::size_t> at(terms, 0);
  const auto visit = [&](const auto& self, int depth, std::size_t from) -> void {
    if (depth == terms) {
      std::vector<Reals> chosen;
      Reals alphas;
      for (const std::size_t i : at) chosen.push_back(columns[i]), alphas.push_back(grid[i]);
      const Real value = scan.objective(chosen);
      if (value < never) found.emplace_back(value, alphas);
      return;
    }
    for (std::size_t i = from; i < grid.size(); ++i) at[depth] = i, self(self, depth + 1, i + 1);
  };
  visit(visit, 0, 0);
  std::sort(found.begin(), found.end());
  std::vector<Reals> best;  // that lie apart
  for (const auto& [value, alphas] : found) {
    const bool apart = std::all_of(best.begin(), best.end(), [&, &here = alphas](const Reals& other) {
      Real distance = 0;
      for (int k = 0; k < terms; ++k) distance = std::max(distance, std::abs(here[k] - other[k]));
      return distance > 2.5L * step;
    });
    if (apart) best.push_back(alphas);
    if (best.size() == 8) break;
  }
  return best;
}

// Steps along each exponent, halved where none helps, then Newton's steps from differences.
Reals refined(const Scan& scan, Reals alphas, Real step) {
  Real best = scan.at(alphas);
  while (step > 1e-4L) {
    bool better = false;
    for (std::size_t i = 0; i < alphas.size(); ++i)
      for (const Real sign : {-1, 1}) {
        Reals moved = alphas;
        moved[i] += sign * step;
        const Real value = scan.at(moved);
        if (value < best) best = value, alphas = moved, better = true;
      }
    if (!better) step /= 2;
  }
  const std::size_t n = alphas.size();
  for (int round = 0; round < 12; ++round) {
    const Real h = 1e-5L;
    const auto at = [&](std::size_t i, int a, std::size_t j, int b) {
      Reals moved = alphas;
      moved[i] += a * h, moved[j] += b * h;
      return scan.at(moved);
    };
    std::vector<Reals> m(n, Reals(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
      m[i][n] = -(at(i, 1, i, 0) - at(i, -1, i, 0)) / (2 * h);
      for (std::size_t j = 0; j < n; ++j)
        m[i][j] = i == j ? (at(i, 1, i, 0) - 2 * scan.at(alphas) + at(i, -1, i, 0)) / (h * h)
                         : (at(i, 1, j, 1) - at(i, 1, j, -1) - at(i, -1, j, 1) + at(i, -1, j, -1)) / (4 * h * h);
    }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t row = 0; row < n; ++row) {
        if (row == i) continue;
        const Real factor = m[row][i] / m[i][i];
        for (std::size_t j = i; j <= n; ++j) m[row][j] -= factor * m[i][j];
      }
    Reals moved = alphas;
    for (std::size_t i = 0; i < n; ++i) moved[i] += m[i][n] / m[i][i];
    if (!(scan.at(moved) <= scan.at(alphas))) break;
    alphas = moved;
  }
  return alphas;
}

void agrees(const CurveData& data, Model model, Residual residual) {
  const std::string name = word(model) + " " + word(residual);
  const Scan scan{data, residual};
  std::vector<Reals> starts;
  const auto fixed = fixed_alphas(model);
  const bool given = !fixed.empty();
  if (given)
    starts.push_back(Reals(fixed.begin(), fixed.end()));
  else
    starts = grid_search(scan, terms_of(model), terms_of(model) == 1 ? 0.02L : terms_of(model) == 2 ? 0.5L : 1.5L);
  Real lowest = never;
  Reals alphas, moduli;
  for (const auto& start : starts) {
    const Reals end = given ? start : refined(scan, start, 0.5L);
    const Real value = scan.at(end);
    if (value < lowest) lowest = value, alphas = end;
  }
  ASSERT_LT(lowest, never) << name;
  scan.at(alphas, &moduli);
  const auto fit = fit_curves(data, {.model = model, .residual = residual});
  const auto& best = fit.minima[0];
  ASSERT_EQ(best.solid.terms.size(), alphas.size()) << name;
  EXPECT_NEAR(best.objective / lowest, 1, 1e-9) << name;
  std::vector<std::pair<Real, Real>> terms;
  for (std::size_t k = 0; k < alphas.size(); ++k) terms.emplace_back(-alphas[k], moduli[k]);
  std::sort(terms.begin(), terms.end());
  for (std::size_t k = 0; k < terms.size(); ++k) {
    EXPECT_NEAR(best.solid.terms[k].alpha, -terms[k].first, 1e-6 * (1 + std::abs(terms[k].first))) << name;
    EXPECT_NEAR(best.solid.terms[k].mu / terms[k].second, 1, 2e-6) << name;
  }
}

constexpr Residual all_residuals[] = {Residual::relative, Residual::absolute, Residual::error};

TEST(IndependentScan, AgreesToSixDigitsForModelsOfOneExponentAndFixedOnes) {
  for (const char* file : {"treloar1944_rubber_primary.csv", "meunier2008_silicone_modes.csv"})
    for (const Model model : {Model::neo_hooke, Model::mooney_rivlin, Model::ogden})
      for (const Residual residual : all_residuals) {
        if (model == Model::mooney_rivlin && residual != Residual::relative &&
            fit_curves(with_errors(file), {.model = model, .residual = residual}).minima[0].solid.terms.size() < 2)
          continue;  // C01 = 0 is the best that is allowed: neo-Hooke, which stands here as well
        agrees(with_errors(file), model, residual);
      }
}

TEST(SlowIndependentScan, AgreesToSixDigitsForTwoAndThreeTerms) {
  for (const Model model : {Model::ogden2, Model::ogden3})
    for (const Residual residual : all_residuals)
      agrees(with_errors("treloar1944_rubber_primary.csv"), model, residual);
}

}  // namespace
}  // namespace percal
