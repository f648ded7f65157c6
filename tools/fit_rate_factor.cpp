// percal fit --rate-factor LOW_RATE HIGH_RATE: one factor between the curves of one solid at two rates.
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "fit_output.hpp"
#include "fit_text.hpp"
#include "pages.hpp"
#include "percal/fit/fit_json.hpp"
#include "percal/fit/read_curves.hpp"
#include "percal/fit/uncertainty_json.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

using nlohmann::json;

struct Pair {
  CurveData slow, fast;
};

CurveColumns columns_of(const FitArguments& arguments) {
  return {
      .mode = arguments.mode, .x = arguments.x, .y = arguments.y, .error = arguments.error, .where = arguments.where};
}

// The rows of a file whose rates are two different numbers; the smaller is the low rate.
Pair by_rate_column(const FitArguments& arguments) {
  CsvTable table = read_csv(arguments.files[0]).where(arguments.where);
  const int column = table.column(arguments.rate_column);
  table.columns[static_cast<std::size_t>(column)].unit.clear();  // rates in any unit: only their order counts
  const auto rates = table.numbers(column, dimension::none);
  std::map<double, CsvTable> of_rate;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    auto& rows = of_rate.try_emplace(rates[i], table).first->second.rows;
    if (rows.size() == table.rows.size()) rows.clear();
    rows.push_back(table.rows[i]);
  }
  if (of_rate.size() != 2)
    throw BadInput({arguments.files[0], table.header_line, table.columns[static_cast<std::size_t>(column)].header},
                   fmt::format("{} different rates", of_rate.size()), "two, chosen with --where if there are more");
  CurveColumns columns = columns_of(arguments);
  columns.where.clear();
  return {curves_of(of_rate.begin()->second, columns), curves_of(of_rate.rbegin()->second, columns)};
}

Pair read(const FitArguments& arguments) {
  const std::size_t files = arguments.rate_column.empty() ? 2 : 1;
  if (arguments.files.size() != files)
    throw BadInput(
        {"", 0, "--rate-factor"}, fmt::format("{} file(s)", arguments.files.size()),
        files == 2 ? "two files, the low rate first; or one file with --rate-column" : "one file with --rate-column");
  if (files == 1) return by_rate_column(arguments);
  return {read_curves({arguments.files[0]}, columns_of(arguments)),
          read_curves({arguments.files[1]}, columns_of(arguments))};
}

Residual residual_of(const FitArguments& arguments) {
  for (const Residual residual : {Residual::absolute, Residual::error})
    if (arguments.residual == word(residual)) return residual;
  return Residual::relative;
}

std::vector<std::string> row(const std::string& name, const ParameterUncertainty& parameter, const PressureUnit& unit) {
  const double size = parameter.unit.empty() ? 1 : unit.size;
  const auto& [low, high, low_open, high_open] = parameter.interval;
  return {name, fmt::format("{:.5g}", parameter.value / size),
          fmt::format("{:.5g}{} to {:.5g}{}", low / size, low_open ? " (open)" : "", high / size,
                      high_open ? " (open)" : ""),
          parameter.unit.empty() ? "" : unit.symbol};
}

std::string curve_as_text(const char* name, const RateCurve& curve) {
  const PressureUnit unit = unit_for(curve.alone.mu);
  return fmt::format("{}: {} points; alone mu {:.5g} {}, alpha {:.5g}; errors from the {}\n", name, curve.points,
                     curve.alone.mu / unit.size, unit.symbol, curve.alone.alpha, word(curve.errors));
}

std::string as_text(const RateFactor& rate, const Pair& pair) {
  std::string text = sources_as_text(pair.slow) + sources_as_text(pair.fast);
  text += fmt::format("one-term Ogden, {} residuals, one alpha for both rates\n", word(rate.residual));
  text += curve_as_text("low rate", rate.slow) + curve_as_text("high rate", rate.fast) + "\n";
  text += aligned({{"", "value", fmt::format("{:g} % interval", 100 * rate.level), ""},
                   row("rate factor", rate.factor, {"", 1}),
                   row("mu at the low rate", rate.mu_slow, unit_for(rate.mu_slow.value)),
                   row("mu at the high rate", rate.mu_fast, unit_for(rate.mu_fast.value)),
                   row("alpha", rate.alpha, {"", 1})});
  for (const auto& sentence : rate.findings) text += fmt::format("\n{}\n", sentence);
  return text;
}

}  // namespace

Exit run_rate_factor(const FitArguments& arguments, const Common& common) {
  const Clock clock;
  const Pair pair = read(arguments);
  json result = fit_head(arguments);
  result["sources"] = json::array({to_json(pair.slow)[0], to_json(pair.fast)[0]});
  if (common.check) {
    if (common.json) put(written(result));
    if (!common.json && !common.quiet) put(sources_as_text(pair.slow) + sources_as_text(pair.fast));
    return Exit::done;
  }
  if (!common.out.empty()) ensure_writable_folder(common.out);
  const RateFactor rate = fit_rate_factor(pair.slow, pair.fast, residual_of(arguments), arguments.level);
  result.update(to_json(rate));
  result["data"] = points_of_curve("low rate", pair.slow);
  for (const json& list : points_of_curve("high rate", pair.fast)) result["data"].push_back(list);
  result["cost"] = clock.cost();
  deliver(result, common);
  if (!common.json && !common.quiet) put(as_text(rate, pair));
  return rate.converged ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace percal::tools
