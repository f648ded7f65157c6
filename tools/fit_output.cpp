#include "fit_output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
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

}  // namespace

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
