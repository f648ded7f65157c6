// Where a run spends its processor time, by looking at it about every millisecond.
#pragma once
#include <map>
#include <string>

namespace percal::bench {

// From now on the program counter is noted whenever the process has used another millisecond or so of processor time.
void start_sampling();

// How many samples fell into each phase: "internal forces", "contact", "motion" and "rest". Functions are told apart by their
// names, so the program must export its symbols.
std::map<std::string, long> stop_sampling();

}  // namespace percal::bench
