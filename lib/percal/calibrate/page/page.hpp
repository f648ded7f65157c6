// The page of `percal calibrate`: what its result.json says.
#pragma once
#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal {

page::Page calibrate_page(const page::Json& result);

}  // namespace percal
