// The jobs: scale, calibrate, identify, campaign. A job in, its result.json out.
#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "core.hpp"
#include "percal/calibrate/calibration.hpp"
#include "percal/calibrate/page/page.hpp"
#include "percal/campaign/run_cost.hpp"
#include "percal/identify/identification.hpp"
#include "percal/identify/page/identification_json.hpp"
#include "percal/math/instruction_level.hpp"
#include "percal/scaling/page/page.hpp"
#include "percal/sweep/page/page.hpp"
#include "percal/sweep/sweep_runs.hpp"

namespace percal::python {
namespace {

namespace py = pybind11;
using nlohmann::json;
using Announce = std::function<void(const std::string&)>;

std::string scaled(const ScaleJob& job) {
  return text_of(scale_to_json(job, complete(job.prototype.system, job.model.system), ""));
}

// The scene of the prototype made similar with the job's model. Throws BadInput where there is none.
std::string similar_scene_of(ScaleJob job) {
  if (job.output_scene.empty()) job.output_scene = "similar scene";
  check_output_scene(job);
  return similar_scene_text(job, complete(job.prototype.system, job.model.system));
}

// Says a sentence to Python, if it listens; ends the work where it was asked to stop.
void say(const Announce& announce, const std::atomic<bool>& stop, const std::string& sentence) {
  if (stop) throw Interrupted();
  if (announce) announce(sentence);
}

std::string calibrated(const std::string& path, std::optional<double> budget_seconds, const std::string& store_path,
                       int threads, const Announce& announce) {
  CalibrationLimits limits;
  limits.budget_seconds = budget_seconds;
  std::string result;
  interruptible([&](const std::atomic<bool>& stop) {
    const CalibrationJob job = read_calibration_job(path);
    Store store(store_path);
    Campaign campaign(&store, threads);
    campaign.stop_when([&] { return stop.load(); });
    CalibrationResult found =
        calibrate(job, store, campaign, limits, [&](const std::string& sentence) { say(announce, stop, sentence); });
    found.cost.instruction_level = instruction_level();
    result = text_of(calibration_to_json(job, found));
  });
  return result;
}

std::string identified(const std::string& path, const std::string& store_path, int threads, const Announce& announce) {
  const auto start = std::chrono::steady_clock::now();
  std::string result;
  interruptible([&](const std::atomic<bool>& stop) {
    const IdentifyJob job = read_identify_job(path);
    Store store(store_path);
    Campaign campaign(&store, threads);
    campaign.stop_when([&] { return stop.load(); });
    const Identification found =
        identify(job, campaign, [&](const ComparedNumbers& step) { say(announce, stop, step.name); });
    result = text_of(identification_to_json(job, found, cost_since(start, campaign)));
  });
  return result;
}

// A plan's points, run; without the words of percal campaign and the files that it writes.
std::string swept(const std::string& path, const std::string& store_path, int threads) {
  const auto start = std::chrono::steady_clock::now();
  std::string result;
  interruptible([&](const std::atomic<bool>& stop) {
    const Plan plan = read_plan(path);
    const auto points = points_to_run(plan);
    Store store(store_path);
    Campaign campaign(&store, threads);
    campaign.stop_when([&] { return stop.load(); });
    Progress silent;
    SweepFindings found{.plan = plan, .points = points};
    found.runs = run_points(points, campaign, &store, silent);
    found.cost = cost_since(start, campaign);
    result = text_of(sweep_to_json(found));
  });
  return result;
}

}  // namespace

std::string text_of(const json& result) { return result.dump(-1, ' ', false, json::error_handler_t::replace); }

void bind_jobs(py::module_& core) {
  core.def("scale_file", [](const std::string& path) { return scaled(read_scale_job(path)); });
  core.def("scale_text",
           [](const std::string& text, const std::string& name) { return scaled(parse_scale_job(text, name)); });
  core.def("similar_scene_file", [](const std::string& path) { return similar_scene_of(read_scale_job(path)); });
  core.def("similar_scene_text", [](const std::string& text, const std::string& name) {
    return similar_scene_of(parse_scale_job(text, name));
  });
  core.def("calibrate", &calibrated);
  core.def("identify", &identified);
  core.def("campaign", &swept);
}

}  // namespace percal::python
