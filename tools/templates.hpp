// The templates of the files that percal reads: tools/templates, which is part of the program. They are what `percal new` writes and,
// with every comment taken off, sample documents that the readers are run over for the reference of the keys.
//
// A line that begins with "# " is a key or table that may be left out; one with "## " is a sentence. A note behind " #> "
// says when a key may not stand as it is: "instead of KEY", or "only ..." and what it takes. STEM stands for the name of
// the file without its ending: tables of data are written beside it. "#< FILE" stands for the lines of another file.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace percal::tools {

struct TextFile {
  std::string name;  // "STEM.toml", "STEM_shots.csv"
  std::string text;
};

// The files by their names in tools/templates: "scene.toml", "variants/scene_cone.toml".
const std::map<std::string, std::string>& embedded_templates();

// What a template shows: the keys that one needs, or every key. variants/KIND_all.toml has them where the template has not.
enum class Keys { needed, all };

// The document of a kind ("scene", "fit"), then the tables that it names.
std::vector<TextFile> template_of(const std::string& kind, Keys keys);

// The template with its comments taken off, but for keys whose note says "instead of" or "only".
std::string uncommented(const std::string& text);

// Documents that have every key of a kind between them: the template and variants/KIND_*.toml, which have other keys, shapes and ways
// to say a thing, each without its comments, and the same again for each key that stands "instead of" others.
std::vector<std::string> sample_documents(const std::string& kind);

// Every STEM in it replaced.
std::string with_stem(std::string text, const std::string& stem);

}  // namespace percal::tools
