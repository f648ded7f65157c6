// A value that stands by itself, as on the command line or in a call from Python: the text, and the name it goes by in messages. All throw
// BadInput.
#pragma once
#include <optional>
#include <string>

#include "percal/text/range.hpp"

namespace percal {

// "83 m/s" in SI.
double one_quantity(const std::string& text, const std::string& name, const Dimension& dimension,
                    const Range& accepted);
std::optional<double> optional_quantity(const std::string& text, const std::string& name, const Dimension& dimension,
                                        const Range& accepted);  // nothing of ""

// "2 %" or "0.02".
double one_share(const std::string& text, const std::string& name, const Range& accepted);

// "50..250 m/s", low before high; one quantity alone is both of its ends.
struct QuantityRange {
  double low = 0, high = 0;
};
QuantityRange quantity_range(const std::string& text, const std::string& name, const Dimension& dimension,
                             const Range& accepted);

}  // namespace percal
