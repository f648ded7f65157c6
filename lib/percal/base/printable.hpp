// What a terminal shows: text as it stands, since names come from files, and files from anybody; and how wide it is.
#pragma once
#include <string>
#include <string_view>

namespace percal {

// The text with control characters (of both blocks, but line ends and tabs) and broken UTF-8 as \xNN, so that nothing in it moves the
// cursor, colours or renames a terminal.
std::string printable(std::string_view text);

// Adds the character of `text` that begins at `at` to `shown`, as \xNN where it is a control character or broken, and returns its
// bytes.
std::size_t add_printable(std::string_view text, std::size_t at, std::string& shown);

// Columns of the terminal that a descriptor is; 0 where it is none.
int terminal_columns(int descriptor);

}  // namespace percal
