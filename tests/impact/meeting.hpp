// A contact zone without a sweep: every column is looked at where it stands.
#pragma once
#include "percal/impact/march/contact_zone.hpp"

namespace percal {

// All nodes, kicked last over `kick`, have moved over `drift`.
template <class Real, class ParticleRun>
void meet(ContactZone<Real, ParticleRun>& zone, const GradedMesh& mesh, double kick, double drift) {
  zone.open_far(mesh.rows, drift);
  for (int i = 0; i <= mesh.columns(); ++i) zone.look_far({}, i);
  zone.close_far(kick);
}

}  // namespace percal
