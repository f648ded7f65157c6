// The files of data/atlas that are part of the library, as cmake/PercalEmbed.cmake put them in.
#pragma once
#include <map>
#include <string>

namespace percal {

// Text by name.
const std::map<std::string, std::string>& embedded_atlases();

}  // namespace percal
