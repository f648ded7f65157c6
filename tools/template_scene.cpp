// The template of a scene, and scenes with the other shapes of the particle and the other criteria of erosion.
#include "templates.hpp"

namespace percal::tools {

Template scene_template() {
  return {{"STEM.toml",
           R"(## A scene: a particle shot straight down into a layer.                    percal impact STEM.toml
## Lines behind "# " may be left out: they show the default, or an example where there is none.

# geometry = "axisymmetric"
# replicates = 3

[particle]
# shape = "sphere"
# name = "sphere"
radius = "1.59 mm"
density = "7800 kg/m3"
speed = "83 m/s"
# youngs_modulus = "210 GPa"
# poisson_ratio = 0.3
# elasticity = "automatic"
# vertices = [["0 mm", "0 mm"], ["2 mm", "3 mm"], ["-2 mm", "3 mm"]] #> only shape = "profile"
# side = "6 mm" #> only shape = "rhombus"
# tip_angle = "60 deg" #> only shape = "rhombus" or "cone"
# orientation = "0 deg" #> only shape = "profile", "rhombus" or "cone"
# rotation = "fixed" #> only shape = "profile", "rhombus" or "cone"
# mass = "0.7 g" #> only shape = "profile", "rhombus" or "cone", instead of density
# thickness = "3 mm" #> only beside mass in plane strain

[target]
# name = "target"
density = "1010 kg/m3"
mu = "113 kPa"
# convention = "true"
alpha = 9.0
# nu = 0.49
# bulk_to_shear = 50 #> instead of nu
depth = "120 mm"
width = "8 mm"
# bottom = "free"

# [target.erosion]
# strain = 0.7
# measure = "engineering"
# stress = "2 MPa" #> only in place of strain and measure
# energy = "500 kJ/m3" #> only in place of strain and measure

# [[target.relaxation]]
# share = 0.3
# time = "10 us"

# [[below]]
# name = "layer"
# density = "1010 kg/m3"
# mu = "200 kPa"
# alpha = 9.0
# nu = 0.49
# bulk_to_shear = 50 #> instead of nu
# depth = "20 mm"

# [below.erosion]
# strain = 0.7
# stress = "2 MPa" #> only where [target.erosion] has it
# energy = "500 kJ/m3" #> only where [target.erosion] has it

# [mesh]
# elements_per_radius = 10
# fine_width = 1
# graded_columns = 20
# whole = false

# [solver]
)" + solver_keys +
               R"(# end_time = "20 ms"

# [output]
# history = false
)"}};
}

std::vector<Template> scene_variants() {
  const std::string target = R"([target]
density = "1010 kg/m3"
mu = "113 kPa"
alpha = 9.0
depth = "120 mm"
width = "12 mm"
)";
  const std::string below = R"([[below]]
density = "1010 kg/m3"
mu = "200 kPa"
alpha = 9.0
bulk_to_shear = 50
depth = "20 mm"
)";
  const std::string sphere = "[particle]\nradius = \"1.59 mm\"\ndensity = \"7800 kg/m3\"\nspeed = \"83 m/s\"\n";
  return {{{"profile.toml",
            "geometry = \"plane strain\"\n[particle]\nshape = \"profile\"\nvertices = \"corners.csv\"\n"
            "orientation = \"5 deg\"\nrotation = \"free\"\nmass = \"0.7 g\"\nthickness = \"3 mm\"\n"
            "speed = \"40 m/s\"\n" +
                target},
           {"corners.csv", "x_mm,y_mm\n0,0\n2,3\n-2,3\n"}},
          {{"rhombus.toml",
            "geometry = \"plane strain\"\n[particle]\nshape = \"rhombus\"\nside = \"6 mm\"\n"
            "tip_angle = \"60 deg\"\ndensity = \"7800 kg/m3\"\nspeed = \"40 m/s\"\n" +
                target}},
          {{"cone.toml",
            "[particle]\nshape = \"cone\"\nradius = \"2 mm\"\ntip_angle = \"60 deg\"\n"
            "density = \"7800 kg/m3\"\nspeed = \"40 m/s\"\n" +
                target}},
          {{"stress.toml", sphere + target + "bulk_to_shear = 50\n[target.erosion]\nstress = \"2 MPa\"\n" + below +
                               "[below.erosion]\nstress = \"3 MPa\"\n"}},
          {{"energy.toml", sphere + target + "[target.erosion]\nenergy = \"500 kJ/m3\"\n" + below +
                               "[below.erosion]\nenergy = \"700 kJ/m3\"\n"}}};
}

}  // namespace percal::tools
