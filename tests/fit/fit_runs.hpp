// percal fit as a user runs it, in a folder of its own.
#pragma once
#include "support/program.hpp"

namespace percal::test {

class FitRuns : public Program {
 protected:
  Ended fit(std::vector<std::string> arguments, const std::function<void()>& in_child = {}) const {
    arguments.insert(arguments.begin(), "fit");
    return run(arguments, in_child);
  }
};

}  // namespace percal::test
