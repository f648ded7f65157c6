// percal card write: the card of a result, or the card in a single-element test. percal card read, check: what a card means.
#include <fmt/core.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "colour.hpp"
#include "commands.hpp"
#include "element_size.hpp"
#include "pages.hpp"
#include "percal/base/printable.hpp"
#include "percal/card/card_comments.hpp"
#include "percal/card/card_curve.hpp"
#include "percal/card/card_json.hpp"
#include "percal/card/card_text.hpp"
#include "percal/card/solver.hpp"
#include "percal/page/numbers.hpp"
#include "percal/text/file.hpp"
#include "percal/text/one_value.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

using nlohmann::json;

// --density, --bulk-to-shear or --nu, and --name or --card.
CardRequest request_of(const CardArguments& card) {
  CardRequest request{.name = card.name};
  if (!card.density.empty())
    request.density = one_quantity(card.density, "--density", dimension::density, positive("density"));
  if (card.bulk_to_shear && !(*card.bulk_to_shear > 0 && std::isfinite(*card.bulk_to_shear)))
    throw BadInput({"", 0, "--bulk-to-shear"}, std::to_string(*card.bulk_to_shear), "a positive number K/mu");
  if (card.nu && !(*card.nu > 0 && *card.nu < 0.5))
    throw BadInput({"", 0, "--nu"}, std::to_string(*card.nu), "a number between 0 and 0.5");
  request.bulk_to_shear = card.nu ? bulk_to_shear(*card.nu) : card.bulk_to_shear;
  return request;
}

// --mode, --range and --points.
CurveRange range_of(const CardArguments& card) {
  CurveRange range;
  const auto deformation = deformation_of(card.mode);
  if (!deformation) throw BadInput({"", 0, "--mode"}, in_quotes(card.mode), "uniaxial, equibiaxial, planar or shear");
  range.deformation = *deformation;
  if (range.deformation == Deformation::simple_shear) range.low = 0, range.high = 1;
  if (!card.range.empty()) {
    const auto colon = card.range.find(':');
    const auto low = field_number(card.range.substr(0, colon));
    const auto high = colon == std::string::npos ? std::nullopt : field_number(card.range.substr(colon + 1));
    if (!low || !high) throw BadInput({"", 0, "LOW:HIGH"}, in_quotes(card.range), "two numbers such as 0.5:2");
    range.low = *low;
    range.high = *high;
  }
  range.points = card.points;
  return range;
}

// `what` ("card", "deck") of a result for a solver: files go to the folder of --file, under their own names.
Exit deliver(const std::vector<DeckFile>& files, const std::string& what, const std::string& of_what,
             const CardArguments& card, const Common& common) {
  if (common.check) {
    if (!common.quiet) print(fmt::format("{}: a result that {} can have a {} of\n", card.result, card.solver, what));
    return Exit::done;
  }
  if (card.file.empty()) {
    std::vector<std::string> names;
    for (const DeckFile& file : files) names.push_back(file.name);
    if (files.size() > 1)
      throw BadInput(
          Place{.file = "", .line = 0, .key = "--file"}, "nothing",
          fmt::format("a name: the {} for {} is {} files, as {}", what, card.solver, files.size(), listed(names)));
    print(files.front().text);
    return Exit::done;
  }
  for (const DeckFile& file : files) {
    const std::string path = (std::filesystem::path(card.file).parent_path() / file.name).string();
    write_file(path, file.text);
    if (!common.quiet) print(fmt::format("wrote {}: {}\n", path, of_what));
  }
  return Exit::done;
}

// A material read from a card or, without a solver, from a result of percal; density and bulk modulus may be missing.
ReadCard read(const CardArguments& card) {
  refuse_document(card.card, "a card of a solver, or the result.json of a command of percal");
  const std::string text = read_file(card.card);
  const auto start = text.find_first_not_of(" \t\r\n");
  if (start != std::string::npos && text[start] == '{') {
    CardRequest request = request_of(card);
    request.complete = false;
    const CardMaterial material = card_of_result(text, card.card, request);
    return {{material, 0}, "", "si", implausible(material)};
  }
  return read_card({text, card.card, card.solver, card.units, card.name});
}

std::string pressure(double pascals) { return page::pressure(pascals, 9); }

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  return page::as_text(page::Table{.caption = "", .rows = rows, .notes = {}}, terminal_style(page::Detail::answer));
}

std::string bulk_words(const CardMaterial& material) {
  const double bulk = material.bulk_modulus, ratio = bulk / shear_modulus(material);
  if (std::isnan(bulk)) return "not given";
  if (std::isinf(bulk)) return "without limit: incompressible";
  return fmt::format("{} = {:.6g} mu, Poisson's ratio {:.9g}", pressure(bulk), ratio, poisson_ratio(ratio));
}

std::string erosion_words(const FoundCard& found) {
  if (found.material.erosion)
    return "erosion at a largest principal strain of " + in_all_measures(*found.material.erosion);
  return found.erodes_otherwise ? "elements erode by limits that percal has not: see what is passed over"
                                : "no erosion";
}

// What the card says, in both conventions of the modulus; what is doubtful about it first.
std::string summary(const ReadCard& read, const std::string& file) {
  const CardMaterial& material = read.found.material;
  const double mu = shear_modulus(material);
  std::string text;
  for (const std::string& one : read.warnings) text += "warning: " + printable(one) + "\n";
  text += fmt::format("{}: material '{}'", printable(file), printable(material.name));
  text += read.solver.empty() ? "\n" : fmt::format(", a card for {} in {}\n", read.solver, read.units);
  std::vector<std::vector<std::string>> rows = {{"term", "mu", "alpha", "2 mu/alpha"}};
  for (std::size_t k = 0; k < material.terms.size(); ++k) {
    const Ogden& term = material.terms[k];
    rows.push_back({std::to_string(k + 1), pressure(term.mu), fmt::format("{:.9g}", term.alpha),
                    pressure(2 * term.mu / term.alpha)});
  }
  text += aligned(rows);
  text +=
      fmt::format("  small-strain shear modulus mu: {}, Young's modulus 3 mu: {}\n", pressure(mu), pressure(3 * mu));
  text += fmt::format("  bulk modulus K: {}\n", bulk_words(material));
  text += std::isnan(material.density) ? "  density: not given\n"
                                       : fmt::format("  density: {:.9g} kg/m3\n", material.density);
  text += "  " + erosion_words(read.found) + "\n";
  for (const std::string& one : read.found.ignored) text += "  passed over: " + printable(one) + "\n";
  return text;
}

std::string curve_text(const CardMaterial& material, const CurveRange& range) {
  const bool shear = range.deformation == Deformation::simple_shear;
  const double mu = shear_modulus(material), bulk = material.bulk_modulus;
  std::vector<std::vector<std::string>> rows = {{shear ? "shear" : "stretch", "nominal stress", "Cauchy stress"}};
  for (const CurvePoint& point : card_curve(material, range))
    rows.push_back({fmt::format("{:.6g}", point.amount), pressure(point.stress),
                    pressure(shear ? point.stress : point.stress * point.amount)});
  std::string text = fmt::format("  {}, incompressible (closed form, K without limit):\n", word(range.deformation));
  text += aligned(rows);
  if (std::isfinite(bulk))
    text += fmt::format(
        "  with this K Young's modulus is 9 K mu/(3 K + mu) = {}, {:.3g} % below 3 mu; away from J = 1 the programs'\n"
        "  volumetric laws differ\n",
        pressure(9 * bulk * mu / (3 * bulk + mu)), 100 * mu / (3 * bulk + mu));
  return text + "  " + stability_of(material) + "\n";
}

json points_of(const CardMaterial& material, const CurveRange& range) {
  json amounts = json::array(), stresses = json::array();
  for (const CurvePoint& point : card_curve(material, range)) {
    amounts.push_back(point.amount);
    stresses.push_back(point.stress);
  }
  return {{"deformation", word(range.deformation)}, {"stretch_or_shear", amounts}, {"nominal_stress_Pa", stresses}};
}

}  // namespace

Exit run_card_write(const CardArguments& arguments, const Common& common) {
  CardArguments card = arguments;
  card.result = result_file(card.result);
  const UnitSystem units = unit_system(card.units.empty() ? "si" : card.units);
  refuse_document(card.result, "the result.json of fit, identify or calibrate, or of card read --json");
  CardMaterial material = card_of_result(read_file(card.result), card.result, request_of(card));
  if (!material.contradiction.empty() && !card.force)
    throw BadInput({card.result, 0, "cards"}, "a card whose data contradict each other: " + material.contradiction,
                   "data that agree; --force writes the card with a warning in it");
  if (!card.file.empty() && !common.check) ensure_writable_file(card.file);
  if (!card.element_size.empty()) {
    if (const auto found = strain_for_elements(card, material, common)) {
      if (!found->why_not.empty()) {
        print(fmt::format("no erosion strain for these elements: {}\n", found->why_not), stderr);
        return Exit::outcome_not_reached;
      }
      if (!common.quiet) print(in_words(*found) + "\n", stderr);
      material = for_elements(material, found->strain, found->element, found->radius, in_words(*found));
    }
  }
  const std::string of_what = fmt::format("'{}' for {} in {}", material.name, card.solver, units.name);
  if (!card.deck.empty()) {
    const UniaxialTest test{.stretch = card.stretch, .increments = card.increments};
    return deliver(uniaxial_deck(solver_named(card.solver), material, units, test, card.file), "deck",
                   "uniaxial test of " + of_what, card, common);
  }
  const std::string text = card.solver == "csv" ? csv_card(material, units, range_of(card))
                                                : solver_named(card.solver).card(material, units);
  return deliver({{std::filesystem::path(card.file).filename().string(), text}}, "card", of_what, card, common);
}

Exit run_card_read(const CardArguments& card, const Common& common) {
  const ReadCard found = read(card);
  if (common.json) {
    fmt::print("{}", page::written(read_card_to_json(found)));
  } else {
    fmt::print("{}", summary(found, card.card));
  }
  return Exit::done;
}

Exit run_card_check(const CardArguments& card, const Common& common) {
  const ReadCard found = read(card);
  const CardMaterial& material = found.found.material;
  const CurveRange range = range_of(card);
  if (!card.csv.empty()) write_file(card.csv, csv_card(material, unit_system(found.units), range));
  if (common.json) {
    json result = read_card_to_json(found);
    result["curve"] = points_of(material, range);
    result["stability"] = stability_of(material);
    fmt::print("{}", page::written(result));
  } else {
    fmt::print("{}", summary(found, card.card) + curve_text(material, range));
  }
  return Exit::done;
}

}  // namespace percal::tools
