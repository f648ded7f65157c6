// What the keys of scaling jobs mean.
#include "key_reference.hpp"

namespace percal::tools {

std::vector<KeyMeaning> scale_meanings() {
  return {
      {"scale", "tolerance", "difference up to which two groups agree, as a share"},
      {"scale", "prototype", "the system whose behaviour is known"},
      {"scale", "model", "the system that is looked for"},
      {"scale", "prototype.scene", "a scene in place of the numbers; response may stand beside it"},
      {"scale", "prototype.particle", "its name"},
      {"scale", "prototype.target", "its name"},
      {"scale", "prototype.convention", "how mu is meant; the model's default is the prototype's"},
      {"scale", "prototype.strain_measure", "how erosion_strain is meant; the model's default is the prototype's"},
      {"scale", "prototype.radius", "of the particle"},
      {"scale", "prototype.particle_density", "of the particle"},
      {"scale", "prototype.particle_modulus", "the particle's Young's modulus"},
      {"scale", "prototype.speed", "at impact"},
      {"scale", "prototype.target_density", "of the target"},
      {"scale", "prototype.mu", "Ogden modulus, as convention says"},
      {"scale", "prototype.alpha", "Ogden exponent"},
      {"scale", "prototype.erosion_strain", "at which the target erodes, as strain_measure says"},
      {"scale", "prototype.depth", "thickness of the target"},
      {"scale", "prototype.width", "of the target, from the axis to the wall"},
      {"scale", "prototype.penetration", "response: how deep it went"},
      {"scale", "prototype.strain_rate", "response: rate of strain"},
      {"scale", "prototype.time", "response: how long it took"},
      {"scale", "model.scene", "a scene in place of the numbers; response may stand beside it"},
      {"scale", "model.particle", "its name"},
      {"scale", "model.target", "its name"},
      {"scale", "model.convention", "how mu is meant; the model's default is the prototype's"},
      {"scale", "model.strain_measure", "how erosion_strain is meant; the model's default is the prototype's"},
      {"scale", "model.radius", "of the particle"},
      {"scale", "model.particle_density", "of the particle"},
      {"scale", "model.particle_modulus", "the particle's Young's modulus"},
      {"scale", "model.speed", "at impact"},
      {"scale", "model.target_density", "of the target"},
      {"scale", "model.mu", "Ogden modulus, as convention says"},
      {"scale", "model.alpha", "Ogden exponent"},
      {"scale", "model.erosion_strain", "at which the target erodes, as strain_measure says"},
      {"scale", "model.depth", "thickness of the target"},
      {"scale", "model.width", "of the target, from the axis to the wall"},
      {"scale", "model.penetration", "response: how deep it went"},
      {"scale", "model.strain_rate", "response: rate of strain"},
      {"scale", "model.time", "response: how long it took"},
      {"scale", "output", "what is written"},
      {"scale", "output.scene", "the prototype's scene with the model's numbers is written to this file"},
  };
}

}  // namespace percal::tools
