// The intervals of a fit on the terminal.
#include <fmt/format.h>

#include "fit_output.hpp"
#include "fit_text.hpp"
#include "pages.hpp"

namespace percal::tools {
namespace {

std::string as_text(const Interval& interval, double size) {
  return fmt::format("{:.5g}{} to {:.5g}{}", interval.low / size, interval.low_open ? " (open)" : "",
                     interval.high / size, interval.high_open ? " (open)" : "");
}

std::vector<std::string> row(const MinimumUncertainty& about, const ParameterUncertainty& parameter) {
  const bool pressure = !parameter.unit.empty();
  const PressureUnit unit = pressure ? unit_for(std::abs(parameter.value)) : PressureUnit{"", 1};
  std::vector<std::string> cells = {
      std::to_string(about.minimum + 1), pressure ? fmt::format("{}, {}", parameter.name, unit.symbol) : parameter.name,
      fmt::format("{:.5g}", parameter.value / unit.size), as_text(parameter.interval, unit.size)};
  if (const auto& bootstrap = parameter.bootstrap)
    for (const Interval& interval : {bootstrap->points, bootstrap->residuals, bootstrap->parametric})
      cells.push_back(as_text(interval, unit.size));
  return cells;
}

}  // namespace

std::string uncertainty_as_text(const Uncertainty& uncertainty, const CurveFit& fit) {
  std::string text;
  if (!uncertainty.minima.empty()) {
    const std::string percent = fmt::format("{:g} %", 100 * uncertainty.options.level);
    std::vector<std::vector<std::string>> rows = {{"minimum", "parameter", "value", percent + " interval"}};
    if (uncertainty.options.bootstrap > 0)
      for (const char* kind : {"points drawn anew", "residuals drawn anew", "points from the model"})
        rows[0].push_back(kind);
    for (const auto& about : uncertainty.minima) {
      for (const auto& parameter : about.parameters) rows.push_back(row(about, parameter));
      if (const auto& sum = about.small_strain_modulus) {
        const double mu = small_strain_modulus(fit.minima[static_cast<std::size_t>(about.minimum)].solid);
        const PressureUnit unit = unit_for(mu);
        rows.push_back({std::to_string(about.minimum + 1), fmt::format("sum of mu, {}", unit.symbol),
                        fmt::format("{:.5g}", mu / unit.size), as_text(*sum, unit.size) + " (linearised)"});
      }
    }
    for (auto& cells : rows) cells.resize(rows[0].size());
    text = fmt::format("\nErrors from the {}, {} degrees of freedom.\n", word(uncertainty.errors),
                       uncertainty.degrees_of_freedom) +
           aligned(rows);
  }
  for (const auto& sentence : uncertainty.findings) text += fmt::format("\n{}\n", sentence);
  return text;
}

}  // namespace percal::tools
