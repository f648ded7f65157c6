#include "commands.hpp"

namespace percal::tools {
Exit run_fit(const FitArguments&, const Common&) { throw BadInput("percal fit is not built yet"); }
}  // namespace percal::tools
