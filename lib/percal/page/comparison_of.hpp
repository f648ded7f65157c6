// What two results of one command are compared by. For the .cpp files of this folder.
#pragma once
#include <map>

#include "percal/page/sections.hpp"

namespace percal::page {

// A number of a result: where it stands, in words and as keys, and the error that the result knows of.
struct FoundNumber {
  std::string path;  // "skin/mu_highrate_true_Pa"; elements of lists by their names, else by their place from 1
  double value = 0;  // as it stands
  std::optional<double> error;  // standard error or half of the interval, in the same unit
};
// Every number of a result but those of its input, its data and its cost, in the order of their keys. Lists of plain numbers, such
// as profiles and outlines, are left out, and so are tables that repeat what stands elsewhere.
std::vector<FoundNumber> numbers_of(const Json& result);

// Whether a number is one that a reader asks for first.
bool is_main(const std::string& command, const std::string& path);

std::string path_words(const std::string& path);  // "skin: mu highrate true"
std::string value_of(const std::string& path,
                     std::optional<double> value);  // with the unit that the key's ending names

// Lines of two texts that are not in both, by the longest common subsequence. A line that has none beside it is alone in its row.
struct ChangedLine {
  int first_line = 0, second_line = 0;  // from 1; 0 where there is none
  std::string first, second;
};
std::vector<ChangedLine> changed_lines(const std::string& first, const std::string& second);

// Figures that both pages have, with the series of both in one chart.
std::vector<Figure> overlaid_figures(const Page& first, const Page& second);

}  // namespace percal::page
