#include "percal/base/version.hpp"

namespace percal {
std::string version() { return PERCAL_VERSION; }
}  // namespace percal
