// percal study: what a scene's settings are worth, and what the solver survives. A file for each kind of study.
#include "percal/base/error.hpp"
#include "studies.hpp"

namespace percal::tools {

Exit run_study(const StudyArguments& arguments, const Common& common) {
  if (arguments.extremes) return study_extremes(arguments, common);
  if (arguments.scene.empty())
    throw BadInput(Place{.file = "", .line = 0, .key = "scene"}, "none",
                   "a TOML scene: percal study SCENE --error-vs-time, or --omissions; --extremes takes none");
  return arguments.omissions ? study_omissions(arguments, common) : study_error_vs_time(arguments, common);
}

}  // namespace percal::tools
