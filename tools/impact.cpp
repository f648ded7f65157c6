#include "commands.hpp"

namespace percal::tools {
Exit run_impact(const ImpactArguments&, const Common&) { throw BadInput("percal impact is not built yet"); }
}  // namespace percal::tools
