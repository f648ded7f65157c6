#include "commands.hpp"

namespace percal::tools {
Exit run_identify(const IdentifyArguments&, const Common&) { throw BadInput("percal identify is not built yet"); }
}  // namespace percal::tools
