// Where a continuous function of one variable is zero.
#pragma once
#include <functional>

namespace percal {

// Brent's method (GSL) between `low` and `high`, at which the function has different signs or is zero, until the bracket is narrower than
// `tolerance`. What the function throws is thrown here. Asserts the signs.
double root(const std::function<double(double)>& function, double low, double high, double tolerance);

// The same until `enough` of the estimate and the bracket's width.
double root(const std::function<double(double)>& function, double low, double high,
            const std::function<bool(double estimate, double width)>& enough);

}  // namespace percal
