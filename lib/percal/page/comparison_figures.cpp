// Figures of two pages in one chart: what is the same in both once and grey, the rest in a colour for each result.
#include <algorithm>

#include "percal/page/comparison_of.hpp"

namespace percal::page {
namespace {

constexpr std::size_t most_series = 5;  // that differ, of one result: more cannot be told apart
constexpr std::size_t most_figures = 12;

bool same(const Series& a, const Series& b) {
  return a.name == b.name && a.mark == b.mark && a.x == b.x && a.y == b.y && a.low == b.low && a.high == b.high;
}

bool contains(const Chart& chart, const Series& series) {
  return std::any_of(chart.series.begin(), chart.series.end(), [&](const Series& one) { return same(one, series); });
}

// The series of `mine` that `other` has not, in this colour.
std::vector<Series> own_series(const Chart& mine, const Chart& other, const std::string& of, int colour) {
  std::vector<Series> own;
  for (Series series : mine.series) {
    if (contains(other, series)) continue;
    series.name = series.name.empty() ? "" : of + ": " + series.name;
    series.colour = colour;
    own.push_back(series);
  }
  return own;
}

const Figure* figure_called(const Page& page, const std::string& name) {
  for (const Section& section : page.sections)
    for (const Block& block : section.blocks)
      if (const auto* figure = std::get_if<Figure>(&block); figure && figure->name == name) return figure;
  return nullptr;
}

}  // namespace

std::vector<Figure> overlaid_figures(const Page& first, const Page& second) {
  std::vector<Figure> figures;
  for (const Section& section : first.sections)
    for (const Block& block : section.blocks) {
      const auto* one = std::get_if<Figure>(&block);
      const Figure* other = one ? figure_called(second, one->name) : nullptr;
      if (!other || one->chart.x.label != other->chart.x.label || one->chart.y.label != other->chart.y.label) continue;
      const auto ours = own_series(one->chart, other->chart, "A", 0),
                 theirs = own_series(other->chart, one->chart, "B", 1);
      if ((ours.empty() && theirs.empty()) || std::max(ours.size(), theirs.size()) > most_series) continue;
      Figure both = *one;
      both.chart.series.clear();
      bool named = false;
      for (Series series : one->chart.series)
        if (contains(other->chart, series)) {
          series.name = named || series.name.empty() ? "" : "the same in both";
          named |= !series.name.empty();
          series.colour = -1;
          both.chart.series.push_back(series);
        }
      both.chart.series.insert(both.chart.series.end(), ours.begin(), ours.end());
      both.chart.series.insert(both.chart.series.end(), theirs.begin(), theirs.end());
      both.caption = "A. " + one->caption + " B. " + other->caption;
      both.alt = "Both results in one plot. A: " + one->alt + " B: " + other->alt;
      if (figures.size() < most_figures) figures.push_back(std::move(both));
    }
  return figures;
}

}  // namespace percal::page
