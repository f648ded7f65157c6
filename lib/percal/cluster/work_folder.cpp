#include "percal/cluster/work_folder.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "percal/base/error.hpp"
#include "percal/text/file.hpp"
#include "percal/text/sha256.hpp"

namespace percal {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::optional<KeyedEvaluation> result_in(const std::string& text) {
  const json result = json::parse(text, nullptr, false);
  if (!result.is_object()) return std::nullopt;
  for (const char* name : {"key", "outcome", "payload"})
    if (!result.contains(name) || !result[name].is_string()) return std::nullopt;
  if (!result.contains("cpu_s") || !result["cpu_s"].is_number()) return std::nullopt;
  return KeyedEvaluation{result["key"], {result["outcome"], result["payload"], result["cpu_s"]}};
}

}  // namespace

WorkFolder::WorkFolder(std::string path) : path_(fs::absolute(path).lexically_normal().string()) {
  if (path_.ends_with('/')) path_.pop_back();
  for (const char* part : {"todo", "done", "log"}) ensure_writable_folder(path_ + "/" + part);
}

std::string WorkFolder::list_file(const std::string& array, int task) const {
  return path_ + "/todo/" + array + "/" + std::to_string(task);
}

void WorkFolder::write_list(const std::string& array, int task, const std::vector<std::string>& keys) const {
  std::string text;
  for (const std::string& key : keys) text += key + "\n";
  write_file(list_file(array, task), text);
}

std::vector<std::string> WorkFolder::list(const std::string& array, int task) const {
  const std::string file = list_file(array, task);
  std::error_code no_matter;
  return fs::is_regular_file(file, no_matter) ? keys_of(read_output(file)) : std::vector<std::string>{};
}

std::string WorkFolder::result_file(const std::string& key) const {
  const std::string digest = sha256(key);
  return path_ + "/done/" + digest.substr(0, 2) + "/" + digest + ".json";
}

bool WorkFolder::has_result(const std::string& key) const {
  std::error_code no_matter;
  return fs::is_regular_file(result_file(key), no_matter);
}

void WorkFolder::put_result(const KeyedEvaluation& evaluation) const {
  write_file(result_file(evaluation.key), json{{"key", evaluation.key},
                                               {"outcome", evaluation.evaluation.outcome},
                                               {"payload", evaluation.evaluation.payload},
                                               {"cpu_s", evaluation.evaluation.cpu_seconds}}
                                              .dump());
}

void WorkFolder::remove_result(const std::string& key) const {
  std::error_code no_matter;
  fs::remove(result_file(key), no_matter);
}

std::vector<KeyedEvaluation> WorkFolder::results() const {
  std::vector<KeyedEvaluation> found;
  std::error_code error;
  for (fs::recursive_directory_iterator file(path_ + "/done", error), end; !error && file != end;
       file.increment(error)) {
    if (file->path().extension() != ".json") continue;
    if (auto result = result_in(read_output(file->path().string()))) found.push_back(std::move(*result));
  }
  return found;
}

std::string work_folder_of(const std::string& list_file) {
  const fs::path path = fs::absolute(list_file).lexically_normal();
  const fs::path todo = path.parent_path().parent_path();
  if (todo.filename() != "todo" || !fs::is_regular_file(path))
    throw BadInput({.file = list_file, .line = 0, .key = ""}, "not a list of evaluations",
                   "a file FOLDER/todo/ARRAY/TASK that percal wrote for a task of a cluster");
  return todo.parent_path().string();
}

std::vector<std::string> keys_of(const std::string& list) {
  std::vector<std::string> keys;
  std::istringstream lines(list);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) keys.push_back(line);
  return keys;
}

}  // namespace percal
