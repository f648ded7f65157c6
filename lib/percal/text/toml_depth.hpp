// Keeps TOML documents from nesting deeper than the stack holds.
#pragma once
#include <string>
#include <string_view>

namespace percal {

// Each dot of a key nests one table in another, and tables are destroyed recursively: throws BadInput for a line with too many.
void refuse_deep_keys(std::string_view text, const std::string& file);

}  // namespace percal
