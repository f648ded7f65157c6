// A calibration's job of steel balls into one gel, whose modulus alone is looked for.
#pragma once
#include <string>

namespace percal::test {

// Rows are in shots.csv; which of their columns say what was seen, and whatever else, the caller adds to its last table, [[shots]].
inline std::string ball_job(const std::string& least_mu = "50 kPa") {
  return "[parameters.mu]\nkind = \"modulus\"\nlow = \"" + least_mu + R"("
high = "900 kPa"
[materials.gel]
density = "1010 kg/m3"
mu = "mu"
alpha = 8
erosion_strain = 0.8
[[shots]]
name = "balls"
material = "gel"
file = "shots.csv"
diameter = "3.18 mm"
particle_density = "7800 kg/m3"
speed_column = "speed_m_s"
layer_depth = "25 mm"
)";
}

}  // namespace percal::test
