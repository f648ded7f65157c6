#include "percal/estimate/quiet_ceres.hpp"

#include <glog/logging.h>

#include <mutex>

namespace percal {

void quiet_ceres() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (google::IsGoogleLoggingInitialized()) return;
    google::InitGoogleLogging("percal");
    FLAGS_logtostderr = true;
    FLAGS_minloglevel = 3;
  });
}

}  // namespace percal
