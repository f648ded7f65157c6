// result.json of an identification: docs/formats/identify.md.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "percal/identify/identification.hpp"

namespace percal {

struct IdentifyCost {
  long runs = 0, reused = 0;
  double wall_seconds = 0, cpu_seconds = 0;
  std::string instruction_level;
};

nlohmann::json identification_to_json(const IdentifyJob& job, const Identification& found, const IdentifyCost& cost);

}  // namespace percal
