// Numbers that no soft solid has: most often a unit that was read wrongly.
#pragma once
#include <string>
#include <vector>

namespace percal {

// Sentences. Of a small-strain shear modulus in Pa; empty between 10 Pa and 10 GPa.
std::vector<std::string> implausible_modulus(double mu);

// Of a density in kg/m3; empty between 10 (foams) and 25000 kg/m3 (the heaviest metals), and where it is not known.
std::vector<std::string> implausible_density(double density);

}  // namespace percal
