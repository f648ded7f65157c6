#include "percal/card/lsdyna.hpp"

#include <fmt/core.h>

#include <cmath>

#include "percal/card/field.hpp"
#include "percal/card/header.hpp"

namespace percal {
namespace {

constexpr int columns = 10;
constexpr const char* material_id = "1";

std::string field(double value) { return number_field(value, columns); }

// PR in ten columns, which loses digits of K as nu approaches 0.5.
std::string poisson_field(const CardMaterial& material) {
  const double ratio = material.bulk_modulus / material.mu_true;
  std::string text = field(poisson_ratio(ratio));
  const double nu = *field_number(text);
  if (!(std::abs(bulk_to_shear(nu) / ratio - 1) <= 0.01)) {  // nu = 0.5 included
    throw BadInput(Place{.file = "", .line = 0, .key = "bulk_modulus_Pa"},
                   fmt::format("{:.6g} Pa, which is {:.3g} mu", material.bulk_modulus, ratio),
                   "for an LS-DYNA card some 1e-6 to 1e7 mu: PR has ten columns");
  }
  return text;
}

std::string erosion_keyword(const CardErosion& erosion) {
  std::string text;
  text += comment_lines("$", "elements go at a largest principal strain of " + in_all_measures(erosion));
  text += comment_lines("$", "strain measure of MXEPS: " + word(erosion.measure) +
                                 " (which measure LS-DYNA compares in this material is not documented: the number is "
                                 "written as given)");
  text += "*MAT_ADD_EROSION\n";
  text += "$      MID      EXCL    MXPRES     MNEPS    EFFEPS    VOLEPS    NUMFIP       NCS\n";
  text += fixed_line({material_id, "0.", "0.", "0.", "0.", "0.", "1.", "1."}, columns);
  text += "$   MNPRES     SIGP1     SIGVM     MXEPS     EPSSH     SIGTH   IMPULSE    FAILTM\n";
  text += fixed_line({"0.", "0.", "0.", field(erosion.limit), "0.", "0.", "0.", "0."}, columns);
  return text;
}

}  // namespace

std::string lsdyna_card(const CardMaterial& material, const UnitSystem& units) {
  check(material, Place{});
  const double mu1 = modulus_as_given(material.mu_true, material.alpha, ModulusConvention::mu_over_alpha);
  std::string text = card_header("$", material, units, {"MU1 = 2 mu/alpha", mu1});
  text += card_sources("$", material);
  text += "*MAT_OGDEN_RUBBER\n";
  text += "$      MID        RO        PR         N        NV         G      SIGF       REF\n";
  text += fixed_line(
      {material_id, field(material.density / units.density()), poisson_field(material), "0", "0", "0.", "0.", "0."},
      columns);
  text += "$      MU1       MU2       MU3       MU4       MU5       MU6       MU7       MU8\n";
  text += fixed_line({field(mu1 / units.stress), "0.", "0.", "0.", "0.", "0.", "0.", "0."}, columns);
  text += "$   ALPHA1    ALPHA2    ALPHA3    ALPHA4    ALPHA5    ALPHA6    ALPHA7    ALPHA8\n";
  text += fixed_line({field(material.alpha), "0.", "0.", "0.", "0.", "0.", "0.", "0."}, columns);
  if (material.erosion) text += erosion_keyword(*material.erosion);
  return text;
}

}  // namespace percal
