// What a number that was read may be, and the words for it in messages.
#pragma once
#include <string>

#include "percal/units/quantity.hpp"

namespace percal {

// Closed or open bounds of a number, checked on reading. `words` says them in the message: "a positive length"; left
// empty they are made from the bounds. NaN and infinity are in no range.
struct Range {
  double low;
  double high;
  bool low_open = false;
  bool high_open = false;
  std::string words = {};
  std::string in_general = {};  // the words without the numbers of this one file, for the reference; empty: as `words`
};
Range positive(const std::string& what = "number");      // (0, inf), "a positive WHAT"
Range not_negative(const std::string& what = "number");  // [0, inf), "a WHAT not below zero"
Range any_number();                                      // finite

// Whether a value is finite and within the bounds.
bool contains(const Range& range, double value);

// "a positive length"; "a number above 0 and up to 1.2".
std::string words_of(const Range& range);

// As above with the units: "a positive length with its unit, such as "5 m" (m, mm, um, nm)".
std::string words_of(const Range& range, const Dimension& dimension);

// "a length", "an area".
std::string with_article(const std::string& noun);

}  // namespace percal
