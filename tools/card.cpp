#include "commands.hpp"

namespace percal::tools {
Exit run_card_write(const CardArguments&, const Common&) { throw BadInput("percal card is not built yet"); }
}  // namespace percal::tools
