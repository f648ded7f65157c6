// The result of `percal scale`: as JSON, and the page that says what that JSON holds.
#pragma once
#include <string>

#include "percal/page/page.hpp"
#include "percal/page/result.hpp"
#include "percal/scaling/scale_job.hpp"

namespace percal {

// Both systems, the ten groups, what followed, what stands in the way of similarity. `similar_scene`: the file that was written;
// empty: none.
page::Json scale_to_json(const ScaleJob& job, const Completion& completion, const std::string& similar_scene);

page::Page scale_page(const page::Json& result);

}  // namespace percal
