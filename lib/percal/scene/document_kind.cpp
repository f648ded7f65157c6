#include "percal/scene/document_kind.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace percal {
namespace {

struct Kind {
  const char* words;
  const char* accepted;
  std::vector<std::string> tables;  // that no other kind has
};

// In the order of DocumentKind.
const std::array<Kind, 6>& kinds() {
  static const std::array<Kind, 6> all{{
      {"a scene, for percal impact and percal study", "a scene: [particle] and [target]", {"particle", "target"}},
      {"a job of percal scale", "a job of percal scale: [prototype] and [model]", {"prototype"}},
      {"a job of percal identify",
       "a job of percal identify: [gelatin], [tissue], [calibration], [model], [alpha] and [ridge]",
       {"gelatin", "tissue", "calibration", "ridge"}},
      {"a job of percal calibrate",
       "a job of percal calibrate: [parameters.NAME], [materials.NAME], [[shots]] and [[curves]]",
       {"parameters", "materials", "shots", "curves", "hypotheses"}},
      {"a plan of percal campaign", "a plan of percal campaign: scene and [[sweep]]", {"sweep"}},
      {"a job of percal dose and percal design",
       "a job of percal dose and percal design: calibration and [powder]",
       {"powder"}},
  }};
  return all;
}

// The table of this kind that the document has.
std::optional<std::string> telling(const TomlTable& root, const Kind& kind) {
  const auto found = std::ranges::find_if(
      kind.tables, [&](const std::string& key) { return root.is_table(key) || root.is_array(key); });
  return found == kind.tables.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

void need_kind(const TomlTable& root, DocumentKind wanted) {
  const Kind& own = kinds()[static_cast<std::size_t>(wanted)];
  if (telling(root, own)) return;
  for (const Kind& kind : kinds())
    if (const auto key = telling(root, kind)) root.refuse(*key, kind.words, own.accepted);
}

std::optional<std::string> document_in_words(const std::string& text) {
  try {
    const TomlTable root = parse_toml(text, "");
    for (const Kind& kind : kinds())
      if (telling(root, kind)) return kind.words;
  } catch (const BadInput&) {
  }
  return std::nullopt;
}

}  // namespace percal
