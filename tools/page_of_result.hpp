// The pages of all commands: the one place that sees them, for the program and for the Python module.
#pragma once
#include <string>

#include "percal/page/page.hpp"
#include "percal/page/result.hpp"

namespace percal::tools {

// The file, or result.json of the folder.
std::string result_file(const std::string& path);

// Throws BadInput where it is no result, or one of another schema.
void check_result(const page::Json& result, const std::string& file);

// The page of a result.json of any command that writes one. Throws BadInput with `file` where it is none, where its schema is
// another, or where a key is missing.
page::Page page_of_result(const page::Json& result, const std::string& file);

}  // namespace percal::tools
