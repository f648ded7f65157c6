#include <chrono>
#include <future>
#include <optional>

#include "core.hpp"
#include "percal/campaign/campaign.hpp"

namespace percal::python {

namespace py = pybind11;

void interruptible(const std::function<void(const std::atomic<bool>& stop)>& work) {
  std::atomic<bool> stop{false};
  std::optional<py::error_already_set> signal;
  std::exception_ptr failure;
  {
    const py::gil_scoped_release free_interpreter;
    auto ended = std::async(std::launch::async, [&] { work(stop); });
    while (ended.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
      if (signal) continue;
      const py::gil_scoped_acquire hold_interpreter;
      if (PyErr_CheckSignals() == 0) continue;
      signal.emplace();
      stop = true;
    }
    try {
      ended.get();
    } catch (const Interrupted&) {  // `signal` says why
    } catch (...) {
      failure = std::current_exception();
    }
  }
  if (signal) throw py::error_already_set(*signal);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace percal::python
