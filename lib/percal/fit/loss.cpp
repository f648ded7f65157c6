#include "percal/fit/loss.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace percal {

double loss_of(const ScaledLoss& loss, double residual) {
  const double size = std::abs(residual), s = loss.scale;
  switch (loss.loss) {
    case Loss::huber: return size <= s ? size * size : 2 * s * size - s * s;
    case Loss::cauchy: return s * s * std::log1p(size / s * (size / s));
    case Loss::squares: break;
  }
  return size * size;
}

double weight_of(const ScaledLoss& loss, double residual) {
  const double size = std::abs(residual), s = loss.scale;
  switch (loss.loss) {
    case Loss::huber: return size <= s ? 1 : s / size;
    case Loss::cauchy: return 1 / (1 + size / s * (size / s));
    case Loss::squares: break;
  }
  return 1;
}

double scale_for(Loss loss, const Eigen::VectorXd& residuals) {
  std::vector<double> sizes(residuals.data(), residuals.data() + residuals.size());
  for (double& size : sizes) size = std::abs(size);
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return (loss == Loss::cauchy ? 2.385 : 1.345) * 1.4826 * *middle;
}

std::string word(Loss loss) {
  switch (loss) {
    case Loss::huber: return "huber";
    case Loss::cauchy: return "cauchy";
    case Loss::squares: break;
  }
  return "squares";
}

}  // namespace percal
