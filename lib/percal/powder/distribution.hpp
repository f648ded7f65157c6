// A number that differs from particle to particle: its distribution, cut into cells.                 docs/theory/powder.md
#pragma once
#include <variant>
#include <vector>

namespace percal {

// ln x is normal; without a deviation every x is the median.
struct Lognormal {
  double median = 1;
  double log_deviation = 0;  // standard deviation of ln x
};

// A histogram: shares that add up to 1, each spread evenly over ln x from low to high; equal ends: all of it at one value.
struct ValueClass {
  double low = 0, high = 0, share = 0;
};
using Histogram = std::vector<ValueClass>;

using Distribution = std::variant<Lognormal, Histogram>;

// Of the mean and the standard deviation of x.                                                                       (1)
Lognormal lognormal_of(double mean, double deviation);

// The distribution by number of one that is given by the mass of what has the value x, mass going as x^3.           (2)
Distribution by_number(const Distribution& by_mass);

double median_of(const Distribution& distribution);
// Standard deviation of ln x.
double log_deviation_of(const Distribution& distribution);
// Whether every x is the same.
bool is_one_value(const Distribution& distribution);
// ln x about the median times the factor: 0 leaves no spread, 2 twice as much.
Distribution spread_by(const Distribution& distribution, double factor);

// A part of a distribution.
struct DistributionCell {
  double low = 0, high = 0;
  double share = 0;   // of the number
  double moment = 0;  // integral of x^power over the cell
};

// Some `count` cells in the order of their values, their shares adding up to 1. Within a cell ln x is spread evenly. (3)
// More classes than that are joined with their neighbours.
std::vector<DistributionCell> cells_of(const Distribution& distribution, int count, double power);
// The same as single values: low and high are one.
std::vector<DistributionCell> nodes_of(const Distribution& distribution, int count, double power);

}  // namespace percal
