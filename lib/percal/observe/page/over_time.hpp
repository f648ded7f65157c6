// An impact over time, and where its energy went: sections of its page.
#pragma once
#include "percal/page/sections.hpp"

namespace percal::page {

Section impact_energy_section(const Json& result);   // shares at the end, and over time where there is a history
Section impact_history_section(const Json& result);  // depth, speed and force over time

}  // namespace percal::page
