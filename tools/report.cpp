// percal report: a result as a page.
#include <stdexcept>

#include "commands.hpp"

namespace percal::tools {

Exit run_report(const ReportArguments&, const Common&) { throw std::logic_error("not written yet"); }

}  // namespace percal::tools
