#include "key_reference.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "percal/base/error.hpp"
#include "percal/calibrate/job.hpp"
#include "percal/identify/job.hpp"
#include "percal/powder/job.hpp"
#include "percal/scaling/scale_job.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/sweep/plan.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

namespace fs = std::filesystem;

// One sentence for each key. `fallback`, where it is not empty, says the default better than the reader can.
struct KeyMeaning {
  std::string kinds;  // file kinds that it holds for, with a blank between them
  std::string path;   // as in RecordedKey
  std::string meaning;
  std::string fallback;
};

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

// What the kind's readers ask for in one of its documents, which finds the tables of the template, and a scene, in its folder.
KeyRecord keys_asked_for(const FileKind& kind, const std::string& document) {
  const ScratchFolder folder;
  const auto write = [&](const std::string& name, const std::string& text) {
    const std::string path = (folder.path() / with_stem(name, "sample")).string();
    if (!(std::ofstream(path) << with_stem(text, "sample")))  // a scratch file need not outlive a power cut
      throw IoFailure(path + ": cannot be written");
    return path;
  };
  for (const TextFile& file : template_of(kind.name, Keys::all)) write(file.name, file.text);
  write("scene.toml", uncommented(template_of("scene", Keys::all).front().text));
  const std::string path = write("STEM.toml", document);
  const KeyRecording recording;
  kind.read(path);
  return recording.of(path);
}

// key_meanings.txt: "KINDS | KEY | MEANING" or "KINDS | KEY | MEANING | DEFAULT".
std::vector<KeyMeaning> read_meanings(const std::string& text) {
  std::vector<KeyMeaning> meanings;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    for (std::size_t start = 0; start != std::string::npos;) {
      const auto bar = line.find(" | ", start);
      cells.push_back(line.substr(start, bar == std::string::npos ? bar : bar - start));
      start = bar == std::string::npos ? bar : bar + 3;
    }
    cells.resize(4);
    meanings.push_back({cells[0], cells[1], cells[2], cells[3]});
  }
  return meanings;
}

const std::vector<KeyMeaning>& key_meanings() {
  static const std::vector<KeyMeaning> all = read_meanings(embedded_templates().at("key_meanings.txt"));
  return all;
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

}  // namespace

const std::vector<FileKind>& file_kinds() {
  static const std::vector<FileKind> kinds{
      {"scene", "Scenes", "percal impact, percal study", [](const std::string& path) { read_scene(path); }},
      {"scale", "Scaling jobs", "percal scale", [](const std::string& path) { read_scale_job(path); }},
      {"identify", "Identifications", "percal identify", [](const std::string& path) { read_identify_job(path); }},
      {"calibrate", "Calibrations", "percal calibrate", [](const std::string& path) { read_calibration_job(path); }},
      {"campaign", "Campaigns", "percal campaign", [](const std::string& path) { read_plan(path); }},
      {"dose", "Powders", "percal dose, percal design", [](const std::string& path) { read_powder_job(path); }}};
  return kinds;
}

const FileKind& file_kind(const std::string& name) {
  static const std::map<std::string, std::string> by_command{
      {"impact", "scene"}, {"study", "scene"}, {"job", "calibrate"}, {"design", "dose"}};
  const auto other = by_command.find(name);
  for (const FileKind& kind : file_kinds())
    if (kind.name == (other == by_command.end() ? name : other->second)) return kind;
  throw BadInput({"", 0, "kind"}, in_quotes(name), "scene, scale, identify, calibrate, campaign, dose");
}

std::vector<KeyEntry> keys_of(const FileKind& kind) {
  KeyRecord record;
  for (const std::string& document : sample_documents(kind.name)) record.merge(keys_asked_for(kind, document));
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

}  // namespace percal::tools
