// What a terminal is given. Colours: none in a pipe or a file, none where NO_COLOR is set or TERM is "dumb" or missing.
#pragma once
#include <cstdio>
#include <string>

namespace percal::tools {

// Whether texts for this stream may have colours. NO_COLOR: https://no-color.org, set to anything but nothing.
bool has_colour(std::FILE* stream);

// The text with the colour where the stream may have it, else as it is. For standard output unless said otherwise.
std::string red(const std::string& text, std::FILE* stream = stdout);  // errors

// Prints a text with names in it that come from a file or a command line: control characters as \xNN. Throws std::system_error
// where the stream cannot be written.
void print(const std::string& text, std::FILE* stream = stdout);

}  // namespace percal::tools
