// What the ways of percal fit have in common: their cost, the head of their result, where it goes.
#pragma once
#include <chrono>
#include <ctime>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "commands.hpp"
#include "percal/fit/curve_problem.hpp"

namespace percal::tools {

struct Clock {
  std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
  std::clock_t cpu = std::clock();
  nlohmann::json cost() const;
};

// Standard output may be a file on a full disk.
void put(const std::string& text);

// Schema, version, command and input.
nlohmann::json fit_head(const FitArguments& arguments);

// The points of each test: its `name` and `deformation`, lists of `amount` (stretch; gamma in shear), `across` (of general
// biaxial points, else null), `stress_Pa` (nominal) and `error_Pa` (null where the file gives none).
nlohmann::json points_of_tests(const CurveData& data, const std::vector<CurveTest>& tests);

// The same of one curve, a list for each deformation in it; `name` is "low rate".
nlohmann::json points_of_curve(const std::string& name, const CurveData& data);

// JSON for people and programs; text of the user that is not UTF-8 shows as replacement characters.
std::string written(const nlohmann::json& result);

// result.json in the folder of --out, if there is one, and the result on standard output with --json.
void deliver(const nlohmann::json& result, const Common& common);

// The unit in which a modulus reads best.
struct PressureUnit {
  const char* symbol;
  double size;  // Pa
};
PressureUnit unit_for(double pressure);

}  // namespace percal::tools
