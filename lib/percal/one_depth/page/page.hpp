// The result of percal invert, as JSON and as a page.                                          docs/formats/invert.md
#pragma once
#include "percal/one_depth/one_depth.hpp"
#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal {

page::Json one_depth_to_json(const OneDepth& found);

page::Page invert_page(const page::Json& result);

}  // namespace percal
