// percal new: a commented template.
#include <stdexcept>

#include "commands.hpp"

namespace percal::tools {

Exit run_new(const NewArguments&, const Common&) { throw std::logic_error("not written yet"); }

}  // namespace percal::tools
