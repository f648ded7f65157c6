// The models side by side on the same points, and how well each predicts a test that it was not fitted to.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/fit/search/fit_curves.hpp"

namespace percal {

// A test left out of the fit and predicted from the others. There is nothing where the others cannot hold the model's
// parameters, or no modulus fits them.
struct LeftOutTest {
  std::string name;
  std::optional<double> mean_relative_deviation;  // mean |predicted/measured - 1|, points of zero stress left out
  std::optional<double> relative_to_sum;          // sum |predicted - measured| / sum |measured|
};

struct ComparedModel {
  Model model;
  std::optional<CurveFit> fit;  // none where the points cannot hold the parameters: `why_not`
  std::string why_not;
  std::vector<LeftOutTest> left_out;  // with two tests or more
  // Means over the left-out tests; none where one of them is missing.
  std::optional<double> mean_relative_deviation;
  std::optional<double> relative_to_sum;
  std::string not_ranked =
      {};  // why its AICc is set beside no other's: no minimum of the model, or a term that is nothing; else empty
};

// All models in the order neo-Hooke, Mooney-Rivlin, Ogden with one, two and three terms; options.model is not looked
// at.
std::vector<ComparedModel> compare_models(const CurveData& data, const CurveOptions& options);

}  // namespace percal
