// material: hyperelastic solids and their conventions.
//
// Ogden solids in homogeneous deformations, their stability, what other programs mean by mu, and the law of gelatin.
// Inside percal mu is the true small-strain shear modulus.
//
//     const percal::Hyperelastic gel{{{.mu = 50e3, .alpha = 3}}};
//     const double stress = percal::nominal_stress(gel, percal::Strained{percal::Deformation::uniaxial, 1.5});  // Pa
//
// See docs/theory/curves.md, docs/theory/conventions.md.
#pragma once
#include "percal/material/conventions.hpp"
#include "percal/material/gelatin.hpp"
#include "percal/material/homogeneous.hpp"
#include "percal/material/hyperelastic.hpp"
#include "percal/material/isochoric.hpp"
#include "percal/material/ogden.hpp"
#include "percal/material/plausible.hpp"
#include "percal/material/prony.hpp"
#include "percal/material/stability.hpp"
