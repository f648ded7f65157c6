// The program as its user runs it: in a folder of its own, with its streams and its exit code.
#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace percal::test {

inline const std::string guha2009 = PERCAL_DATA "/guha2009/";
inline const std::string test_data = PERCAL_DATA "/../tests/data/";
inline const std::string docs = PERCAL_DATA "/../docs/";

struct Ended {
  int code;  // -1: by a signal
  std::string out, err;
};

// The words of a command line: what stands between its blanks, or between double quotes.
inline std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words;
  std::istringstream stream(command);
  for (std::string word; stream >> std::quoted(word);) words.push_back(word);
  return words;
}

// For `in_child`: standard output goes to a disk without room.
inline void into_a_full_disk() {
  if (!freopen("/dev/full", "w", stdout)) _exit(126);
}

class ProgramFolder : public TemporaryFolder {
 public:
  std::string write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
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
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / below))
      names.insert(std::filesystem::relative(entry.path(), folder).string());
    names.erase("stdout");
    names.erase("stderr");
    return names;
  }

  // A process of its own, in this folder; `in_child` runs there before the program does.
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
};

// A folder for each test.
class Program : public testing::Test, protected ProgramFolder {};

}  // namespace percal::test
