// The page of `percal fit`: what its result.json says.
#pragma once
#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal {

page::Page fit_page(const page::Json& result);

// Files and columns, before anything is fitted.
page::Page read_page(const page::Json& read);

}  // namespace percal
