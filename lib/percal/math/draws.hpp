// Random numbers whose bits depend on the seed alone: the engine is the standard's, the distributions are written out here
// because the standard leaves theirs to each library.
#pragma once
#include <cstdint>
#include <random>

namespace percal {

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_(seed) {}

  double uniform();      // in (0, 1), ends excluded
  double normal();       // standard normal
  int index(int count);  // 0 .. count - 1, each as likely

 private:
  std::mt19937_64 engine_;
};

}  // namespace percal
