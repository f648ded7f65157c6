// What getters of TOML tables say about the keys they are asked for.
#pragma once
#include <string>
#include <vector>

#include "percal/text/key_record.hpp"
#include "percal/text/range.hpp"
#include "percal/units/quantity.hpp"

namespace percal {

// "a whole number from 1 to 9"; "\"a\", \"b\"".
std::string accepted_integer(int low, int high);
std::string accepted_words(const std::vector<std::string>& words);

KeyForm quantity_form(const Dimension& dimension, const Range& range);
KeyForm quantity_array_form(const Dimension& dimension, const Range& range);
KeyForm quantity_pairs_form(const Dimension& dimension, const Range& range);
KeyForm integer_form(int low, int high);
KeyForm word_form(const std::vector<std::string>& words);
inline KeyForm text_form() { return {"text", "", ""}; }
inline KeyForm flag_form() { return {"true or false", "", ""}; }
inline KeyForm file_form() { return {"file", "the name of a file", ""}; }

// The form with a default as it would be written in the file.
KeyForm with_default(KeyForm form, std::string fallback);

// A number as it is written in a file: with a unit that reads well where it has a dimension.
std::string written(double value, const Dimension& dimension);

}  // namespace percal
