// The audit of omissions as JSON, CSV and a page: docs/formats/study.md.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "percal/study/omissions.hpp"

namespace percal {

nlohmann::json omissions_to_json(const Omissions& audit);

// A line for the scene as it is, then one an omission.
std::string omissions_csv(const Omissions& audit);

// Tables and conclusions in Markdown, without a title.
std::string omissions_markdown(const Omissions& audit);

}  // namespace percal
