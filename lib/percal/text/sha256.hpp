// SHA-256 of bytes, as sha256sum prints it: 64 hexadecimal digits.
#pragma once
#include <optional>
#include <string>

namespace percal {

std::string sha256(const std::string& bytes);

// The same in base64, as security policies of pages have it.
std::string sha256_in_base64(const std::string& bytes);

// Of a file's bytes; nothing where it is no ordinary file (a pipe, standard input) or cannot be read.
std::optional<std::string> sha256_of_file(const std::string& path);

}  // namespace percal
