// The keys of every kind of file that percal reads, as its readers say them, with what they mean.
#pragma once
#include <string>
#include <vector>

#include "percal/text/key_record.hpp"
#include "templates.hpp"

namespace percal::tools {

// A kind of file: "scene", "scale", "identify", "calibrate", "campaign", "dose".
struct FileKind {
  std::string name;
  std::string title;                      // "Scene"
  std::string command;                    // that reads it
  void (*read)(const std::string& path);  // throws BadInput
};
const std::vector<FileKind>& file_kinds();
// By its name or that of a command that reads it: "scene", "impact"; "job" is a calibration. Throws BadInput.
const FileKind& file_kind(const std::string& name);

// A key as the reference has it. `fallback` is the default in words: "required", "left out", or a value.
struct KeyEntry {
  std::string path, kind, accepted, fallback, meaning;
  bool required = false;
};

// Runs the kind's readers over its sample documents, written to a folder of the system's for temporary files, and merges what they
// asked for. Throws IoFailure where there is no such folder.
std::vector<KeyEntry> keys_of(const FileKind& kind);

// Keys without a meaning, and meanings without a key: empty where all is well.
std::vector<std::string> faults_of_meanings();

}  // namespace percal::tools
