// A table of numbers beside somebody else's: the steps of the chain, and published tables recomputed.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace percal {

// Numbers are in `unit`. `error` is the standard error that we know of; what it holds and leaves out stands in the table's note.
struct ComparedNumber {
  std::string what;
  std::string unit = "";
  std::optional<double> reference = {};
  std::optional<double> ours = {};
  std::optional<double> error = {};
  int digits = 4;
  std::string remark = "";

  // (ours - reference) / reference, where both are there and reference is not 0.
  std::optional<double> difference() const {
    if (!reference || !ours || *reference == 0) return std::nullopt;
    return (*ours - *reference) / *reference;
  }
};

struct ComparisonTable {
  std::string name;
  std::string note;
  std::string beside = "";  // what `reference` is; empty: the job's reference
  std::vector<ComparedNumber> rows;

  // Mean of |difference| over the rows that have one; nullopt where none has.
  std::optional<double> mean_difference() const {
    double sum = 0;
    int n = 0;
    for (const auto& row : rows)
      if (const auto difference = row.difference()) {
        sum += *difference < 0 ? -*difference : *difference;
        ++n;
      }
    return n ? std::optional(sum / n) : std::nullopt;
  }
};

}  // namespace percal
