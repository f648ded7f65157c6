// percal card read, percal card check: what a card means.
#include <stdexcept>

#include "commands.hpp"

namespace percal::tools {

Exit run_card_read(const CardArguments&, const Common&) { throw std::logic_error("not written yet"); }
Exit run_card_check(const CardArguments&, const Common&) { throw std::logic_error("not written yet"); }

}  // namespace percal::tools
