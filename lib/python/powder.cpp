// Powders: where one ends up, and which one ends up where it is wanted. A job in, its result.json out.
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "core.hpp"
#include "page_of_result.hpp"
#include "percal/powder/page/page.hpp"
#include "percal/text/file.hpp"
#include "percal/text/json.hpp"

namespace percal::python {
namespace {

// `answer` makes a result of a job and its calibration.
template <class Answer>
std::string answered(const std::string& path, const Answer& answer) {
  std::string result;
  interruptible([&](const std::atomic<bool>&) {
    const PowderJob job = read_powder_job(path);
    const std::string file = tools::result_file(job.calibration.text);
    const page::Json calibration = parse_json(read_file(file), file, "a result of percal calibrate");
    tools::check_result(calibration, file);
    result = text_of(answer(job, of_spheres(kept_shot_model(calibration, file), file)));
  });
  return result;
}

}  // namespace

void bind_powder(pybind11::module_& core) {
  core.def("dose", [](const std::string& path) {
    return answered(path, [](const PowderJob& job, const ShotModel& calibration) {
      return dose_to_json(job, answer_dose(job, calibration));
    });
  });
  core.def("design", [](const std::string& path) {
    return answered(path, [](const PowderJob& job, const ShotModel& calibration) {
      return design_to_json(job, answer_design(job, calibration));
    });
  });
}

}  // namespace percal::python
