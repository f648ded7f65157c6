// The bad lines of one file, named together in one message.
#pragma once
#include <string>
#include <vector>

namespace percal {

// Collects faults line by line; throw_if_any() makes one BadInput of them. The first 50 are told in full, of the rest
// only the line numbers.
class LineFaults {
 public:
  explicit LineFaults(std::string file) : file_(std::move(file)) {}
  void add(int line, const std::string& what);
  bool empty() const { return faults_.empty(); }
  std::string message() const;
  void throw_if_any() const;

 private:
  struct Fault {
    int line;
    std::string what;
  };
  std::string file_;
  std::vector<Fault> faults_;
};

}  // namespace percal
