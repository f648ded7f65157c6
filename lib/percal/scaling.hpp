// scaling: similar systems.
//
// The ten dimensionless groups of an impact; a model system completed so that its groups agree with a prototype's;
// numbers carried from one to the other; the similar scene; depth against impact parameter; the job of percal scale.
//
//     const percal::Completion done = percal::complete(prototype, model);
//     const double mu = percal::map_modulus(*prototype.mu, prototype, done.model);  // Pa
//
// See docs/theory/scaling.md.
#pragma once
#include "percal/scaling/groups.hpp"
#include "percal/scaling/scale_job.hpp"
#include "percal/scaling/similar.hpp"
#include "percal/scaling/similar_scene.hpp"
#include "percal/scaling/system.hpp"
#include "percal/scaling/system_toml.hpp"
#include "percal/scaling/trend.hpp"
