// A copy of a store that is not to be touched: of its file, and of what killed processes have left in the log beside it.
#pragma once
#include <filesystem>
#include <string>

#include "percal/base/ending.hpp"

namespace percal {

// In a temporary folder that is removed with the object. The process does not end on a signal before that.
class TakenCopy {
 public:
  // Throws IoFailure where there is no such file, no room for its copy, or where it changes while it is copied.
  explicit TakenCopy(const std::string& store);
  ~TakenCopy();
  TakenCopy(const TakenCopy&) = delete;
  TakenCopy& operator=(const TakenCopy&) = delete;

  std::string file() const { return (folder_ / "store").string(); }

 private:
  void take(const std::string& store) const;

  EndLater end_later_;
  std::filesystem::path folder_;
};

}  // namespace percal
