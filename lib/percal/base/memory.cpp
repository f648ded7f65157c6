#include "percal/base/memory.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace percal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The number behind a word at the beginning of a line, as the kernel writes its tables; of "" the file's only number.
std::optional<double> kernel_number(const char* file, const std::string& word) {
  std::ifstream lines(file);
  std::string name;
  double value = 0;
  if (word.empty()) return lines >> value ? std::optional(value) : std::nullopt;
  for (std::string rest; lines >> name; std::getline(lines, rest))
    if (name == word && lines >> value) return value;
  return std::nullopt;
}

// Files that are kept in memory only as long as nobody wants it do not count.
double left_in_control_group() {
  const auto most = kernel_number("/sys/fs/cgroup/memory.max", ""),  // nothing of the word "max"
      taken = kernel_number("/sys/fs/cgroup/memory.current", ""),
             files = kernel_number("/sys/fs/cgroup/memory.stat", "inactive_file");
  if (!most || !taken) return infinity;
  return std::max(0.0, *most - *taken + files.value_or(0));
}

}  // namespace

double available_memory() {
  const auto kilobytes = kernel_number("/proc/meminfo", "MemAvailable:");
  return std::min(kilobytes ? 1024 * *kilobytes : infinity, left_in_control_group());
}

double memory_of_this_process() {
  std::ifstream file("/proc/self/statm");
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

MemoryRoom::Place::Place(MemoryRoom& room, double bytes) : room_(room), bytes_(bytes) {
  std::unique_lock lock(room_.mutex_);
  room_.left_.wait(lock, [&] { return room_.inside_ == 0 || room_.taken_ + bytes_ <= room_.bytes_; });
  ++room_.inside_;
  room_.taken_ += bytes_;
}

MemoryRoom::Place::~Place() {
  {
    const std::lock_guard lock(room_.mutex_);
    --room_.inside_;
    room_.taken_ -= bytes_;
  }
  room_.left_.notify_all();
}

}  // namespace percal
