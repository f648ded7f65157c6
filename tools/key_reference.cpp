#include "key_reference.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "pages.hpp"
#include "percal/calibrate/job.hpp"
#include "percal/identify/job.hpp"
#include "percal/scaling/scale_job.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

namespace fs = std::filesystem;

// A folder of its own, removed at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "percal-keys-XXXXXX").string();
    if (error || !mkdtemp(name.data())) throw IoFailure("no folder for temporary files: set TMPDIR to one");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

KeyRecord keys_asked_for(const FileKind& kind, const Template& files, bool commented) {
  const ScratchFolder folder;
  for (const TextFile& file : files) {
    const std::string text = commented && &file == &files.front() ? uncommented(file.text) : file.text;
    write_file((folder.path() / with_stem(file.name, "sample")).string(), with_stem(text, "sample"));
  }
  const std::string document = (folder.path() / with_stem(files.front().name, "sample")).string();
  const KeyRecording recording;
  kind.read(document);
  return recording.of(document);
}

bool holds_for(const KeyMeaning& meaning, const std::string& kind) {
  std::istringstream words(meaning.kinds);
  for (std::string word; words >> word;)
    if (word == kind) return true;
  return false;
}

const KeyMeaning* meaning_of(const std::string& kind, const std::string& path) {
  const auto& all = key_meanings();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const KeyMeaning& m) { return m.path == path && holds_for(m, kind); });
  return found == all.end() ? nullptr : &*found;
}

std::string cell(std::string text) {
  for (auto at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, 1, '\\');
  return text;
}

// As a cell: values in code, words as they are.
std::string default_cell(const KeyEntry& key) {
  const char first = key.fallback.empty() ? ' ' : key.fallback.front();
  const bool value = first == '"' || first == '-' || (first >= '0' && first <= '9') || key.fallback == "true" ||
                     key.fallback == "false";
  return value ? "`" + key.fallback + "`" : key.fallback;
}

}  // namespace

const std::vector<FileKind>& file_kinds() {
  static const std::vector<FileKind> kinds{
      {"scene", "Scenes", "percal impact, percal study", scene_template, scene_variants,
       [](const std::string& path) { read_scene(path); }},
      {"scale", "Scaling jobs", "percal scale", scale_template, scale_variants,
       [](const std::string& path) { read_scale_job(path); }},
      {"identify", "Identifications", "percal identify", identify_template, identify_variants,
       [](const std::string& path) { read_identify_job(path); }},
      {"calibrate", "Calibrations", "percal calibrate", calibrate_template, calibrate_variants,
       [](const std::string& path) { read_calibration_job(path); }}};
  return kinds;
}

const FileKind& file_kind(const std::string& name) {
  for (const FileKind& kind : file_kinds())
    if (kind.name == name) return kind;
  throw BadInput({"", 0, "kind"}, in_quotes(name), "scene, scale, identify, calibrate");
}

std::vector<KeyEntry> keys_of(const FileKind& kind) {
  KeyRecord record = keys_asked_for(kind, kind.start(), true);
  for (const Template& variant : kind.variants()) record.merge(keys_asked_for(kind, variant, false));
  std::vector<KeyEntry> entries;
  for (const RecordedKey& key : record.keys()) {
    const KeyMeaning* meaning = meaning_of(kind.name, key.path);
    std::string fallback = key.required ? "required" : key.form.fallback.empty() ? "left out" : key.form.fallback;
    if (meaning && !meaning->fallback.empty()) fallback = meaning->fallback;
    entries.push_back(
        {key.path, key.form.kind, key.form.accepted, fallback, meaning ? meaning->meaning : "", key.required});
  }
  return entries;
}

std::vector<std::string> faults_of_meanings() {
  std::vector<std::string> faults;
  for (const FileKind& kind : file_kinds()) {
    const auto keys = keys_of(kind);
    for (const KeyEntry& key : keys)
      if (key.meaning.empty()) faults.push_back(fmt::format("{}: the key {} has no meaning", kind.name, key.path));
    for (const KeyMeaning& meaning : key_meanings())
      if (holds_for(meaning, kind.name) &&
          std::none_of(keys.begin(), keys.end(), [&](const KeyEntry& key) { return key.path == meaning.path; }))
        faults.push_back(fmt::format("{}: the meaning of {} has no key", kind.name, meaning.path));
  }
  return faults;
}

std::string as_markdown(const std::vector<FileKind>& kinds) {
  std::string text =
      "# Every key\n\n"
      "What the readers of percal's TOML files accept, printed by the program (`percal keys --markdown`) from what the "
      "readers "
      "say as they read.\nThe pages of each kind of file tell how the keys belong together: [scenes](scene.md), "
      "[identifications](identify.md), [calibrations](calibrate.md).\n\n"
      "`a.b` is the key b of the table `[a]`, `a[].b` that of every table `[[a]]`, and NAME a name that you give. "
      "A quantity with a dimension is a text with its\nunit. \"Left out\" means that the key has no default: leaving "
      "it "
      "out means something of its own.\n";
  for (const FileKind& kind : kinds) {
    text += fmt::format("\n## {}\n\nRead by `{}`; `percal new {}` writes a template.\n\n", kind.title, kind.command,
                        kind.name);
    text += "| key | kind | accepted | default | meaning |\n| --- | --- | --- | --- | --- |\n";
    for (const KeyEntry& key : keys_of(kind))
      text += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.path, key.kind, cell(key.accepted),
                          cell(default_cell(key)), cell(key.meaning));
  }
  return text;
}

std::string as_text(const FileKind& kind) {
  std::string text;
  for (const KeyEntry& key : keys_of(kind)) {
    text += fmt::format(
        "{}\n    {}{}; {}\n", key.path, key.kind, key.accepted.empty() ? "" : ": " + key.accepted,
        key.fallback == "required" || key.fallback == "left out" ? key.fallback : "default: " + key.fallback);
    if (!key.meaning.empty()) text += fmt::format("    {}\n", key.meaning);
  }
  return text;
}

nlohmann::json to_json(const FileKind& kind) {
  nlohmann::json keys = nlohmann::json::array();
  for (const KeyEntry& key : keys_of(kind))
    keys.push_back({{"key", key.path},
                    {"kind", key.kind},
                    {"accepted", key.accepted},
                    {"required", key.required},
                    {"default", key.fallback},
                    {"meaning", key.meaning}});
  return {{"command", "keys"}, {"file", kind.name}, {"keys", keys}};
}

}  // namespace percal::tools
