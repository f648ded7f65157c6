#include "percal/fit/peaks.hpp"

#include <algorithm>
#include <cmath>

namespace percal {

std::string word(CurvePeak::End end) {
  return end == CurvePeak::End::falls ? "falls" : end == CurvePeak::End::held ? "held" : "none";
}

std::optional<ErosionPrior> prior_of_peaks(const std::vector<CurveSource>& sources) {
  std::vector<double> logs;
  for (const CurveSource& source : sources)
    for (const CurvePeak& peak : source.peaks)
      if (peak.end == CurvePeak::End::falls) logs.push_back(std::log(peak.erosion_strain));
  if (logs.empty()) return std::nullopt;
  const auto n = static_cast<double>(logs.size());
  double mean = 0, squares = 0;
  for (const double log : logs) mean += log / n;
  for (const double log : logs) squares += (log - mean) * (log - mean);
  const double spread = n > 1 ? std::sqrt(squares / (n - 1)) : 0;
  return ErosionPrior{std::exp(mean), std::max(least_prior_error, spread), static_cast<int>(logs.size())};
}

}  // namespace percal
