// The audit of omissions as its result.json, its table as CSV, and its page.
#pragma once
#include "percal/study/omissions.hpp"
#include "percal/study/page/page.hpp"

namespace percal {

page::Json omissions_to_json(const Scene& scene, const Omissions& audit, const page::Cost& cost);

// A line for the scene as it is, then one an omission.
std::string omissions_csv(const page::Json& result);

page::Page omissions_page(const page::Json& result);

}  // namespace percal
