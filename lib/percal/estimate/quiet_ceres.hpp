#pragma once

namespace percal {

// glog prints on standard error even where Ceres is silent: this stops it, once. A host that has set glog up itself keeps its
// settings. To be called before a ceres::Solve.
void quiet_ceres();

}  // namespace percal
