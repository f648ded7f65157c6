// A TOML document read with some of its values replaced, as if the file said so: what reads it is the reader of the file.
#pragma once
#include <string>
#include <vector>

#include "percal/text/toml.hpp"

namespace percal {

// Keys as messages name them: "particle.speed", "below[2].mu" (of the second [[below]]).
struct TomlEdit {
  std::string path;
  TomlScalar value;
};

// The document's root. Tables on the way to a value are made where they are missing, elements of arrays are not. Throws BadInput as
// parse_toml() does, and with the path for one that leads to no value.
TomlTable parse_toml_with(const std::string& text, const std::string& name, const std::vector<TomlEdit>& edits);

}  // namespace percal
