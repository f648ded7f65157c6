// Which ladder a scene was studied with, kept in the store. The runs themselves are evaluations like all others: the same ladder
// over the same scene finds them there.
#pragma once
#include <optional>
#include <string>

#include "percal/study/ladder.hpp"

namespace percal {

// The evaluation's key without the mesh, the time step and the arithmetic: what decides the depth that meshes converge to.
std::string study_key(const Scene& scene);

// The newest one, or none. Throws IoFailure where the store holds something else under this key.
std::optional<LadderOptions> kept_ladder(const Store& store, const std::string& key);

// Kept as the newest, unless it already is.
void keep_ladder(Store& store, const std::string& key, const LadderOptions& options);

}  // namespace percal
