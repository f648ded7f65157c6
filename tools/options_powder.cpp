// The options of percal dose and percal design.
#include "options.hpp"

namespace percal::tools {

void add_dose(CLI::App& app, PowderArguments& dose, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand(
      "dose", "a powder by a finished calibration -> dose over depth, shares by layer, what bounces and what passes");
  command->add_option("job", dose.job, "TOML job")->required();
  command->footer("Example: percal dose powder.toml");
  add_common(*command, common, false);
  commands.push_back({command, [&] { return run_dose(dose, common); }});
}

void add_design(CLI::App& app, PowderArguments& design, Common& common, std::vector<Command>& commands) {
  auto* command = app.add_subcommand(
      "design", "which particle and speed put most of a powder between two depths, by a finished calibration");
  command->add_option("job", design.job, "TOML job, that of percal dose with [band] and [design]")->required();
  command->footer("Example: percal design powder.toml");
  add_common(*command, common, false);
  commands.push_back({command, [&] { return run_design(design, common); }});
}

}  // namespace percal::tools
