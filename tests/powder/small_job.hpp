// A folder with a calibration of a gel by a smooth law, and jobs of powders for it.
#pragma once
#include "percal/base/version.hpp"
#include "percal/powder/job.hpp"
#include "predict/smooth_model.hpp"
#include "support/program.hpp"

namespace percal::test {

class PowderFolder : public Program {
 protected:
  void SetUp() override {
    const nlohmann::json result{
        {"schema", result_schema}, {"command", "calibrate"}, {"shot_model", shot_model_to_json(smooth_model())}};
    write("gel.json", result.dump());
  }
  // Steel balls like those of the calibration, of several sizes and speeds.
  static inline const std::string sizes =
      "[powder.radius]\nmedian = \"1.59 mm\"\ngeometric_deviation = 1.1\nweighting = \"number\"\n";
  static inline const std::string speeds = "[powder.speed]\nmedian = \"80 m/s\"\ngeometric_deviation = 1.05\n";
  // Deep enough for them: they go some 140 mm deep.
  static inline const std::string no_bounce = "bounce = \"none\"\nlayer_depth = \"200 mm\"\n";
  static std::string job(const std::string& powder, const std::string& head = no_bounce, const std::string& rest = "") {
    return "calibration = \"gel.json\"\n" + head + "[powder]\ndensity = \"7800 kg/m3\"\n" + powder + rest;
  }
  PowderJob read_job(const std::string& text) const {
    write("job.toml", text);
    return read_powder_job(path("job.toml"));
  }
};

}  // namespace percal::test
