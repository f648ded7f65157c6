// The program as its user runs it: in a folder of its own, with its streams and its exit code.
#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace percal::acceptance {

namespace fs = std::filesystem;

inline const std::string guha2009 = PERCAL_DATA "/guha2009/";
inline const std::string test_data = PERCAL_DATA "/../tests/data/";

struct Ended {
  int code;  // -1: by a signal
  std::string out, err;
};

class Program : public testing::Test {
 protected:
  Program() {
    std::string name = (fs::temp_directory_path() / "percal-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder = name;
  }
  ~Program() override { fs::remove_all(folder); }

  std::string path(const std::string& name) const { return (folder / name).string(); }
  std::string write(const std::string& name, const std::string& content) const {
    fs::create_directories(fs::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }
  static std::string text_of(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }
  std::string read(const std::string& name) const { return text_of(path(name)); }
  nlohmann::json result(const std::string& name) const { return nlohmann::json::parse(read(name)); }

  // Everything below a folder, for "nothing was written". The streams of the program itself are not part of it.
  std::set<std::string> files(const std::string& below = "") const {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder / below))
      names.insert(fs::relative(entry.path(), folder).string());
    names.erase("stdout");
    names.erase("stderr");
    return names;
  }

  // A process of its own, in the test's folder; `in_child` runs there before the program does.
  pid_t start(const std::vector<std::string>& arguments, const std::function<void()>& in_child = {}) const {
    std::vector<char*> words{const_cast<char*>(PERCAL_PROGRAM)};
    for (const auto& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    if (chdir(folder.c_str()) != 0 || !freopen("stdout", "w", stdout) || !freopen("stderr", "w", stderr)) _exit(126);
    setenv("XDG_CACHE_HOME", path("cache").c_str(), 1);  // never the user's own store
    if (in_child) in_child();
    execv(words[0], words.data());
    _exit(127);
  }
  Ended wait_for(pid_t child) const {
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("stdout"), read("stderr")};
  }
  Ended run(const std::vector<std::string>& arguments, const std::function<void()>& in_child = {}) const {
    return wait_for(start(arguments, in_child));
  }

  fs::path folder;
};

// The small job of tests/data/liver with pieces of its text replaced, and its tables beside it.
class LiverJob : public Program {
 protected:
  LiverJob() {
    for (const char* table : {"agar.csv", "shots.csv"}) fs::copy_file(test_data + "liver/" + table, folder / table);
  }
  std::string job(const std::vector<std::pair<std::string, std::string>>& replacements = {}) const {
    std::string text = text_of(test_data + "liver/liver.toml");
    for (const auto& [from, to] : replacements) {
      const auto at = text.find(from);
      if (at == std::string::npos) throw std::runtime_error("the job has no text \"" + from + "\"");
      text.replace(at, from.size(), to);
    }
    return write("liver.toml", text);
  }
};

// A result without what depends on the run and not on the problem.
inline nlohmann::json without_cost(nlohmann::json result) {
  result.erase("cost");
  return result;
}

}  // namespace percal::acceptance
