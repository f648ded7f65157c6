// What every writer of tables asks of one.
#pragma once
#include <cstddef>

#include "percal/page/page.hpp"

namespace percal::page {

// A first row of empty cells is no header: names and values of any kind.
bool has_header(const Table& table);

// Set flush right: most cells that say something are numbers ("3.4 MPa", "-0.02", "+1 %"), and the others are a word or two. The
// first column, which names the rows, never is.
bool is_column_of_numbers(const Table& table, std::size_t column);

std::size_t columns_of(const Table& table);

}  // namespace percal::page
