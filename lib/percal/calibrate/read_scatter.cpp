// [scatter.NAME], and shares of 1 as they may be written.
#include <fmt/format.h>

#include <stdexcept>

#include "percal/calibrate/read_job.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

std::optional<double> percentage(std::string text) {
  while (text.ends_with(' ')) text.pop_back();
  if (!text.ends_with('%')) return std::nullopt;
  text.pop_back();
  while (text.ends_with(' ')) text.pop_back();
  try {
    const Quantity quantity = parse_quantity(text);
    if (quantity.dimension == dimension::none) return quantity.value / 100;
  } catch (const std::invalid_argument&) {
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> optional_share_from(const TomlTable& block, const std::string& key, const Range& range) {
  block.describe(key, {"share", words_of(range) + ", as 0.05 or \"5 %\"", ""});
  if (!block.is_text(key)) return block.optional_number(key, range);
  const std::string text = block.text(key);
  const auto share = percentage(text);
  if (!share || !contains(range, *share)) block.refuse(key, in_quotes(text), words_of(range) + ", as 0.05 or \"5 %\"");
  return share;
}

double share_from(const TomlTable& block, const std::string& key, const Range& range, double fallback) {
  block.describe(key, {"share", words_of(range) + ", as 0.05 or \"5 %\"", fmt::format("{}", fallback)});
  return optional_share_from(block, key, range).value_or(fallback);
}

void read_scatter_groups(const TomlTable& root, CalibrationJob& job) {
  const auto blocks = root.optional_table("scatter");
  if (!blocks) return;
  for (const std::string& name : blocks->keys()) {
    const TomlTable block = blocks->table(name);
    ScatterGroup group{.name = name, .estimated = block.flag("estimated", !block.has("fixed")), .fixed = 0};
    const auto fixed = optional_share_from(block, "fixed", not_negative("share"));
    if (group.estimated == fixed.has_value())
      block.refuse("fixed", fixed ? "fixed beside estimated = true" : "no such key beside estimated = false",
                   "estimated = true, or fixed = SHARE");
    group.fixed = fixed.value_or(0);
    job.groups.push_back(group);
  }
}

int group_index(const TomlTable& block, const std::string& fallback, CalibrationJob& job) {
  const std::string name = block.text("scatter", fallback);
  for (std::size_t g = 0; g < job.groups.size(); ++g)
    if (job.groups[g].name == name) return static_cast<int>(g);
  if (block.has("scatter") && name != fallback)
    block.refuse("scatter", in_quotes(name), "a group of [scatter.NAME]: " + names_of(job.groups));
  job.groups.push_back({.name = fallback, .estimated = true, .fixed = 0});
  return static_cast<int>(job.groups.size()) - 1;
}

}  // namespace percal
