// Sections of an impact's page. For the .cpp files of this folder.
#pragma once
#include "percal/page/sections.hpp"

namespace percal::page {

// The terms of the energy ledger: the key of a result, and its words.
struct EnergyTerm {
  const char* key;
  const char* words;
};
extern const std::vector<EnergyTerm> energy_terms;

Section energy_section(const Json& result);   // shares at the end, and over time where there is a history
Section history_section(const Json& result);  // depth, speed and force over time

}  // namespace percal::page
