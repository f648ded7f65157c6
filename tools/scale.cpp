#include "commands.hpp"

namespace percal::tools {
Exit run_scale(const ScaleArguments&, const Common&) { throw BadInput("percal scale is not built yet"); }
}  // namespace percal::tools
