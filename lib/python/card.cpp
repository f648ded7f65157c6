// Material cards; materials go as JSON objects, as in the `cards` of result files.
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "core.hpp"
#include "percal/card/card_json.hpp"
#include "percal/card/solver.hpp"

namespace percal::python {
namespace {

namespace py = pybind11;
using nlohmann::json;

CardMaterial material_of(const std::string& text) {
  return card_from_json(json::parse(text), Place{.file = "", .line = 0, .key = "card"});
}

std::string text_of(const CardMaterial& material) {
  return card_to_json(material).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string read(const std::string& text, const std::string& file, const std::optional<std::string>& solver,
                 const std::optional<std::string>& units) {
  return read_card_to_json(read_card({text, file, solver.value_or(""), units.value_or(""), ""}))
      .dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

void bind_card(py::module_& core) {
  core.def("solvers", &solver_words);
  core.def("write_card", [](const std::string& solver, const std::string& material, const std::string& units) {
    return solver_named(solver).card(material_of(material), unit_system(units));
  });
  core.def("read_card", &read);
  core.def("uniaxial_deck", [](const std::string& solver, const std::string& material, const std::string& units,
                               double stretch, int increments, const std::string& job) {
    std::vector<std::pair<std::string, std::string>> files;
    for (const DeckFile& file : uniaxial_deck(solver_named(solver), material_of(material), unit_system(units),
                                              {.stretch = stretch, .increments = increments}, job))
      files.emplace_back(file.name, file.text);
    return files;
  });
  core.def("card_of_result", [](const std::string& text, const std::string& file, const std::string& name,
                                std::optional<double> density, std::optional<double> bulk_to_shear) {
    const CardRequest request{.name = name, .density = density, .bulk_to_shear = bulk_to_shear};
    return text_of(card_of_result(text, file, request));
  });
}

}  // namespace percal::python
