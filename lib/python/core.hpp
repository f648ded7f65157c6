// percal._core: the library as plain functions of numbers, arrays and texts. Results are JSON texts as the program writes them; the
// Python files beside it make objects of them.
#pragma once
#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace percal::python {

void bind_fit(pybind11::module_& core);     // fit.cpp
void bind_impact(pybind11::module_& core);  // impact.cpp
void bind_jobs(pybind11::module_& core);    // jobs.cpp
void bind_shots(pybind11::module_& core);   // shots.cpp
void bind_powder(pybind11::module_& core);  // powder.cpp
void bind_card(pybind11::module_& core);    // card.cpp
void bind_pages(pybind11::module_& core);   // pages.cpp

// A result without line breaks; bytes that are no UTF-8 replaced.
std::string text_of(const nlohmann::json& result);

// Does the work on a thread of its own while other Python threads run, and looks for signals meanwhile: after Ctrl-C `stop` becomes
// true, and once the work has ended KeyboardInterrupt is raised. What the work throws is thrown here. Needs the interpreter's lock.
void interruptible(const std::function<void(const std::atomic<bool>& stop)>& work);

}  // namespace percal::python
