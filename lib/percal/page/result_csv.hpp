// Rows of a result as a CSV file.
#pragma once
#include <string>
#include <vector>

#include "percal/page/result.hpp"

namespace percal::page {

// A column: its name, and where its cells stand in a row of the result, "error/low". Free text is quoted.
struct ResultColumn {
  std::string name, path;
  enum { word_or_number, free_text } form = word_or_number;
};
std::string as_csv(const std::vector<ResultColumn>& columns, const std::vector<Json>& rows);

}  // namespace percal::page
