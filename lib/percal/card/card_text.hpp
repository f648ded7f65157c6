// Numbers, names and comments as the narrow columns of an input deck take them.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace percal {

// The text of at most `width` characters that is nearest to `value`: fixed or with an exponent, with the zero before
// the point left out where that buys a digit, and always with a point. At most 15 digits: what is beyond them is the
// rounding of a unit's factor. Needs width >= 9, which holds one digit of any double. Throws BadInput for a value that
// is not finite (a number of the result that overflows in the card's units).
std::string number_field(double value, int width = 20);

// One line's fields, each `width` columns, right-aligned; 0 is written as "0.".
std::string fixed_line(const std::vector<std::string>& fields, int width);

// The number in a field, blanks around it allowed. nullopt where there is something else; a blank field is 0.
std::optional<double> field_number(const std::string& field);

// A text as comment lines of at most 80 columns, each ended by a newline. Line breaks, tabs and other control
// characters become blanks, characters outside ASCII a '?': nothing in the text can end the comment. Wrapped lines are
// indented.
std::string comment_lines(const std::string& prefix, const std::string& text);
std::string comment_lines(const std::string& prefix, const std::vector<std::string>& texts);  // one after another

// A name for programs that take ASCII letters, digits and `others` only: everything else is '_', blanks at the ends go, and
// an empty name is "Ogden".
std::string ascii_name(const std::string& name, const std::string& others, std::size_t most_characters);

}  // namespace percal
