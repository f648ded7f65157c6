// The template of a calibration job.
#include "templates.hpp"

namespace percal::tools {
namespace {

const std::string shots_csv = R"(# An example, made up: replace the rows by your own shots.
ball,density_kg_m3,diameter_mm,speed_m_s,depth_mm,depth_error_mm,usable
steel,7800,3.18,50,26,1,yes
steel,7800,3.18,70,41,1,yes
steel,7800,3.18,90,55,2,yes
tungsten carbide,14900,3.18,60,68,2,yes
tungsten carbide,14900,3.18,80,92,3,no
)";
const std::string curve_csv = R"(# An example, made up: replace the rows by your own curve.
stretch,stress_kPa,usable
0.8,-97,yes
0.9,-40,yes
1.1,34,yes
1.2,66,yes
1.4,134,yes
1.5,90,no
)";
const std::string pairs_csv = "mu_kPa,erosion_strain\n120,1.1\n180,0.8\n";

}  // namespace

Template calibrate_template() {
  return {{"STEM.toml",
           R"(## A calibration: curves and depths of shots -> free parameters.          percal calibrate STEM.toml
## Lines behind "# " may be left out: they show the default, or an example where there is none.

# title = "STEM.toml"
# level = 0.95
# bootstrap = 200
# dehn = true

## What is looked for. The names are yours.
[parameters.mu]
kind = "modulus"
low = "30 kPa"
high = "600 kPa"
# prior = "120 kPa"
# prior_error = "20 %"

[parameters.erosion_strain]
kind = "erosion strain"
low = 0.3
high = 1.6

[materials.gel]
density = "1010 kg/m3"
mu = "mu"
alpha = 6
erosion_strain = "erosion_strain"
# rate_factor = 10
# rate_factor_error = 0
# curve_modulus = "100 kPa"

## Shots, point by point.
[[shots]]
name = "by hand"
material = "gel"
layer_depth = "120 mm"
# layer_depth_radii = 75 #> instead of layer_depth
# layer_width_radii = 5
# layer_width = "7.95 mm" #> instead of layer_width_radii
# speed_error = "0 m/s"
# leave_one_out = false
# scatter = "shots"

[[shots.points]]
# label = "steel 3.18 mm at 50 m/s"
diameter = "3.18 mm"
# radius = "1.59 mm" #> instead of diameter
particle_density = "7800 kg/m3"
speed = "50 m/s"
depth = "26 mm"
# depth_error = "1 mm"
# at_least = false
# use = "fit"

[[shots.points]]
diameter = "3.18 mm"
particle_density = "7800 kg/m3"
speed = "70 m/s"
depth = "41 mm"

[[shots.points]]
diameter = "3.18 mm"
particle_density = "7800 kg/m3"
speed = "90 m/s"
depth = "55 mm"

## Shots from the rows of a table.
# [[shots]]
# name = "balls"
# material = "gel"
# file = "STEM_shots.csv"
# where = ["usable=yes"]
# particle = "sphere"
# particle_column = "ball" #> instead of particle
# particle_density_column = "density"
# particle_density = "7800 kg/m3" #> instead of particle_density_column
# diameter_column = "diameter"
# diameter = "3.18 mm" #> instead of diameter_column
# radius_column = "diameter" #> instead of diameter_column
# radius = "1.59 mm" #> instead of diameter_column
# speed_column = "speed"
# speed = "70 m/s" #> instead of speed_column
# speed_error = "0 m/s"
# depth_column = "depth"
# depth_error = "5 %"
# depth_error_where = ["ball=steel"]
# depth_error_column = "depth_error" #> instead of depth_error and depth_error_where
# at_least = false
# at_least_where = ["speed_m_s=90"]
# layer_depth = "120 mm"
# layer_depth_radii = 75 #> instead of layer_depth
# layer_width_radii = 5
# layer_width = "7.95 mm" #> instead of layer_width_radii
# use = "fit"
# fit_where = ["ball=steel"]
# leave_one_out = false
# scatter = "shots"

# [[curves]]
# name = "tension"
# material = "gel"
# file = "STEM_curve.csv"
# where = ["usable=yes"]
# x = "stretch"
# y = "stress"
# mode = "uniaxial"
# error = 0
# rate_factor = 1
# rate_factor_error = 0
# scatter = "curves"
# synthetic = false

# [scatter.shots]
# estimated = true
# fixed = "3 %" #> instead of estimated

# [[hypotheses]]
# name = "as given"
# convention = "true"
# measure = "engineering"
# contact_stiffness = 0.6

# [hypotheses.hold]
# erosion_strain = 1.1

# [[cross_validation]]
# name = "slow -> fast"
# fit = ["ball=steel"]
# predict = ["ball=tungsten carbide"]
# hypotheses = ["as given"]
# goal = "10 %"

# [[ridge_points]]
# name = "found elsewhere"
# parameter = "mu"
# file = "STEM_pairs.csv"
# where = ["mu_kPa=120"]
# mu = "mu"
# erosion_strain = "erosion_strain"

# [training]
# coarse = 8
# fine = 16
# verify = 20
# initial = 160
# batch = 40
# most = 900
# fine_share = 0.25
# accuracy = 0.2
# failures_tolerated = 0.5
# verify_replicates = 1
# seed = 20090401

# [solver]
)" + solver_keys +
               R"(# end_time = "20 ms" #> only in a scene: in a job runs end when the sphere stops
)"},
          {"STEM_shots.csv", shots_csv},
          {"STEM_curve.csv", curve_csv},
          {"STEM_pairs.csv", pairs_csv}};
}

std::vector<Template> calibrate_variants() {
  const std::string head = R"([parameters.mu]
kind = "modulus"
low = "30 kPa"
high = "600 kPa"
[parameters.alpha]
kind = "exponent"
low = 2
high = 12
[materials.gel]
density = "1010 kg/m3"
mu = "mu"
alpha = "alpha"
erosion_strain = 0.8
)";
  const std::string block =
      "[[shots]]\nname = \"balls\"\nmaterial = \"gel\"\nfile = \"shots.csv\"\n"
      "depth_column = \"depth\"\n";
  return {{{"values.toml", head + block +
                               "radius = \"1.59 mm\"\nspeed = \"60 m/s\"\nparticle_density = \"7800 kg/m3\"\n"
                               "particle_column = \"ball\"\ndepth_error_column = \"depth_error\"\n"
                               "layer_depth_radii = 80\nlayer_width = \"8 mm\"\n"
                               "[scatter.shots]\nfixed = 0.03\n"},
           {"shots.csv", shots_csv}},
          {{"diameter.toml", head + block +
                                 "diameter = \"3.18 mm\"\nspeed_column = \"speed\"\n"
                                 "particle_density_column = \"density\"\nlayer_depth = \"12 cm\"\n"},
           {"shots.csv", shots_csv}},
          {{"radius.toml", head + block +
                               "radius_column = \"diameter\"\nspeed_column = \"speed\"\n"
                               "particle_density_column = \"density\"\nlayer_depth = \"12 cm\"\n"},
           {"shots.csv", shots_csv}},
          {{"point.toml", head + "[[shots]]\nname = \"one\"\nmaterial = \"gel\"\nlayer_depth = \"12 cm\"\n"
                                 "[[shots.points]]\nradius = \"1.59 mm\"\nparticle_density = \"7800 kg/m3\"\n"
                                 "speed = \"50 m/s\"\ndepth = \"26 mm\"\n"}}};
}

}  // namespace percal::tools
