#include "percal/fit/shape/row_choice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "percal/fit/shape/curve_branches.hpp"
#include "percal/page/numbers.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

// Points of a test that belong together, from one turning point or new beginning to the next.
struct Piece {
  std::string name;
  std::size_t begin, end;
};

bool chosen(const Branch& branch, std::size_t number, const BranchChoice& choice) {
  if (std::holds_alternative<LoadingBranches>(choice)) return branch.loading;
  if (std::holds_alternative<UnloadingBranches>(choice)) return !branch.loading;
  if (const auto* one = std::get_if<OneBranch>(&choice)) return static_cast<std::size_t>(one->number) == number;
  return true;
}

// The whole test, cut where a curve begins anew.
std::vector<Piece> curves_in(const Followed& test, const std::vector<Branch>& branches) {
  std::vector<Piece> pieces{{test.name, 0, test.points.size() - 1}};
  for (const Branch& branch : branches) {
    if (!branch.anew) continue;
    pieces.back().end = branch.begin - 1;
    pieces.push_back({test.name, branch.begin, test.points.size() - 1});
  }
  return pieces;
}

std::vector<Piece> chosen_pieces(const Followed& test, const std::vector<Branch>& branches, const RowChoice& choice,
                                 const CsvTable& table) {
  if (std::holds_alternative<AllBranches>(choice.branch)) return curves_in(test, branches);
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < branches.size(); ++k) {
    if (!chosen(branches[k], k + 1, choice.branch)) continue;
    if (choice.until == CurveEnd::peak && !branches[k].loading)
      throw BadInput({table.file, table.rows[test.points[branches[k].begin].row].line, "branch"},
                     fmt::format("{}, an unloading, up to its peak", word(choice.branch)),
                     "a branch of loading; an unloading begins with its largest stress");
    pieces.push_back({test.name, branches[k].begin, branches[k].end});
  }
  return pieces;
}

// Pieces that are several of one test, by their numbers.
void number_pieces(std::vector<Piece>& pieces) {
  if (pieces.size() < 2) return;
  for (std::size_t k = 0; k < pieces.size(); ++k) pieces[k].name += fmt::format(", curve {}", k + 1);
}

// What an incompressible solid is stretched most, in any direction.
double largest_stretch(const Strained& strained) {
  const double amount = strained.amount;
  switch (strained.deformation) {
    case Deformation::equibiaxial: return std::max(amount, 1 / (amount * amount));
    case Deformation::planar:
    case Deformation::planar_held: return std::max(amount, 1 / amount);
    case Deformation::simple_shear: return std::abs(amount) / 2 + std::sqrt(1 + amount * amount / 4);
    default: return std::max(amount, 1 / std::sqrt(amount));
  }
}

// Rows of one file, as they are chosen.
class Chooser {
 public:
  Chooser(CurveData& data, const CsvTable& table, const RowChoice& choice)
      : data_(data), table_(table), choice_(choice), kept_(data.points.size(), true) {}

  void choose() {
    const bool whole = std::holds_alternative<AllBranches>(choice_.branch);
    if (!whole && !std::holds_alternative<LoadingBranches>(choice_.branch)) kept_.assign(kept_.size(), false);
    const auto tests = followed(data_.points, 2);
    double longest = 0;
    for (const Followed& test : tests) longest = std::max(longest, test.longest);
    for (const Followed& test : tests) {
      if (!(test.longest > 0) || !(test.largest > 0)) continue;
      const std::vector<Branch> branches = branches_of(test);
      auto pieces = chosen_pieces(test, branches, choice_, table_);
      number_pieces(pieces);
      if (!whole) keep_alone(test, branches, pieces);
      const auto holds = holds_of(test);
      if (choice_.holds == Holds::left_out) leave_holds_out(test, holds);
      if (choice_.until == CurveEnd::peak && test.points.size() >= fewest_rows && test.longest > turning * longest)
        cut_at_peaks(test, pieces, holds);
    }
    finish();
  }

 private:
  CurveSource& source() { return data_.sources.back(); }

  void keep_alone(const Followed& test, const std::vector<Branch>& branches, const std::vector<Piece>& pieces) {
    for (const Met& point : test.points) kept_[point.row] = false;
    std::size_t rows = 0;
    for (const Piece& piece : pieces)
      for (std::size_t i = piece.begin; i <= piece.end; ++i)
        if (!kept_[test.points[i].row]) kept_[test.points[i].row] = true, ++rows;
    const auto loading = std::count_if(branches.begin(), branches.end(), [](const Branch& b) { return b.loading; });
    if (rows == test.points.size()) return;
    source().warnings.push_back(fmt::format(
        "{}: {}: the stretch runs back: {} branches, {} of loading and {} of unloading; fitted {}: {} of {} rows.",
        table_.file, test.name, branches.size(), loading, static_cast<std::ptrdiff_t>(branches.size()) - loading,
        pieces.empty() ? "is none of them"
        : std::holds_alternative<OneBranch>(choice_.branch)
            ? "is branch " + word(choice_.branch)
            : fmt::format("{} of {}", pieces.size() == 1 ? "is the one" : fmt::format("are the {}", pieces.size()),
                          word(choice_.branch)),
        rows, test.points.size()));
  }

  // The first row of a hold is the end of the ramp before it.
  void leave_holds_out(const Followed& test, const std::vector<HeldRows>& holds) {
    for (const HeldRows& held : holds) {
      if (!kept_[test.points[held.begin].row] && !kept_[test.points[held.end].row]) continue;
      for (std::size_t i = held.begin + 1; i <= held.end; ++i) kept_[test.points[i].row] = false;
      const StressPoint &before = data_.points[test.points[held.begin].row],
                        &after = data_.points[test.points[held.end].row];
      source().holds.push_back({.test = test.name,
                                .amount = before.strained.amount,
                                .stress_before = before.nominal_stress,
                                .stress_after = after.nominal_stress,
                                .rows = static_cast<int>(held.end - held.begin)});
    }
  }

  void cut_at_peaks(const Followed& test, const std::vector<Piece>& pieces, const std::vector<HeldRows>& holds) {
    for (const Piece& piece : pieces) {
      const Top top = top_of(test, piece.begin, piece.end);
      const Met& at = test.points[top.at];
      if (!(at.stress > 0) || at.strain <= test.points[piece.begin].strain) continue;  // an unloading has no peak
      for (std::size_t i = top.at + 1; i <= piece.end; ++i) kept_[test.points[i].row] = false;
      const bool relaxes = std::any_of(holds.begin(), holds.end(), [&](const HeldRows& held) {
        return held.begin <= top.at + 1 && held.end > top.at;
      });
      source().peaks.push_back({.test = piece.name,
                                .amount = data_.points[at.row].strained.amount,
                                .stress = data_.points[at.row].nominal_stress,
                                .erosion_strain = largest_stretch(data_.points[at.row].strained) - 1,
                                .fallen_to = top.fallen_to,
                                .end = relaxes                  ? CurvePeak::End::held
                                       : top.fallen_to < fallen ? CurvePeak::End::falls
                                                                : CurvePeak::End::none,
                                .rows_behind = static_cast<int>(piece.end - top.at)});
    }
  }

  void finish() {
    std::vector<StressPoint> left;
    for (std::size_t i = 0; i < kept_.size(); ++i)
      if (kept_[i]) left.push_back(data_.points[i]);
    if (left.empty())
      throw BadInput({table_.file, table_.header_line, "branch"}, word(choice_.branch) + ", which no test here has",
                     branch_words);
    say_holds();
    int behind = 0;
    for (const CurvePeak& peak : source().peaks) behind += peak.rows_behind;
    if (const std::size_t curves = source().peaks.size(); curves > 0)
      source().taken.push_back(fmt::format("{}: {} fitted up to the largest stress; {} behind it {} left out.",
                                           table_.file,
                                           curves == 1 ? "the curve is" : fmt::format("each of {} curves is", curves),
                                           page::counted(behind, "row"), behind == 1 ? "is" : "are"));
    source().points = static_cast<int>(left.size());
    data_.points = std::move(left);
  }

  void say_holds() {
    const auto& holds = source().holds;
    if (holds.empty()) return;
    std::vector<std::string> shares;
    int rows = 0;
    for (const CurveHold& hold : holds) {
      rows += hold.rows;
      shares.push_back(page::percent(hold.stress_after / hold.stress_before, 0));
    }
    source().taken.push_back(fmt::format(
        "{}: {} of {} left out: the stress fell to {} of what it was while the stretch was held ({} to {} at the "
        "first). "
        "That is relaxation; the fit is of a solid that knows no time and cannot tell it.",
        table_.file, page::counted(rows, "row"), page::counted(static_cast<long>(holds.size()), "hold"), listed(shares),
        page::pressure(holds[0].stress_before, 3), page::pressure(holds[0].stress_after, 3)));
  }

  CurveData& data_;
  const CsvTable& table_;
  const RowChoice& choice_;
  std::vector<bool> kept_;
};

}  // namespace

std::optional<BranchChoice> branch_choice_of(const std::string& text) {
  if (text == "loading") return LoadingBranches{};
  if (text == "unloading") return UnloadingBranches{};
  if (text.empty() || text.size() > 6 || text[0] == '0' ||
      !std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; }))
    return std::nullopt;
  return OneBranch{std::stoi(text)};
}

std::string word(const BranchChoice& choice) {
  if (const auto* one = std::get_if<OneBranch>(&choice)) return std::to_string(one->number);
  if (std::holds_alternative<LoadingBranches>(choice)) return "loading";
  return std::holds_alternative<UnloadingBranches>(choice) ? "unloading" : "";
}

void choose_rows(CurveData& data, const CsvTable& table, const RowChoice& choice) {
  const bool branch = !std::holds_alternative<AllBranches>(choice.branch);
  if (!branch && choice.until == CurveEnd::last_row && choice.holds != Holds::left_out) return;
  for (std::size_t i = 0; i < data.points.size(); ++i)
    if (data.points[i].strained.deformation == Deformation::biaxial)
      throw BadInput({table.file, table.rows[i].line,
                      branch                            ? "branch"
                      : choice.holds != Holds::left_out ? "until"
                                                        : "without"},
                     "general_biaxial points, whose order no single stretch tells", "--where to choose rows");
  Chooser(data, table, choice).choose();
}

}  // namespace percal
