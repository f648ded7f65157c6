// Material cards; materials go as JSON objects, the `card` of result files.
#include <pybind11/stl.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core.hpp"
#include "percal/card/card_json.hpp"
#include "percal/card/solver.hpp"
#include "percal/card/uniaxial_deck.hpp"
#include "percal/units/words.hpp"

namespace percal::python {
namespace {

namespace py = pybind11;
using nlohmann::json;

Solver solver_named(const std::string& word) {
  const auto& words = solver_words();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end())
    throw BadInput(Place{.file = "", .line = 0, .key = "solver"}, in_quotes(word), listed(words));
  return static_cast<Solver>(found - words.begin());
}

CardMaterial material_of(const std::string& text) {
  return card_from_json(json::parse(text), Place{.file = "", .line = 0, .key = "card"});
}

std::string text_of(const CardMaterial& material) {
  return card_to_json(material).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string read(const std::string& text, const std::string& file, const std::optional<std::string>& solver,
                 const std::optional<std::string>& units) {
  const auto target = solver ? std::optional(solver_named(*solver)) : solver_of(text);
  if (!target)
    throw BadInput(Place{.file = file, .line = 0, .key = "solver"}, "a text without keywords of any of them",
                   listed(solver_words()));
  const auto system = units ? std::optional(unit_system(*units)) : unit_system_of(text);
  if (!system)
    throw BadInput(Place{.file = file, .line = 0, .key = "units"}, "a card that does not say its units",
                   "units=\"mm-t-s-MPa\", or \"si\"");
  return text_of(read_card(*target, text, file, *system));
}

}  // namespace

void bind_card(py::module_& core) {
  core.def("solvers", &solver_words);
  core.def("write_card", [](const std::string& solver, const std::string& material, const std::string& units) {
    return write_card(solver_named(solver), material_of(material), unit_system(units));
  });
  core.def("read_card", &read);
  core.def("uniaxial_deck", [](const std::string& solver, const std::string& material, const std::string& units,
                               double stretch, int increments, const std::string& job) {
    std::vector<std::pair<std::string, std::string>> files;
    for (const DeckFile& file : uniaxial_deck_files(solver_named(solver), material_of(material), unit_system(units),
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
