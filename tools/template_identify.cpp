// The template of an identification.
#include "templates.hpp"

namespace percal::tools {
namespace {

const std::string formulations_csv =
    R"(# An example, made up: formulations of the model material, shot with the model's ball.
concentration_wtpct,mu_quasistatic_kPa,mu_highrate_kPa,penetration_mm,penetration_sd_mm,measured
8,5.7,56,86,1.3,yes
10,8.5,83,62,1.2,yes
12,11.6,113,40,1.0,yes
)";
const std::string shots_csv = R"(# An example, made up: shots into the model material and into the tissue.
into,particle,density_kg_m3,radius_mm,speed_m_s,depth_mm,others_mm
gelatin,steel,7800,1.59,60,29,30
gelatin,steel,7800,1.59,83,41,42
tissue,gold,16800,0.001,550,0.022,0.021
tissue,gold,16800,0.0012,620,0.030,0.031
)";
const std::string pairs_csv = "mu_MPa,erosion_strain,mu_model_kPa\n25,0.5,189\n15,0.7,113\n";
const std::vector<TextFile> tables{
    {"STEM_formulations.csv", formulations_csv}, {"STEM_shots.csv", shots_csv}, {"STEM_pairs.csv", pairs_csv}};

Template with_tables(TextFile job) {
  Template result{std::move(job)};
  result.insert(result.end(), tables.begin(), tables.end());
  return result;
}

}  // namespace

Template identify_template() {
  return with_tables(
      {"STEM.toml",
       R"(## From shots into a model material to the constants of a tissue.        percal identify STEM.toml
## Lines behind "# " may be left out: they show the default, or an example where there is none.

# title = "STEM.toml"

[convention]
modulus = "true"
# strain = "engineering"

## The model material.
[gelatin]
# name = "gelatin"
density = "1010 kg/m3"
rate_factor = 9.74
# exponent = 1.8

[gelatin.formulations]
# name = "gelatin formulations"
file = "STEM_formulations.csv"
# where = ["measured=yes"]
concentration = "concentration"
mu_quasi_static = "mu_quasistatic"
# mu_high_rate = "mu_highrate"
penetration = "penetration"
# penetration_sd = "penetration_sd"
# law_rows = "measured=yes"

## What is looked for.
[tissue]
name = "tissue"
density = "1000 kg/m3"
rate_factor = 20

## The shot into the tissue.
[calibration]
particle = "gold"
radius = "1 um"
density = "16800 kg/m3"
speed = "651 m/s"
# youngs_modulus = "79 GPa"
penetration = "26 um"
# penetration_standard_error = "0.9 um"

## The shot into the model material.
[model]
particle = "steel"
radius = "1.59 mm"
density = "7800 kg/m3"
speed = "83 m/s"
# youngs_modulus = "210 GPa"

# [layer]
# depth_over_radius = 75
# width_over_radius = 5
# bottom = "free"

# [solver]
# nu = 0.49
# bulk_to_shear = 50 #> instead of nu
)" + solver_keys +
           R"(# end_time = "20 ms" #> only in a scene: in a job runs end when the sphere stops

[alpha]
value = 9
# scan = [8, 8.5, 9, 9.5] #> only with [alpha.target], instead of value
# elements_per_radius = 10 #> only with scan
# replicates = 3 #> only with scan

# [alpha.target] #> only with scan
# name = "STEM_pairs.csv" #> only with scan
# file = "STEM_pairs.csv" #> only with scan
# where = ["erosion_strain=0.7"] #> only with scan
# mu = "mu" #> only with scan
# erosion_strain = "erosion_strain" #> only with scan
# mu_model = "mu_model" #> only with scan

[ridge]
erosion_strains = [0.4, 0.6, 0.8]
start = "15 MPa"
# elements_per_radius = 10

# [model_check]
# elements_per_radius = 14
# replicates = 3

# [mesh_study]
# elements_per_radius = [10, 14, 20]

# [[predictions]]
# system = "gold into tissue"
# table = ""
# file = "STEM_shots.csv"
# where = ["into=tissue"]
# particle = "sphere"
# particle_column = "particle" #> instead of particle
# particle_density = "16800 kg/m3"
# particle_density_column = "density" #> instead of particle_density
# radius_column = "radius"
# diameter_column = "radius" #> instead of radius_column
# speed_column = "speed"
# measured_column = "depth"
# reference_column = "others"
# material = "given"
# mu = "15 MPa"
# erosion_strain = 0.7
# target_density = ["1000 kg/m3"]
# nu = 0.49
# bulk_to_shear = 50 #> instead of nu
# elements_per_radius = 14
# replicates = 3

# [[trends]]
# name = "depth over speed"
# file = "STEM_shots.csv"
# where = ["into=gelatin"]
# x = "speed"
# y = "depth"
# reference_column = "others"
# reference_slope = 0.5
# reference_intercept = 0

# [scaled_line]
# name = "depths scaled from the model's line"
# reference_slope = "0.0049 cm m s/kg"
# reference_intercept = "-0.8 cm"
# reference_mean_error = 0.1

# [scaled_line.shots]
# name = "model shots"
# file = "STEM_shots.csv"
# where = ["into=gelatin"]
# density = "density"
# radius = "radius"
# diameter = "radius" #> instead of radius
# speed = "speed"
# penetration = "depth"

# [scaled_line.cases]
# file = "STEM_shots.csv"
# where = ["into=tissue"]
# particle = "sphere"
# particle_column = "particle" #> instead of particle
# particle_density = "16800 kg/m3"
# particle_density_column = "density" #> instead of particle_density
# radius_column = "radius"
# diameter_column = "radius" #> instead of radius_column
# speed_column = "speed"
# measured_column = "depth"
# reference_column = "others"

# [equal_mass]
# name = "shapes of equal mass"
# mass = "0.7 g"
# speed = "70 m/s"

# [[equal_mass.shapes]]
# name = "a prism"
# trend = "depth over speed"
# mass = "0.75 g"
# reference = "35 mm"

# [card]
# name = "tissue"
# comments = ["A line of the cards' head."]

# [reference]
# name = "reference"
# model_density = "464 kg/m3"
# modulus_ratio = 0.00755
# model_penetration = "41 mm"
# model_fe_penetration = "42 mm"
# model_modulus = "113 kPa"
# highrate_modulus = "15 MPa"
# erosion_strain = 0.7
# quasistatic_shear_modulus = "0.75 MPa"
# quasistatic_youngs_modulus = "2.25 MPa"
)"});
}

std::vector<Template> identify_variants() {
  std::string text = uncommented(identify_template().front().text);
  const auto replace = [&text](const std::string& from, const std::string& to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  };
  replace("\nvalue = 9\n",
          "\nscan = [8, 9]\nelements_per_radius = 10\nreplicates = 3\n[alpha.target]\nname = \"pairs\"\n"
          "file = \"STEM_pairs.csv\"\nwhere = [\"erosion_strain=0.7\"]\nmu = \"mu\"\n"
          "erosion_strain = \"erosion_strain\"\nmu_model = \"mu_model\"\n");
  replace("\nparticle_density = \"16800 kg/m3\"\n", "\nparticle_density_column = \"density\"\n");
  replace("\nparticle = \"sphere\"\n", "\nparticle_column = \"particle\"\n");
  replace("\nradius_column = ", "\ndiameter_column = ");
  replace("\nradius = \"radius\"\n", "\ndiameter = \"radius\"\n");
  replace("\nnu = 0.49\n", "\nbulk_to_shear = 50\n");
  return {with_tables({"variant.toml", text})};
}

}  // namespace percal::tools
