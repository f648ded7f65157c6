// A system as a table of a job: every number with its unit, all of them optional.
#pragma once
#include <string>

#include "percal/material/conventions.hpp"
#include "percal/scaling/system.hpp"
#include "percal/text/toml.hpp"

namespace percal {

// A system, and the conventions that its file spoke in. System holds the true modulus and engineering strain.
struct SystemInput {
  System system;
  ModulusConvention convention = ModulusConvention::true_shear;
  StrainMeasure measure = StrainMeasure::engineering;
};

// Keys: particle, target (names); convention ("true", "mu/alpha"), strain_measure ("engineering", "true",
// "green-lagrange"); and the keys of system_quantities(). Where the table does not say them, conventions, and the alpha
// that a modulus of convention "mu/alpha" needs, are `otherwise`'s. Throws BadInput as TomlTable does; does not
// finish().
SystemInput read_system(const TomlTable& table, const SystemInput& otherwise);

// Only the keys that describe a response: penetration, strain_rate, time.
void read_response(const TomlTable& table, System& system);

}  // namespace percal
