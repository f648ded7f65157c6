#include "percal/impact/result.hpp"

#include <array>
#include <stdexcept>
#include <utility>

namespace percal {
namespace {
constexpr std::array<std::pair<Outcome, const char*>, 4> outcomes{{{Outcome::stopped, "stopped"},
                                                                   {Outcome::passed_through, "passed through"},
                                                                   {Outcome::time_up, "time up"},
                                                                   {Outcome::unstable, "unstable"}}};
}

std::string word(Outcome outcome) {
  for (const auto& [value, name] : outcomes)
    if (value == outcome) return name;
  throw std::invalid_argument("no such outcome");
}

Outcome outcome_from(const std::string& word) {
  for (const auto& [value, name] : outcomes)
    if (word == name) return value;
  throw std::invalid_argument("no outcome is called '" + word + "'");
}

double EnergyLedger::sum() const {
  double sum = 0;
  for (const auto& [key, share, words] : energy_terms) sum += this->*share;
  return sum;
}

}  // namespace percal
