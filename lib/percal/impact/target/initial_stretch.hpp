// A target that is stretched in its plane before the impact, and in equilibrium.     docs/theory/target.md, Initial stretch
#pragma once
#include "percal/impact/target/block.hpp"
#include "percal/impact/target/constants.hpp"
#include "percal/impact/target/elastic_solid.hpp"

namespace percal {

// Of a layer stretched by `in_plane` in r and hoop (in plane strain in x alone), with the thickness that leaves its face free of stress.
// `lasting`: of the solid when all has relaxed.
InitialStretch initial_stretch(double in_plane, Geometry geometry, const ElasticSolid& lasting);

scalar::Gradient<double> gradient_of(const InitialStretch& initial);

// What elements remember of their last step, as the initial stretch has left it: J, measure of erosion, relaxed stress. Returns whether
// the measure is below its limit everywhere.
template <class Real>
bool take_initial_state(Block<Real>& block, const TargetSolid& solid);

}  // namespace percal
