#include "fit_output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "percal/base/version.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

using nlohmann::json;

json input_of(const FitArguments& arguments) {
  return {{"files", arguments.files},
          {"mode", arguments.mode},
          {"model", arguments.model},
          {"residual", arguments.residual},
          {"weights", arguments.weights},
          {"loss", arguments.loss},
          {"unconstrained", arguments.unconstrained},
          {"compare", arguments.compare},
          {"stable", arguments.stable},
          {"x", arguments.x},
          {"y", arguments.y},
          {"error", arguments.error},
          {"where", arguments.where},
          {"intervals", arguments.intervals},
          {"level", arguments.level},
          {"bootstrap", arguments.bootstrap},
          {"rate_factor", arguments.rate_factor},
          {"rate_column", arguments.rate_column}};
}

json empty_list(const std::string& name, Deformation deformation) {
  return {{"name", name},
          {"deformation", word(deformation)},
          {"amount", json::array()},
          {"across", json::array()},
          {"stress_Pa", json::array()},
          {"error_Pa", json::array()}};
}

void add_point(json& list, const StressPoint& point) {
  const bool biaxial = point.strained.deformation == Deformation::biaxial;
  list["amount"].push_back(point.strained.amount);
  list["across"].push_back(biaxial ? json(point.strained.across) : json(nullptr));
  list["stress_Pa"].push_back(point.nominal_stress);
  list["error_Pa"].push_back(point.standard_error ? json(*point.standard_error) : json(nullptr));
}

}  // namespace

json points_of_tests(const CurveData& data, const std::vector<CurveTest>& tests) {
  json lists = json::array();
  for (const CurveTest& test : tests) {
    lists.push_back(empty_list(test.name, test.deformation));
    for (const StressPoint& point : data.points)
      if (belongs(point, data, test)) add_point(lists.back(), point);
  }
  return lists;
}

json points_of_curve(const std::string& name, const CurveData& data) {
  std::map<Deformation, json> of;
  for (const StressPoint& point : data.points) {
    const Deformation deformation = point.strained.deformation;
    add_point(of.try_emplace(deformation, empty_list(name, deformation)).first->second, point);
  }
  json lists = json::array();
  for (const auto& [deformation, list] : of) lists.push_back(list);
  return lists;
}

json Clock::cost() const {
  const std::chrono::duration<double> wall_s = std::chrono::steady_clock::now() - wall;
  return {{"wall_s", wall_s.count()}, {"cpu_s", static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC}};
}

void put(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw IoFailure(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

json fit_head(const FitArguments& arguments) {
  return {{"schema", result_schema}, {"version", version()}, {"command", "fit"}, {"input", input_of(arguments)}};
}

std::string written(const json& result) { return result.dump(2, ' ', false, json::error_handler_t::replace) + "\n"; }

void deliver(const json& result, const Common& common) {
  if (!common.out.empty()) write_file((std::filesystem::path(common.out) / "result.json").string(), written(result));
  if (common.json) put(written(result));
}

PressureUnit unit_for(double pressure) {
  if (pressure >= 1e9) return {"GPa", 1e9};
  if (pressure >= 1e6) return {"MPa", 1e6};
  if (pressure >= 1e3) return {"kPa", 1e3};
  return {"Pa", 1};
}

}  // namespace percal::tools
