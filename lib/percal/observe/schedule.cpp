#include "percal/observe/schedule.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "percal/base/error.hpp"
#include "percal/units/quantity.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr const char* accepted =
    "every=TIME (every=0.5us), every=DEPTH of the tip (every=10um), every=SHARE of the target's depth (every=2%) or "
    "every=STEPS (every=200)";

// A whole number of steps, and nothing else.
bool is_steps(const std::string& text, long& steps) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), steps);
  return error == std::errc{} && end == text.data() + text.size();
}

bool is_interval(double value) { return std::isfinite(value) && value > 0; }

}  // namespace

FieldInterval parse_field_interval(const std::string& text, const std::string& key) {
  const auto refuse = [&](const std::string& why) -> BadInput {
    return BadInput(Place{.file = "", .line = 0, .key = key}, in_quotes(text) + why, accepted);
  };
  constexpr std::string_view start = "every=";
  if (!text.starts_with(start)) throw refuse("");
  const std::string interval = text.substr(start.size());
  if (long steps = 0; is_steps(interval, steps)) {
    if (steps < 1) throw refuse("");
    return EverySteps{steps};
  }
  try {
    if (interval.ends_with('%')) {
      const Quantity percent = parse_quantity(interval.substr(0, interval.size() - 1));
      if (percent.dimension == dimension::none && is_interval(percent.value) && percent.value <= 100)
        return EveryShareOfDepth{percent.value / 100};
      throw refuse("");
    }
    const Quantity quantity = parse_quantity(interval);
    if (is_interval(quantity.value) && quantity.dimension == dimension::time) return EveryTime{quantity.value};
    if (is_interval(quantity.value) && quantity.dimension == dimension::length) return EveryDepth{quantity.value};
  } catch (const std::invalid_argument& error) {
    throw refuse(std::string(" (") + error.what() + ")");
  }
  throw refuse("");
}

FieldSchedule::FieldSchedule(const FieldInterval& interval, const Problem& problem, const Scales& scales)
    : interval_(interval) {
  if (const auto* every = std::get_if<EveryTime>(&interval)) unit_ = every->seconds * scales.speed / scales.radius;
  if (const auto* every = std::get_if<EveryDepth>(&interval)) unit_ = every->metres / scales.radius;
  if (const auto* every = std::get_if<EveryShareOfDepth>(&interval)) unit_ = every->share * problem.whole_depth();
  if (const auto* every = std::get_if<EverySteps>(&interval)) unit_ = static_cast<double>(every->steps);
}

double FieldSchedule::reached(const Moment& now) const {
  if (std::holds_alternative<EverySteps>(interval_)) return static_cast<double>(now.step) / unit_;
  return (std::holds_alternative<EveryTime>(interval_) ? now.time : now.tip) / unit_;
}

bool FieldSchedule::is_due(const Moment& now) {
  const double reached_now = reached(now);
  if (reached_now < next_) return false;
  next_ = std::floor(reached_now) + 1;
  return true;
}

}  // namespace percal
