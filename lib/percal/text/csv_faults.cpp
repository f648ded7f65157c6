#include "percal/text/csv_faults.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "percal/base/error.hpp"

namespace percal {
namespace {

constexpr std::size_t told_in_full = 50;

// "60-75, 80" of ascending numbers.
std::string ranges(const std::vector<int>& lines) {
  std::string text;
  for (std::size_t first = 0; first < lines.size();) {
    std::size_t last = first;
    while (last + 1 < lines.size() && lines[last + 1] <= lines[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", lines[first]);
    if (lines[last] != lines[first]) text += fmt::format("-{}", lines[last]);
    first = last + 1;
  }
  return text;
}

}  // namespace

void LineFaults::add(int line, const std::string& what) { faults_.push_back({line, what}); }

std::string LineFaults::message() const {
  auto sorted = faults_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Fault& a, const Fault& b) { return a.line < b.line; });
  std::string text;
  std::vector<int> rest;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i >= told_in_full) {
      rest.push_back(sorted[i].line);
      continue;
    }
    text += fmt::format("{}{}:{}: {}", text.empty() ? "" : "\n", file_, sorted[i].line, sorted[i].what);
  }
  if (!rest.empty()) text += fmt::format("\n{}: also lines {}", file_, ranges(rest));
  return text;
}

void LineFaults::throw_if_any() const {
  if (!faults_.empty()) throw BadInput(message());
}

}  // namespace percal
