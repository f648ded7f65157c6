#include "percal/math/draws.hpp"

#include "percal/math/distributions.hpp"

namespace percal {

// The middle of one of 2^53 equal parts of (0, 1).
double Draws::uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }

double Draws::normal() { return normal_quantile(uniform()); }

int Draws::index(int count) { return static_cast<int>(uniform() * count); }

}  // namespace percal
