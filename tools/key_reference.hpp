// The keys of every kind of file that percal reads, as its readers say them, with what they mean.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "percal/text/key_record.hpp"
#include "templates.hpp"

namespace percal::tools {

// A kind of file: "scene", "scale", "identify", "calibrate".
struct FileKind {
  std::string name;
  std::string title;    // "Scene"
  std::string command;  // that reads it
  Template (*start)();
  std::vector<Template> (*variants)();
  void (*read)(const std::string& path);  // throws BadInput
};
const std::vector<FileKind>& file_kinds();
const FileKind& file_kind(const std::string& name);  // throws BadInput

// A key as the reference has it. `fallback` is the default in words: "required", "left out", or a value.
struct KeyEntry {
  std::string path, kind, accepted, fallback, meaning;
  bool required = false;
};

// Runs the kind's readers over its template and variants, written to a folder of the system's for temporary files, and merges
// what they asked for. Throws IoFailure where there is no such folder.
std::vector<KeyEntry> keys_of(const FileKind& kind);

// One sentence for each key. `fallback`, where it is not empty, says the default better than the reader can.
struct KeyMeaning {
  std::string kinds;  // file kinds that it holds for, with a blank between them
  std::string path;   // as in RecordedKey
  std::string meaning;
  std::string fallback = {};
};
const std::vector<KeyMeaning>& key_meanings();
std::vector<KeyMeaning> scene_meanings(), scale_meanings(), identify_meanings(), calibrate_meanings();  // parts of it

// Keys without a meaning, and meanings without a key: empty where all is well.
std::vector<std::string> faults_of_meanings();

std::string as_markdown(const std::vector<FileKind>& kinds);
std::string as_text(const FileKind& kind);
nlohmann::json to_json(const FileKind& kind);

}  // namespace percal::tools
