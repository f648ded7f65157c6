// Keys that people write for others: typing errors, and words for the same thing.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace percal {

// The known key that an unknown one was probably meant to be: "sped" and "velocity" for "speed".
std::optional<std::string> key_meant(const std::string& written, const std::vector<std::string>& known);

// The other way round: which of the written keys was probably meant to be `wanted`.
std::optional<std::string> meant_by(const std::string& wanted, const std::vector<std::string>& written);

}  // namespace percal
