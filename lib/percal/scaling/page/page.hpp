// The page of `percal scale`: what its result.json says.
#pragma once
#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal {

page::Page scale_page(const page::Json& result);

}  // namespace percal
