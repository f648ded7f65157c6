// The small job of tests/data/liver, to be run as it stands or with changes.
#pragma once
#include <stdexcept>
#include <utility>

#include "support/program.hpp"

namespace percal::acceptance {

// The job with pieces of its text replaced, and its tables beside it.
class LiverJob : public test::Program {
 protected:
  LiverJob() {
    for (const char* table : {"agar.csv", "shots.csv"})
      std::filesystem::copy_file(test::test_data + "liver/" + table, folder / table);
  }
  std::string job(const std::vector<std::pair<std::string, std::string>>& replacements = {}) const {
    std::string text = text_of(test::test_data + "liver/liver.toml");
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
