// A calibration of half a minute: five balls into a gel, modulus and erosion strain free.
#pragma once
#include "support/program.hpp"

namespace percal::acceptance {

inline constexpr const char* gel = R"(title = "Steel into a gel"
bootstrap = 20

[parameters.mu]
kind = "modulus"
low = "80 kPa"
high = "600 kPa"

[parameters.erosion_strain]
kind = "erosion strain"
low = 0.4
high = 1.2

[materials.gel]
density = "1010 kg/m3"
mu = "mu"
alpha = 8
erosion_strain = "erosion_strain"

[[shots]]
name = "balls"
material = "gel"
file = "gel_shots.csv"
particle_density = "7800 kg/m3"
diameter = "3.18 mm"
speed_column = "speed_m_s"
depth_column = "depth_cm"
layer_depth = "12 cm"
layer_width_radii = 5

[training]
coarse = 5
fine = 6
verify = 7
initial = 70
batch = 12
most = 94
accuracy = 0.01
)";
inline constexpr const char* gel_shots = "speed_m_s,depth_cm\n50,2.1\n60,2.7\n70,3.1\n80,3.8\n90,4.2\n";

// Writes gel.toml and its table into a folder of a test.
inline void write_gel_job(const test::ProgramFolder& in) {
  in.write("gel.toml", gel);
  in.write("gel_shots.csv", gel_shots);
}

}  // namespace percal::acceptance
