// When fields are written: "every=0.5us", "every=1um", "every=2%", "every=200".
#pragma once
#include <string>
#include <variant>

#include "percal/impact/frame.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// Each is counted from the impact on. A frame falls on the first long step that has reached a multiple; where a step passes
// several, there is one frame.
struct EveryTime {
  double seconds;
};
struct EveryDepth {
  double metres;  // of the particle's tip
};
struct EveryShareOfDepth {
  double share;  // of all layers' depth, by the particle's tip
};
struct EverySteps {
  long steps;  // of the longer kind
};
using FieldInterval = std::variant<EveryTime, EveryDepth, EveryShareOfDepth, EverySteps>;

// Throws BadInput, which names `key`.
FieldInterval parse_field_interval(const std::string& text, const std::string& key);

// Says which moments are due, asked in order; the first one is.
class FieldSchedule {
 public:
  FieldSchedule(const FieldInterval& interval, const Problem& problem, const Scales& scales);
  bool is_due(const Moment& now);

 private:
  double reached(const Moment& now) const;  // in intervals
  FieldInterval interval_;
  double unit_;  // of an interval, in the moment's own units
  double next_ = 0;
};

}  // namespace percal
