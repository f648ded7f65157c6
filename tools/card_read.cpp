// percal card read, percal card check: what a card means.
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "card_options.hpp"
#include "pages.hpp"
#include "percal/card/header.hpp"
#include "percal/material/stability.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

using nlohmann::json;

std::string pressure(double pascals) {
  const double size = std::abs(pascals);
  if (size >= 1e9) return fmt::format("{:.9g} GPa", pascals / 1e9);
  if (size >= 1e6) return fmt::format("{:.9g} MPa", pascals / 1e6);
  if (size >= 1e3) return fmt::format("{:.9g} kPa", pascals / 1e3);
  return fmt::format("{:.9g} Pa", pascals);
}

std::string stability_of(const CardMaterial& material) {
  const StretchRange searched;
  return stability_sentence(stable_ranges({material.terms}, searched), searched);
}

// What the card says, in both conventions of the modulus.
std::string summary(const ReadCard& read, const std::string& file) {
  const CardMaterial& material = read.found.material;
  const double mu = shear_modulus(material), ratio = material.bulk_modulus / mu;
  std::string text = fmt::format("{}: material '{}'", file, material.name);
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
  text += fmt::format("  bulk modulus K: {} = {:.6g} mu, Poisson's ratio {:.9g}\n", pressure(material.bulk_modulus),
                      ratio, poisson_ratio(ratio));
  text += fmt::format("  density: {:.9g} kg/m3\n", material.density);
  text += material.erosion ? "  erosion at a largest principal strain of " + in_all_measures(*material.erosion) + "\n"
                           : "  no erosion\n";
  for (const std::string& one : read.found.ignored) text += "  passed over: " + one + "\n";
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

json as_json(const ReadCard& read) {
  return {{"card", card_to_json(read.found.material)},
          {"solver", read.solver.empty() ? json(nullptr) : json(read.solver)},
          {"units", read.units},
          {"passed_over", read.found.ignored}};
}

void print_json(const json& value) { print_text(value.dump(2, ' ', false, json::error_handler_t::replace) + "\n"); }

}  // namespace

Exit run_card_read(const CardArguments& card, const Common& common) {
  const ReadCard read = read_any_card(card);
  if (common.json) {
    print_json(as_json(read));
  } else {
    print_text(summary(read, card.card));
  }
  return Exit::done;
}

Exit run_card_check(const CardArguments& card, const Common& common) {
  const ReadCard read = read_any_card(card);
  const CurveRange range = curve_range(card);
  if (!card.csv.empty()) write_file(card.csv, csv_card(read.found.material, unit_system(read.units), range));
  if (common.json) {
    json result = as_json(read);
    result["curve"] = points_of(read.found.material, range);
    result["stability"] = stability_of(read.found.material);
    print_json(result);
  } else {
    print_text(summary(read, card.card) + curve_text(read.found.material, range));
  }
  return Exit::done;
}

}  // namespace percal::tools
