// percal fit FILE...: stress-stretch curves -> moduli and exponents, every minimum; with --rate-factor one factor between two.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <locale>
#include <map>
#include <sstream>
#include <utility>

#include "colour.hpp"
#include "pages.hpp"
#include "percal/fit/interval/findings.hpp"
#include "percal/fit/page/fit_json.hpp"
#include "percal/fit/page/page.hpp"
#include "percal/text/file.hpp"
#include "percal/text/one_value.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

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

// "planar=A.csv": a deformation's word and the file that it is of; none where a file of the whole name is there.
std::optional<std::pair<std::string, std::string>> mode_and_file(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || std::filesystem::exists(text) || !deformation_of(text.substr(0, equals)))
    return std::nullopt;
  return std::pair{text.substr(0, equals), text.substr(equals + 1)};
}

// Files and their deformations, said in front of a file or by --mode.
void read_files(const FitArguments& arguments, FitRequest& request) {
  const auto one_mode = [&](const std::string& mode, const std::string& file) {
    const auto [known, fresh] = request.columns.mode_of.try_emplace(file, mode);
    if (!fresh && known->second != mode)
      throw BadInput({"", 0, "--mode"}, known->second + " and " + mode + " for " + file, "one deformation for a file");
    if (std::find(request.files.begin(), request.files.end(), file) == request.files.end())
      request.files.push_back(file);
  };
  for (const std::string& text : arguments.files) {
    if (const auto both = mode_and_file(text))
      one_mode(both->first, both->second);
    else
      request.files.push_back(text);
  }
  for (const std::string& text : arguments.mode) {
    if (const auto both = mode_and_file(text)) {
      one_mode(both->first, both->second);
    } else if (request.columns.mode.empty()) {
      request.columns.mode = text;
    } else {
      throw BadInput({"", 0, "--mode"},
                     "both " + in_quotes(request.columns.mode) + " and " + in_quotes(text) + " for all files",
                     "one WORD, and WORD=FILE for single files");
    }
  }
  if (request.files.empty()) throw BadInput({"", 0, "files"}, "none", "one CSV file or more");
}

Specimen specimen_in(const FitArguments& arguments) {
  const auto size = [](const std::string& text, const char* option, const Dimension& dimension) {
    return optional_quantity(text, option, dimension, positive(name_of(dimension)));
  };
  return percal::specimen_of(
      {.gauge_length = size(arguments.gauge_length, "--gauge-length", dimension::length),
       .area = size(arguments.area, "--area", dimension::area),
       .width = size(arguments.width, "--width", dimension::length),
       .thickness = size(arguments.thickness, "--thickness", dimension::length),
       .specimen_diameter = size(arguments.specimen_diameter, "--specimen-diameter", dimension::length)},
      [](std::string key, const std::string& found, const std::string& accepted) {
        std::replace(key.begin(), key.end(), '_', '-');
        throw BadInput({"", 0, "--" + key}, found, accepted);
      });
}

RowChoice rows_of(const FitArguments& arguments) {
  RowChoice rows{.until = arguments.until.empty() ? CurveEnd::last_row : CurveEnd::peak,
                 .holds = arguments.without.empty() ? Holds::kept : Holds::left_out};
  if (arguments.branch.empty()) return rows;
  const auto branch = branch_choice_of(arguments.branch);
  if (!branch) throw BadInput({"", 0, "--branch"}, in_quotes(arguments.branch), branch_words);
  rows.branch = *branch;
  return rows;
}

// "0.05/s" or "5 mm/min" over the gauge length -> 1/s.
double rate_in(const std::string& text, const Specimen& specimen) {
  Quantity found{};
  try {
    found = parse_quantity(text);
  } catch (const std::invalid_argument& error) {
    throw BadInput({"", 0, "--rate"}, error.what(),
                   "a rate of stretch as \"0.05 1/s\", or of displacement as \"5 mm/min\"");
  }
  const bool speed = found.dimension == dimension::speed;
  if (speed && !specimen.gauge_length)
    throw BadInput({"", 0, "--rate"}, in_quotes(text) + " without --gauge-length",
                   "both, or a rate of stretch as \"0.05 1/s\"");
  if (!(found.value > 0) || !(speed || found.dimension == dimension::rate))
    throw BadInput({"", 0, "--rate"}, in_quotes(text),
                   "a positive rate of stretch as \"0.05 1/s\", or of displacement as \"5 mm/min\"");
  return speed ? found.value / *specimen.gauge_length : found.value;
}

// None without --relaxation.
std::optional<TimesWanted> times_in(const FitArguments& arguments, const Specimen& specimen) {
  if (arguments.relaxation.empty()) return std::nullopt;
  TimesWanted times{.column = arguments.time};
  for (const std::string& text : arguments.rate) {
    const auto equals = text.find('=');
    const double rate = rate_in(text.substr(0, equals), specimen);
    const bool fresh = equals == std::string::npos ? !std::exchange(times.rate, rate)
                                                   : times.rate_of.try_emplace(text.substr(equals + 1), rate).second;
    if (!fresh)
      throw BadInput({"", 0, "--rate"}, in_quotes(text) + " beside another",
                     "one RATE, and RATE=FILE for single files");
  }
  return times;
}

FitRequest request_of(const FitArguments& arguments) {
  FitRequest request{.files = {},
                     .columns = {.x = arguments.x,
                                 .y = arguments.y,
                                 .error = arguments.error,
                                 .where = arguments.where,
                                 .specimen = specimen_in(arguments),
                                 .rows = rows_of(arguments)},
                     .stretches = stretches_of(arguments.stable),
                     .compare = arguments.compare};
  read_files(arguments, request);
  request.columns.times = times_in(arguments, request.columns.specimen);
  if (request.columns.times) {
    request.columns.rows.holds = Holds::timed;
    request.relaxation = relaxation_choice_of(arguments.relaxation);
    if (!request.relaxation) throw BadInput({"", 0, "--relaxation"}, in_quotes(arguments.relaxation), relaxation_words);
    for (const auto& [file, rate] : request.columns.times->rate_of)
      if (std::ranges::find(request.files, file) == request.files.end())
        throw BadInput({"", 0, "--rate"}, in_quotes(file) + ", which is not fitted",
                       "RATE=FILE of " + listed(request.files));
  }
  CurveOptions& options = request.options;
  options.model = *model_of(arguments.model);
  for (const Residual residual : {Residual::relative, Residual::absolute, Residual::error})
    if (arguments.residual == word(residual)) options.residual = residual;
  for (const Loss loss : {Loss::squares, Loss::huber, Loss::cauchy})
    if (arguments.loss == word(loss)) options.loss = loss;
  options.weighting = weighting_of(arguments.weights);
  options.signs = arguments.unconstrained ? Signs::free : Signs::positive;
  request.intervals = {.level = arguments.level, .bootstrap = arguments.bootstrap};
  if (!arguments.intervals && !arguments.rate_factor) request.intervals.reset();
  if (arguments.rate_factor) request.rate_column = arguments.rate_column;
  return request;
}

// --check: the files and their columns.
Exit say_read(const page::Json& read, const Common& common) {
  if (common.json) fmt::print("{}", page::written(read));
  if (common.talks()) fmt::print("{}", page::as_text(read_page(read), terminal_style(page::Detail::answer)));
  return Exit::done;
}

// The lines of a scene that the relaxing solid is.
void write_target(const RelaxingSolid& solid, const std::string& folder) {
  const std::string target = target_of_scene(solid);
  if (!folder.empty() && !target.empty()) write_file(folder + "/target.toml", target);
}

Exit fit(const FitRequest& request, const Common& common) {
  const Stopwatch clock;
  FinishedFit found{.data = read_curves(request.files, request.columns), .fit = {}};
  if (common.check) return say_read(read_to_json(request, found.data.sources), common);
  const std::string folder = out_folder(request.files[0], common);
  found.fit = fit_curves(found.data, request.options);
  if (request.compare) found.comparison = compare_models(found.data, request.options);
  if (request.relaxation)
    found.relaxation = fit_relaxation(found.data, found.fit, *request.relaxation, request.intervals);
  const bool relaxes = found.relaxation && found.relaxation->terms > 0;
  if (request.intervals && !relaxes) found.uncertainty = uncertainty_of(found.data, found.fit, *request.intervals);
  if (relaxes) write_target(found.relaxation->minima.front().solid, folder);
  deliver(fit_to_json(request, found, clock.cost()), folder, common);
  if (relaxes) return found.relaxation->minima.front().minimum.converged ? Exit::done : Exit::outcome_not_reached;
  if (found.fit.minima.empty()) print("percal: " + findings(found.fit)[0] + "\n", stderr);
  return !found.fit.minima.empty() && found.fit.minima[0].converged ? Exit::done : Exit::outcome_not_reached;
}

// The rows of a file whose rates are two different numbers; the smaller is the low rate.
RatePair by_rate_column(const FitRequest& request) {
  CsvTable table = read_csv(request.files[0]).where(request.columns.where);
  const int column = table.column(*request.rate_column);
  table.columns[static_cast<std::size_t>(column)].unit.clear();  // rates in any unit: only their order counts
  const auto rates = table.numbers(column, dimension::none);
  std::map<double, CsvTable> of_rate;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    auto& rows = of_rate.try_emplace(rates[i], table).first->second.rows;
    if (rows.size() == table.rows.size()) rows.clear();
    rows.push_back(table.rows[i]);
  }
  if (of_rate.size() != 2)
    throw BadInput({request.files[0], table.header_line, table.columns[static_cast<std::size_t>(column)].header},
                   fmt::format("{} different rates", of_rate.size()), "two, chosen with --where if there are more");
  CurveColumns columns = request.columns;
  columns.where.clear();
  return {curves_of(of_rate.begin()->second, columns), curves_of(of_rate.rbegin()->second, columns)};
}

RatePair read_pair(const FitRequest& request) {
  const std::size_t files = request.rate_column->empty() ? 2 : 1;
  if (request.files.size() != files)
    throw BadInput(
        {"", 0, "--rate-factor"}, fmt::format("{} file(s)", request.files.size()),
        files == 2 ? "two files, the low rate first; or one file with --rate-column" : "one file with --rate-column");
  if (files == 1) return by_rate_column(request);
  return {read_curves({request.files[0]}, request.columns), read_curves({request.files[1]}, request.columns)};
}

Exit fit_factor(const FitRequest& request, const Common& common) {
  const Stopwatch clock;
  const RatePair pair = read_pair(request);
  if (common.check) return say_read(read_to_json(request, {pair.slow.sources[0], pair.fast.sources[0]}), common);
  const std::string folder = out_folder(request.files[0], common);
  const RateFactor found = fit_rate_factor(pair.slow, pair.fast, request.options.residual, request.intervals->level);
  deliver(rate_factor_to_json(request, pair, found, clock.cost()), folder, common);
  return found.converged ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace

Exit run_fit(const FitArguments& arguments, const Common& common) {
  const FitRequest request = request_of(arguments);
  for (const std::string& file : request.files) refuse_document(file, "CSV files of stress and stretch");
  return request.rate_column ? fit_factor(request, common) : fit(request, common);
}

}  // namespace percal::tools
