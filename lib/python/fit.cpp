// Curves: points in, the fit as JSON out.
#include <fmt/core.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "core.hpp"
#include "percal/base/error.hpp"
#include "percal/fit/page/fit_json.hpp"
#include "percal/fit/points/thin_curves.hpp"
#include "percal/units/words.hpp"

namespace percal::python {
namespace {

namespace py = pybind11;
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

BadInput refused(const std::string& key, const std::string& found, const std::string& accepted) {
  return BadInput(Place{.file = "", .line = 0, .key = key}, found, accepted);
}

// One of the enumerators by its word.
template <class Choice>
Choice choice_of(const std::string& key, const std::string& text, std::initializer_list<Choice> all) {
  std::vector<std::string> words;
  for (const Choice one : all) {
    words.push_back(word(one));
    if (words.back() == text) return one;
  }
  throw refused(key, in_quotes(text), listed(words));
}

Deformation deformation_named(const std::string& mode) {
  if (const auto found = deformation_of(mode)) return *found;
  throw refused("mode", in_quotes(mode), deformation_words());
}

// None where no series is asked for.
std::optional<RelaxationChoice> relaxation_in(const py::dict& given, const CurveOptions& curve) {
  const auto text = given["relaxation"].cast<std::string>();
  if (text.empty()) return std::nullopt;
  const auto choice = relaxation_choice_of(text);
  if (!choice) throw refused("relaxation", in_quotes(text), relaxation_words);
  if (given["bootstrap"].cast<int>() > 0) throw refused("bootstrap", "this beside relaxation", "0");
  if (curve.loss != Loss::squares) throw refused("loss", word(curve.loss) + " beside relaxation", "squares");
  return choice;
}

FitRequest request_of(const py::dict& given) {
  FitRequest request;
  CurveOptions& curve = request.options;
  curve.model = choice_of("model", given["model"].cast<std::string>(),
                          {Model::ogden, Model::ogden2, Model::ogden3, Model::neo_hooke, Model::mooney_rivlin});
  curve.residual = choice_of("residual", given["residual"].cast<std::string>(),
                             {Residual::relative, Residual::absolute, Residual::error});
  curve.loss = choice_of("loss", given["loss"].cast<std::string>(), {Loss::squares, Loss::huber, Loss::cauchy});
  curve.signs = given["unconstrained"].cast<bool>() ? Signs::free : Signs::positive;
  if (py::isinstance<py::dict>(given["weights"])) {
    EqualTests tests;
    for (const auto& [name, share] : given["weights"].cast<std::map<std::string, double>>()) {
      if (!(share > 0)) throw refused("weights", fmt::format("{:g} for {}", share, in_quotes(name)), "numbers above 0");
      tests.of_test.emplace_back(name, share);
    }
    curve.weighting = tests;
  } else if (const auto weights = given["weights"].cast<std::string>(); weights == "tests") {
    curve.weighting = EqualTests{};
  } else if (weights != "points") {
    throw refused("weights", in_quotes(weights), "points, tests, or a dict of test names and numbers above 0");
  }
  const auto [low, high] = given["stretches"].cast<std::pair<double, double>>();
  if (!(low > 0 && low <= 1 && high >= 1 && low < high))
    throw refused("stretches", fmt::format("{:g}, {:g}", low, high), "0 < low <= 1 <= high");
  request.stretches = {low, high};
  request.relaxation = relaxation_in(given, curve);
  UncertaintyOptions& intervals = *request.intervals;
  intervals.level = given["level"].cast<double>();
  if (!(intervals.level > 0 && intervals.level < 1))
    throw refused("level", fmt::format("{:g}", intervals.level), "a number between 0 and 1, such as 0.95");
  intervals.bootstrap = given["bootstrap"].cast<int>();
  if (intervals.bootstrap < 0)
    throw refused("bootstrap", std::to_string(intervals.bootstrap), "a number of replicates, 0 for none");
  return request;
}

void check_length(const std::string& key, py::ssize_t found, py::ssize_t wanted) {
  if (found != wanted)
    throw refused(key, std::to_string(found) + " values", std::to_string(wanted) + ", as many as stretches");
}

// One deformation's word for all points, or one for each.
const std::string& mode_of(const std::vector<std::string>& modes, std::size_t i) {
  return modes.size() == 1 ? modes.front() : modes[i];
}

CurveData data_of(const Numbers& stretch, const Numbers& stress, const std::vector<std::string>& modes,
                  const std::optional<Numbers>& error, const std::optional<Numbers>& across,
                  const std::optional<Numbers>& time, bool cauchy) {
  const py::ssize_t count = stretch.size();
  check_length("stress", stress.size(), count);
  if (modes.size() != 1) check_length("mode", static_cast<py::ssize_t>(modes.size()), count);
  if (error) check_length("error", error->size(), count);
  if (across) check_length("across", across->size(), count);
  if (time) check_length("time", time->size(), count);
  CurveData data;
  for (py::ssize_t i = 0; i < count; ++i) {
    const Deformation deformation = deformation_named(mode_of(modes, i));
    const double amount = stretch.data()[i], given = stress.data()[i], second = across ? across->data()[i] : 1;
    const bool is_stretch = deformation != Deformation::simple_shear;
    if (!std::isfinite(amount) || !std::isfinite(given) || !(second > 0) || (is_stretch && !(amount > 0)))
      throw refused(fmt::format("stretch[{}]", i), fmt::format("{:g} with stress {:g}", amount, given),
                    is_stretch ? "a stretch above 0 with a finite stress in Pa" : "finite shear and stress in Pa");
    if (deformation == Deformation::biaxial && !across)
      throw refused("across", "nothing", "the second stretch of every point, since the mode is general_biaxial");
    StressPoint point{.strained = {deformation, amount, second}, .nominal_stress = given};
    if (error) point.standard_error = error->data()[i];
    if (error && !(*point.standard_error > 0))
      throw refused(fmt::format("error[{}]", i), fmt::format("{:g}", *point.standard_error), "a stress in Pa above 0");
    if (cauchy) {
      point.nominal_stress = nominal_of_cauchy(given, point.strained);
      if (error) point.standard_error = nominal_of_cauchy(*point.standard_error, point.strained);
    }
    if (time) point.time = time->data()[i];
    if (time && !std::isfinite(*point.time)) throw refused(fmt::format("time[{}]", i), "no number", "a time in s");
    data.points.push_back(point);
  }
  data.sources = {{.file = "arrays",
                   .x = "stretch",
                   .y = "stress",
                   .stress = cauchy ? StressMeasure::cauchy : StressMeasure::nominal,
                   .mode_column = modes.size() != 1,
                   .points = static_cast<int>(count)}};
  thin(data);
  return data;
}

// The points as columns of arrays.
py::dict columns_of(const CurveData& data) {
  const auto count = static_cast<py::ssize_t>(data.points.size());
  Numbers stretch(count), across(count), stress(count);
  py::list modes;
  for (py::ssize_t i = 0; i < count; ++i) {
    const StressPoint& point = data.points[i];
    stretch.mutable_data()[i] = point.strained.amount;
    across.mutable_data()[i] = point.strained.across;
    stress.mutable_data()[i] = point.nominal_stress;
    modes.append(word(point.strained.deformation));
  }
  return py::dict(py::arg("stretch") = stretch, py::arg("across") = across, py::arg("stress") = stress,
                  py::arg("mode") = modes);
}

// The fit as JSON and the points that it was made from.
py::tuple fit(const FitRequest& request, const CurveData& data) {
  const Stopwatch clock;
  FinishedFit found{.data = data, .fit = {}};
  interruptible([&](const std::atomic<bool>& stop) {
    found.fit = fit_curves(data, request.options);
    if (!stop && request.relaxation)
      found.relaxation = fit_relaxation(data, found.fit, *request.relaxation, request.intervals);
    const bool relaxes = found.relaxation && found.relaxation->terms > 0;
    if (!stop && !relaxes) found.uncertainty = uncertainty_of(data, found.fit, *request.intervals);
  });
  return py::make_tuple(page::written(fit_to_json(request, found, clock.cost())), columns_of(data));
}

Numbers stresses(const std::vector<std::pair<double, double>>& terms, const std::string& mode, const Numbers& stretch,
                 const std::optional<Numbers>& across) {
  Hyperelastic solid;
  for (const auto& [mu, alpha] : terms) solid.terms.push_back({mu, alpha});
  const Deformation deformation = deformation_named(mode);
  if (across) check_length("across", across->size(), stretch.size());
  Numbers result(stretch.size());
  for (py::ssize_t i = 0; i < stretch.size(); ++i) {
    const double amount = stretch.data()[i];
    if (deformation != Deformation::simple_shear && !(amount > 0))
      throw refused(fmt::format("stretch[{}]", i), fmt::format("{:g}", amount), "a stretch above 0");
    result.mutable_data()[i] = nominal_stress(solid, Strained{deformation, amount, across ? across->data()[i] : 1});
  }
  return result;
}

}  // namespace

void bind_fit(py::module_& core) {
  core.def("fit", [](const Numbers& stretch, const Numbers& stress, const std::vector<std::string>& modes,
                     const std::optional<Numbers>& error, const std::optional<Numbers>& across,
                     const std::optional<Numbers>& time, bool cauchy, const py::dict& options) {
    FitRequest request = request_of(options);
    if (time.has_value() != request.relaxation.has_value())
      throw refused("time", time ? "times without relaxation" : "nothing", "time and relaxation, or neither");
    const CurveData data = data_of(stretch, stress, modes, error, across, time, cauchy);
    request.files = {data.sources[0].file};
    return fit(request, data);
  });
  core.def("fit_csv", [](const std::vector<std::string>& files, const std::string& mode,
                         const std::map<std::string, std::string>& mode_of, const std::string& x, const std::string& y,
                         const std::string& error, const std::string& time, const std::vector<std::string>& where,
                         const py::dict& options) {
    FitRequest request = request_of(options);
    request.files = files;
    request.columns = {.mode = mode, .mode_of = mode_of, .x = x, .y = y, .error = error, .where = where};
    if (request.relaxation) {
      request.columns.times = TimesWanted{.column = time};
      request.columns.rows.holds = Holds::timed;
    } else if (!time.empty()) {
      throw refused("time", in_quotes(time) + " without relaxation", "both or neither");
    }
    return fit(request, read_curves(files, request.columns));
  });
  core.def("nominal_stress", &stresses);
}

}  // namespace percal::python
