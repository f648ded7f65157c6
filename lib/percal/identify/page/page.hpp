// The page of `percal identify`: what its result.json says.
#pragma once
#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal {

page::Page identify_page(const page::Json& result);

}  // namespace percal
