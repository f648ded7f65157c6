// percal fit FILE...: stress-stretch curves -> mu and alpha, every minimum.
#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "percal/base/version.hpp"
#include "percal/fit/fit_json.hpp"
#include "percal/fit/fit_ogden.hpp"
#include "percal/fit/read_curves.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

using nlohmann::json;

struct Clock {
  std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
  std::clock_t cpu = std::clock();
  json cost() const {
    const std::chrono::duration<double> wall_s = std::chrono::steady_clock::now() - wall;
    return {{"wall_s", wall_s.count()}, {"cpu_s", static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC}};
  }
};

struct PressureUnit {
  const char* symbol;
  double size;  // Pa
};

// The unit in which a modulus reads best.
PressureUnit unit_for(double pressure) {
  if (pressure >= 1e9) return {"GPa", 1e9};
  if (pressure >= 1e6) return {"MPa", 1e6};
  if (pressure >= 1e3) return {"kPa", 1e3};
  return {"Pa", 1};
}

std::string with_error(double value, const std::optional<double>& error) {
  if (!error) return fmt::format("{:.5g}", value);
  return fmt::format("{:.5g} ± {:.2g}", value, *error);
}

std::string or_dash(const std::optional<double>& value, const char* form) {
  return value ? fmt::format(fmt::runtime(form), *value) : "-";
}

// Standard output may be a file on a full disk.
void put(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw IoFailure(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

std::string sources_as_text(const CurveData& data) {
  std::string text;
  for (const auto& source : data.sources)
    text += fmt::format("{}: {} points of {}{} over {}\n", source.file, source.points, source.y,
                        source.cauchy ? " (Cauchy, made nominal)" : "", source.x);
  return text;
}

std::string modes_as_text(const OgdenFit& fit) {
  std::string text;
  for (const auto& [deformation, points] : fit.points_of_mode)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", points, word(deformation));
  return text;
}

std::string minima_as_table(const OgdenFit& fit) {
  constexpr const char* row = "{:>7}  {:>24}  {:>20}  {:>11}  {:>9}  {:>12}  {:>10}{}\n";
  const PressureUnit unit = unit_for(fit.minima[0].solid.mu);
  std::string text = fmt::format(row, "minimum", fmt::format("mu, {}", unit.symbol), "alpha", "correlation", "R^2",
                                 fit.residual == Residual::absolute ? "SSE, Pa^2" : "sum of r^2", "above best", "");
  int rank = 0;
  for (const auto& minimum : fit.minima) {
    auto mu_error = minimum.mu_standard_error;
    if (mu_error) *mu_error /= unit.size;
    text += fmt::format(
        row, ++rank, with_error(minimum.solid.mu / unit.size, mu_error),
        with_error(minimum.solid.alpha, minimum.alpha_standard_error), or_dash(minimum.correlation, "{:.4f}"),
        or_dash(minimum.r2, "{:.6f}"), fmt::format("{:.6g}", minimum.objective),
        minimum.above_best ? fmt::format("{:.3g} %", 100 * *minimum.above_best) : "-",
        std::string(minimum.at_bound ? "  at the bound" : "") + (minimum.converged ? "" : "  not converged"));
  }
  return text;
}

std::string fit_as_text(const OgdenFit& fit, const CurveData& data) {
  std::string text = sources_as_text(data) + fmt::format("{} points used: {}", fit.points, modes_as_text(fit));
  if (fit.residual == Residual::relative) text += fmt::format("; {} of zero stress left out", fit.left_out_zero_stress);
  text += fmt::format("\n{} residuals; alpha searched from {:g} to {:g}\n", word(fit.residual), -largest_alpha,
                      largest_alpha);
  if (!fit.minima.empty()) text += fmt::format("\n{}", minima_as_table(fit));
  for (const auto& sentence : findings(fit)) text += fmt::format("\n{}\n", sentence);
  return text;
}

json input_of(const FitArguments& arguments) {
  return {{"files", arguments.files}, {"mode", arguments.mode}, {"residual", arguments.residual},
          {"x", arguments.x},         {"y", arguments.y},       {"where", arguments.where}};
}

json head(const FitArguments& arguments) {
  return {{"schema", result_schema}, {"version", version()}, {"command", "fit"}, {"input", input_of(arguments)}};
}

// JSON for people and programs; text of the user that is not UTF-8 shows as replacement characters.
std::string written(const json& result) { return result.dump(2, ' ', false, json::error_handler_t::replace) + "\n"; }

}  // namespace

Exit run_fit(const FitArguments& arguments, const Common& common) {
  const Clock clock;
  const CurveData data = read_curves(
      arguments.files, {.mode = arguments.mode, .x = arguments.x, .y = arguments.y, .where = arguments.where});
  if (common.check) {
    json result = head(arguments);
    result["sources"] = to_json(data);
    if (common.json) put(written(result));
    if (!common.json && !common.quiet) put(sources_as_text(data));
    return Exit::done;
  }
  if (!common.out.empty()) ensure_writable_folder(common.out);

  const OgdenFit fit = fit_ogden(data, arguments.residual == "absolute" ? Residual::absolute : Residual::relative);
  json result = head(arguments);
  result.update(to_json(fit, data));
  result["cost"] = clock.cost();
  if (!common.out.empty()) write_file((std::filesystem::path(common.out) / "result.json").string(), written(result));

  if (common.json) put(written(result));
  if (!common.json && !common.quiet) put(fit_as_text(fit, data));
  if (fit.minima.empty()) {
    fmt::print(stderr, "percal: {}\n", findings(fit)[0]);
    return Exit::outcome_not_reached;
  }
  return fit.minima[0].converged ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace percal::tools
