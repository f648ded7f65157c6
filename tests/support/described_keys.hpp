// A page of docs/formats against the reader of its jobs: the keys that stand on it, and those that the reader takes.
#pragma once
#include <gmock/gmock.h>

#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "percal/base/error.hpp"

namespace percal::test {

using Keys = std::map<std::string, std::set<std::string>>;  // by the heading of their block, "[gelatin]" or "Top level"

// The keys in the tables of a page, above its part on results.
inline Keys described_keys(const std::string& page) {
  Keys keys;
  std::istringstream lines(page);
  std::string heading;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# Results")) break;
    if (line.starts_with("## ")) heading = line.substr(3);
    if (line.starts_with("| `")) keys[heading].insert(line.substr(3, line.find('`', 3) - 3));
  }
  return keys;
}

using ReadJob = std::function<void(const std::string& text)>;

// The keys that the reader lists as accepted where it finds one that it does not know below this line of a job.
inline std::set<std::string> accepted_keys(const ReadJob& read, std::string text, std::size_t end_of_header) {
  text.insert(end_of_header, "\nzzzzzzzz = 1");
  std::set<std::string> keys;
  try {
    read(text);
  } catch (const BadInput& error) {
    const std::string message = error.what(), before = "accepted: ";
    EXPECT_THAT(message, testing::HasSubstr("zzzzzzzz"));
    std::istringstream words(message.substr(message.find(before) + before.size()));
    for (std::string word; std::getline(words >> std::ws, word, ',');) keys.insert(word);
  }
  return keys;
}

// Those of every block of a job, added under the block's header, or under what `heading_of` makes of it.
inline void collect_accepted_keys(
    const ReadJob& read, const std::string& text, Keys& keys,
    const std::function<std::string(const std::string&)>& heading_of = [](const std::string& header) {
      return header;
    }) {
  keys["Top level"].merge(accepted_keys(read, "\n" + text, 0));
  for (std::size_t at = text.find("\n["); at != std::string::npos; at = text.find("\n[", at + 1)) {
    const std::size_t end = text.find_first_of(" \n", at + 1);
    keys[heading_of(text.substr(at + 1, end - at - 1))].merge(accepted_keys(read, text, text.find('\n', at + 1)));
  }
}

}  // namespace percal::test
