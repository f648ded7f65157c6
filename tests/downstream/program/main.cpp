// A program of somebody else's: reads quantities, writes a card with the installed library.
#include <cstdio>
#include <percal/card/lsdyna/lsdyna.hpp>
#include <percal/units/quantity.hpp>

int main() {
  const double mu = percal::parse_quantity("1.2 MPa").value;
  const percal::CardMaterial gel{.name = "gel",
                                 .density = 1010,
                                 .terms = {{mu, 3}},
                                 .bulk_modulus = 50 * mu};
  std::puts(percal::lsdyna_card(gel, percal::unit_system("mm-t-s-MPa")).c_str());
}
