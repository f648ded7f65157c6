#include "fit_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "fit_output.hpp"
#include "pages.hpp"

namespace percal::tools {
namespace {

std::string with_error(double value, const std::optional<double>& error) {
  if (!error) return fmt::format("{:.5g}", value);
  return fmt::format("{:.5g} ± {:.2g}", value, *error);
}

std::string or_dash(const std::optional<double>& value, const char* form) {
  return value ? fmt::format(fmt::runtime(form), *value) : "-";
}

std::string modes_as_text(const CurveFit& fit) {
  std::string text;
  for (const auto& [deformation, points] : fit.points_of_mode)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", points, word(deformation));
  return text;
}

std::string objective_name(const CurveFit& fit) {
  if (fit.options.loss != Loss::squares) return "sum of loss";
  return fit.options.residual == Residual::absolute ? "SSE, Pa^2" : "sum of r^2";
}

std::optional<double> in_unit(std::optional<double> error, const PressureUnit& unit) {
  if (error) *error /= unit.size;
  return error;
}

// "30.1 at 3.9 + 61 at -7.8": each modulus and its exponent.
std::string terms_as_text(const Hyperelastic& solid, const PressureUnit& unit) {
  std::string text;
  for (const auto& term : solid.terms)
    text += fmt::format("{}{:.5g} at {:.4g}", text.empty() ? "" : " + ", term.mu / unit.size, term.alpha);
  return text;
}

std::string minima_as_table(const CurveFit& fit) {
  const PressureUnit unit = unit_for(small_strain_modulus(fit.minima[0].solid));
  const bool single = fit.options.model == Model::ogden;
  std::vector<std::vector<std::string>> rows;
  rows.push_back({"minimum", fmt::format("mu, {}", unit.symbol), single ? "alpha" : "terms: mu at alpha", "correlation",
                  "R^2", objective_name(fit), "above best", ""});
  for (const auto& minimum : fit.minima) {
    const auto& terms = minimum.solid.terms;
    const auto error = terms.size() == 1 ? in_unit(minimum.errors[0].mu, unit) : std::nullopt;
    rows.push_back({std::to_string(rows.size()), with_error(small_strain_modulus(minimum.solid) / unit.size, error),
                    single ? with_error(terms[0].alpha, minimum.errors[0].alpha) : terms_as_text(minimum.solid, unit),
                    or_dash(minimum.correlation, "{:.4f}"), or_dash(minimum.r2, "{:.6f}"),
                    fmt::format("{:.6g}", minimum.objective),
                    minimum.above_best ? fmt::format("{:.3g} %", 100 * *minimum.above_best) : "-",
                    std::string(minimum.at_bound ? "at the bound" : "") + (minimum.converged ? "" : " not converged")});
  }
  return aligned(rows);
}

std::string tests_as_text(const CurveFit& fit) {
  std::string text;
  for (std::size_t i = 0; i < fit.tests.size(); ++i)
    text += fmt::format("{}{} {}", i == 0 ? "R^2 of the best by test: " : ", ", fit.tests[i].name,
                        or_dash(fit.minima[0].r2_of_test[i], "{:.4f}"));
  return text + "\n";
}

std::string percent(const std::optional<double>& share) { return share ? fmt::format("{:.1f} %", 100 * *share) : "-"; }

double lowest_aicc(const std::vector<ComparedModel>& models) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& model : models)
    if (model.fit && model.fit->aicc) lowest = std::min(lowest, *model.fit->aicc);
  return lowest;
}

std::vector<std::string> row_of(const ComparedModel& model, double lowest, std::size_t tests,
                                const StretchRange& stretches) {
  std::vector<std::string> row = {word(model.model), std::to_string(parameters_of(model.model))};
  if (!model.fit || model.fit->minima.empty()) {
    row.insert(row.end(), {"-", "-"});
    row.insert(row.end(), tests, "-");
    row.insert(row.end(), {"-", "-", model.fit ? "no positive modulus fits" : "too few points"});
    return row;
  }
  const CurveMinimum& best = model.fit->minima[0];
  const double mu = small_strain_modulus(best.solid);
  row.push_back(model.fit->aicc ? fmt::format("{:.1f}", *model.fit->aicc - lowest) : "-");
  row.push_back(fmt::format("{:.4g} {}", mu / unit_for(mu).size, unit_for(mu).symbol));
  for (const auto& r2 : best.r2_of_test) row.push_back(or_dash(r2, "{:.4f}"));
  row.push_back(percent(model.mean_relative_deviation));
  row.push_back(stable_throughout(stable_ranges(best.solid, stretches)) ? "yes" : "no");
  row.push_back(terms_as_text(best.solid, unit_for(mu)));
  return row;
}

std::size_t tests_in(const std::vector<ComparedModel>& models, std::vector<std::string>& header) {
  for (const auto& model : models)
    if (model.fit) {
      for (const auto& test : model.fit->tests) header.push_back(fmt::format("R^2 {}", test.name));
      return model.fit->tests.size();
    }
  return 0;
}

}  // namespace

std::string sources_as_text(const CurveData& data) {
  std::string text;
  for (const auto& source : data.sources)
    text += fmt::format("{}: {} points of {}{} over {}{}\n", source.file, source.points, source.y,
                        source.cauchy ? " (Cauchy, made nominal)" : "", source.x,
                        source.error.empty() ? "" : ", standard errors " + source.error);
  return text;
}

std::string fit_as_text(const CurveFit& fit, const CurveData& data, const StretchRange& stretches) {
  const CurveOptions& options = fit.options;
  std::string text = sources_as_text(data) + fmt::format("{} points used: {}", fit.points, modes_as_text(fit));
  if (options.residual == Residual::relative)
    text += fmt::format("; {} of zero stress left out", fit.left_out_zero_stress);
  if (options.residual == Residual::error) text += fmt::format("; {} without an error left out", fit.left_out_no_error);
  text += fmt::format("\n{}: {} residuals", word(options.model), word(options.residual));
  if (options.loss != Loss::squares) text += fmt::format(", {} loss", word(options.loss));
  if (std::holds_alternative<EqualTests>(options.weighting)) text += ", tests weighted as wholes";
  text += fmt::format("; alpha searched from {:g} to {:g}\n", -largest_alpha, largest_alpha);
  if (!fit.minima.empty()) {
    text += fmt::format("\n{}\n{}", minima_as_table(fit), tests_as_text(fit));
    text += stability_sentence(stable_ranges(fit.minima[0].solid, stretches), stretches) + "\n";
  }
  for (const auto& sentence : findings(fit)) text += fmt::format("\n{}\n", sentence);
  return text;
}

std::string comparison_as_text(const std::vector<ComparedModel>& models, const StretchRange& stretches) {
  std::vector<std::string> header = {"model", "parameters", "AICc above lowest", "mu"};
  const std::size_t tests = tests_in(models, header);
  header.insert(header.end(),
                {"left-out tests missed by", fmt::format("stable {:g} to {:g}", stretches.low, stretches.high),
                 "terms: mu at alpha"});
  std::vector<std::vector<std::string>> rows = {header};
  for (const auto& model : models) rows.push_back(row_of(model, lowest_aicc(models), tests, stretches));
  return fmt::format("\n{}", aligned(rows));
}

}  // namespace percal::tools
