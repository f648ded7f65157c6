// The page of `percal study`: what its result.json says.
#pragma once
#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal {

page::Page study_page(const page::Json& result);

}  // namespace percal
