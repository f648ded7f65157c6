#include "core.hpp"

#include "percal/base/error.hpp"
#include "percal/base/version.hpp"
#include "percal/math/instruction_level.hpp"
#include "percal/store/store.hpp"
#include "percal/text/one_value.hpp"

namespace py = pybind11;

PYBIND11_MODULE(_core, core) {
  core.doc() = "What percal computes, as plain functions: see the functions of the package percal.";
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const percal::NoSuchFile& error) {
      PyErr_SetString(PyExc_FileNotFoundError, error.what());
    } catch (const percal::BadInput& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    } catch (const percal::IoFailure& error) {
      PyErr_SetString(PyExc_OSError, error.what());
    } catch (const percal::NoMemory& error) {
      PyErr_SetString(PyExc_MemoryError, error.what());
    }
  });
  core.attr("__version__") = percal::version();
  core.def("instruction_level", &percal::instruction_level);
  core.def("default_store_path", &percal::default_store_path);
  core.def("seconds", [](const std::string& text) {
    return percal::one_quantity(text, "budget", percal::dimension::time, percal::positive("time"));
  });
  percal::python::bind_fit(core);
  percal::python::bind_impact(core);
  percal::python::bind_jobs(core);
  percal::python::bind_shots(core);
  percal::python::bind_powder(core);
  percal::python::bind_card(core);
  percal::python::bind_pages(core);
}
