// Which of percal's documents a TOML file is, by the tables at its root: a job that is given to another command is called what it is.
#pragma once
#include <optional>
#include <string>

#include "percal/text/toml.hpp"

namespace percal {

enum class DocumentKind { scene, scale, identify, calibrate, campaign, powder };

// Throws BadInput where the document has nothing of the wanted kind, but what tells another one.
void need_kind(const TomlTable& root, DocumentKind wanted);

// "a job of percal calibrate"; nothing where the text is none of these documents.
std::optional<std::string> document_in_words(const std::string& text);

}  // namespace percal
