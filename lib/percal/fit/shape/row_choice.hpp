// Which rows of a curve are fitted: a branch of its cycles, what is before its peak, what is no hold.   docs/formats/csv.md
#pragma once
#include <optional>
#include <string>
#include <variant>

#include "percal/fit/points/curve_data.hpp"
#include "percal/text/csv.hpp"

namespace percal {

struct AllBranches {};
struct LoadingBranches {};
struct UnloadingBranches {};
struct OneBranch {
  int number;  // from 1, in the order of the rows
};
using BranchChoice = std::variant<AllBranches, LoadingBranches, UnloadingBranches, OneBranch>;

enum class CurveEnd { last_row, peak };
enum class Holds { kept, left_out, timed };  // timed: kept, with the times at which their stress relaxes

struct RowChoice {
  BranchChoice branch = AllBranches{};
  CurveEnd until = CurveEnd::last_row;
  Holds holds = Holds::kept;
};

// "loading", "unloading" or "3"; none for other texts. And back: empty for all branches.
std::optional<BranchChoice> branch_choice_of(const std::string& text);
std::string word(const BranchChoice& choice);
inline constexpr const char* branch_words = "loading, unloading, or a number: 1 is the first branch";

// Leaves the other rows of a file's points (one for each row of the table) out; the last source gets the peaks, the holds and sentences.
// Throws BadInput where nothing is left, where general biaxial points have an order that no single stretch tells, and for the peak of an
// unloading.
void choose_rows(CurveData& data, const CsvTable& table, const RowChoice& choice);

}  // namespace percal
