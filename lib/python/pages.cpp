// Results as pages.
#include "core.hpp"
#include "page_of_result.hpp"
#include "percal/page/figures.hpp"
#include "percal/page/html.hpp"
#include "percal/text/json.hpp"

namespace percal::python {

void bind_pages(pybind11::module_& core) {
  // A result.json as percal report shows it.
  core.def("html", [](const std::string& result) {
    const pybind11::gil_scoped_release free_interpreter;
    const page::Page page =
        tools::page_of_result(parse_json(result, "this result", "a result of percal"), "this result");
    return page::html(page, page::draw_figures(page));
  });
}

}  // namespace percal::python
