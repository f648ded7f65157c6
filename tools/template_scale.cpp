// The template of a scaling job.
#include "templates.hpp"

namespace percal::tools {

Template scale_template() {
  return {
      {"STEM.toml", R"(## Two systems and what must hold for them to be similar.                  percal scale STEM.toml
## Lines behind "# " may be left out: they show the default, or an example where there is none. What a system does not say is
## not compared; what only the model lacks follows from similarity.

# tolerance = 0.01

## The system whose behaviour is known, by its numbers or by a scene.
[prototype]
# scene = "scene.toml" #> only in place of all keys of this table but penetration, strain_rate and time
# particle = "particle"
# target = "target"
# convention = "true"
# strain_measure = "engineering"
# radius = "1 um"
# particle_density = "16800 kg/m3"
# particle_modulus = "79 GPa"
# speed = "651 m/s"
# target_density = "1000 kg/m3"
# mu = "15 MPa"
# alpha = 9.0
# erosion_strain = 0.7
# depth = "75 um"
# width = "5 um"
# penetration = "26 um"
# strain_rate = "1e7 1/s"
# time = "1 us"

## The system that is looked for.
[model]
# scene = "scene.toml" #> only in place of all keys of this table but penetration, strain_rate and time
# particle = "particle"
# target = "target"
# convention = "true"
# strain_measure = "engineering"
# radius = "1.59 mm"
# particle_density = "7800 kg/m3"
# particle_modulus = "210 GPa"
# speed = "83 m/s"
# target_density = "464 kg/m3"
# mu = "113 kPa"
# alpha = 9.0
# erosion_strain = 0.7
# depth = "119 mm"
# width = "8 mm"
# penetration = "41 mm"
# strain_rate = "1e3 1/s"
# time = "10 ms"

# [output] #> only with prototype.scene
# scene = "STEM_similar.toml" #> only with prototype.scene
)"}};
}

std::vector<Template> scale_variants() {
  const std::string scene =
      "[particle]\nradius = \"1 um\"\ndensity = \"16800 kg/m3\"\nspeed = \"651 m/s\"\n[target]\n"
      "density = \"1000 kg/m3\"\nmu = \"15 MPa\"\nalpha = 9\ndepth = \"75 um\"\nwidth = \"5 um\"\n";
  return {{{"scenes.toml",
            "[prototype]\nscene = \"gold.toml\"\n[model]\nscene = \"gold.toml\"\n[output]\n"
            "scene = \"similar.toml\"\n"},
           {"gold.toml", scene}}};
}

}  // namespace percal::tools
