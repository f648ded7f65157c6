#include "percal/impact/result.hpp"

#include <array>
#include <span>
#include <stdexcept>
#include <utility>

namespace percal {
namespace {
constexpr std::array<std::pair<Outcome, const char*>, 4> outcomes{{{Outcome::stopped, "stopped"},
                                                                   {Outcome::passed_through, "passed through"},
                                                                   {Outcome::time_up, "time up"},
                                                                   {Outcome::unstable, "unstable"}}};
constexpr std::array<std::pair<Ending, const char*>, 6> endings{{{Ending::rests, "rests"},
                                                                 {Ending::left_upwards, "left upwards"},
                                                                 {Ending::ricochets, "ricochets"},
                                                                 {Ending::passed_through, "passed through"},
                                                                 {Ending::time_up, "time up"},
                                                                 {Ending::unstable, "unstable"}}};

template <class Value>
std::string word_of(Value wanted, std::span<const std::pair<Value, const char*>> all) {
  for (const auto& [value, name] : all)
    if (value == wanted) return name;
  throw std::invalid_argument("no such outcome");
}

template <class Value>
Value value_of(const std::string& word, std::span<const std::pair<Value, const char*>> all) {
  for (const auto& [value, name] : all)
    if (word == name) return value;
  throw std::invalid_argument("no outcome is called '" + word + "'");
}
}  // namespace

std::string word(Outcome outcome) { return word_of<Outcome>(outcome, outcomes); }
Outcome outcome_from(const std::string& word) { return value_of<Outcome>(word, outcomes); }
std::string word(Ending ending) { return word_of<Ending>(ending, endings); }
Ending ending_from(const std::string& word) { return value_of<Ending>(word, endings); }

double EnergyLedger::sum() const {
  double sum = 0;
  for (const auto& [key, share, words] : energy_terms) sum += this->*share;
  return sum;
}

}  // namespace percal
