// Plans whose runs take some milliseconds.
#pragma once
#include <string>
#include <vector>

#include "percal/sweep/scene_at.hpp"
#include "support/program.hpp"

namespace percal::test {

// A steel ball into gelatin on a coarse mesh.
inline const std::string small_scene =
    "[particle]\ndiameter = \"4.5 mm\"\ndensity = \"7800 kg/m3\"\nspeed = \"180 m/s\"\n"
    "[target]\ndensity = \"1010 kg/m3\"\nmu = \"346 kPa\"\nalpha = 8.65\ndepth = \"40 mm\"\n"
    "[target.erosion]\nstrain = 1.0\n"
    "[mesh]\nelements_per_radius = 3\n";

inline std::string ranged(const std::string& key, const std::string& from, const std::string& to,
                          const std::string& rest = "") {
  return "[[sweep]]\nkey = \"" + key + "\"\nfrom = " + from + "\nto = " + to + "\n" + rest;
}
inline std::string listed_sweep(const std::string& key, const std::string& values, const std::string& rest = "") {
  return "[[sweep]]\nkey = \"" + key + "\"\nvalues = " + values + "\n" + rest;
}

// A folder with scene.toml, for plans beside it.
class PlanFolder : public Program {
 protected:
  PlanFolder() { write("scene.toml", small_scene); }

  std::string plan_file(const std::string& sweeps, const std::string& head = "replicates = 1\n") const {
    return write("plan.toml", "scene = \"scene.toml\"\n" + head + sweeps);
  }
  Plan plan(const std::string& sweeps, const std::string& head = "replicates = 1\n") const {
    return read_plan(plan_file(sweeps, head));
  }
  // What the plan's points are refused with; empty where they are not.
  std::string refusal(const std::string& sweeps, const std::string& head = "replicates = 1\n") const {
    try {
      points_to_run(plan(sweeps, head));
    } catch (const BadInput& error) {
      return error.what();
    }
    return "";
  }
  static std::vector<double> numbers(const Plan& plan, std::size_t axis) {
    std::vector<double> found;
    for (const PlanPoint& point : plan.points) found.push_back(point.values[axis].number);
    return found;
  }
};

}  // namespace percal::test
