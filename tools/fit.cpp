// percal fit FILE...: stress-stretch curves -> moduli and exponents, every minimum.
#include <fmt/format.h>

#include <cmath>
#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>

#include "fit_output.hpp"
#include "fit_text.hpp"
#include "percal/card/card_json.hpp"
#include "percal/fit/cards.hpp"
#include "percal/fit/fit_json.hpp"
#include "percal/fit/read_curves.hpp"
#include "percal/fit/uncertainty_json.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

using nlohmann::json;

// A finite number that is the whole text.
std::optional<double> number_in(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0;
  if (!(stream >> number) || !stream.eof() || !std::isfinite(number)) return std::nullopt;
  return number;
}

StretchRange stretches_of(const std::string& text) {
  const auto colon = text.find(':');
  if (colon != std::string::npos) {
    const auto low = number_in(text.substr(0, colon)), high = number_in(text.substr(colon + 1));
    if (low && high && *low > 0 && *low <= 1 && *high >= 1 && *low < *high) return {*low, *high};
  }
  throw BadInput({"", 0, "--stable"}, in_quotes(text),
                 "LOW:HIGH, two stretches with 0 < LOW <= 1 <= HIGH, such as 0.3:3");
}

Weighting weighting_of(const std::string& text) {
  if (text == "points") return EqualPoints{};
  EqualTests tests;
  if (text == "tests") return tests;
  std::istringstream stream(text + ",");  // so that an empty text is an empty entry
  for (std::string entry; std::getline(stream, entry, ',');) {
    const auto equals = entry.rfind('=');
    const auto number = equals == std::string::npos ? std::nullopt : number_in(entry.substr(equals + 1));
    if (!number || !(*number > 0) || equals == 0)
      throw BadInput({"", 0, "--weights"}, in_quotes(text),
                     "points, tests, or NAME=NUMBER,... with numbers above 0, such as uniaxial=2,planar=1");
    tests.of_test.emplace_back(entry.substr(0, equals), *number);
  }
  return tests;
}

CurveOptions options_of(const FitArguments& arguments) {
  CurveOptions options;
  options.model = *model_of(arguments.model);
  for (const Residual residual : {Residual::relative, Residual::absolute, Residual::error})
    if (arguments.residual == word(residual)) options.residual = residual;
  for (const Loss loss : {Loss::squares, Loss::huber, Loss::cauchy})
    if (arguments.loss == word(loss)) options.loss = loss;
  options.weighting = weighting_of(arguments.weights);
  options.signs = arguments.unconstrained ? Signs::free : Signs::positive;
  return options;
}

CurveData read(const FitArguments& arguments) {
  return read_curves(
      arguments.files,
      {.mode = arguments.mode, .x = arguments.x, .y = arguments.y, .error = arguments.error, .where = arguments.where});
}

}  // namespace

Exit run_fit(const FitArguments& arguments, const Common& common) {
  if (arguments.rate_factor) return run_rate_factor(arguments, common);
  const Clock clock;
  const CurveOptions options = options_of(arguments);
  const StretchRange stretches = stretches_of(arguments.stable);
  const CurveData data = read(arguments);
  if (common.check) {
    json result = fit_head(arguments);
    result["sources"] = to_json(data);
    if (common.json) put(written(result));
    if (!common.json && !common.quiet) put(sources_as_text(data));
    return Exit::done;
  }
  if (!common.out.empty()) ensure_writable_folder(common.out);

  const CurveFit fit = fit_curves(data, options);
  std::vector<ComparedModel> models;
  if (arguments.compare) models = compare_models(data, options);
  Uncertainty uncertainty;
  if (arguments.intervals)
    uncertainty = uncertainty_of(data, fit, {.level = arguments.level, .bootstrap = arguments.bootstrap});
  json result = fit_head(arguments);
  result.update(to_json(fit, data, stretches));
  result["data"] = points_of_tests(data, fit.tests);
  result["uncertainty"] = arguments.intervals ? to_json(uncertainty) : json(nullptr);
  result["cards"] = cards_to_json(fit_cards(data, fit, uncertainty));
  if (arguments.compare) result["comparison"] = to_json(models, stretches);
  result["cost"] = clock.cost();
  deliver(result, common);
  if (!common.json && !common.quiet) put(fit_as_text(fit, data, stretches));
  if (!common.json && !common.quiet && arguments.intervals) put(uncertainty_as_text(uncertainty, fit));
  if (!common.json && !common.quiet && arguments.compare) put(comparison_as_text(models, stretches));
  if (fit.minima.empty()) {
    fmt::print(stderr, "percal: {}\n", findings(fit)[0]);
    return Exit::outcome_not_reached;
  }
  return fit.minima[0].converged ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace percal::tools
