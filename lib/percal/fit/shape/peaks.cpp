#include "percal/fit/shape/peaks.hpp"

#include <algorithm>
#include <cmath>

#include "percal/math/statistics.hpp"

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
  const double spread = logs.size() > 1 ? sample_deviation(logs) : 0;
  return ErosionPrior{std::exp(mean(logs)), std::max(least_prior_error, spread), static_cast<int>(logs.size())};
}

}  // namespace percal
