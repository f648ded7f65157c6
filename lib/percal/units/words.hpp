// Words in messages: what the user wrote, shown safely, and what was probably meant.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percal {

// The text in double quotes, cut at 60 characters; control characters and broken UTF-8 appear as \xNN.
std::string in_quotes(std::string_view text);

// The known word that `word` was probably meant to be: equal but for case and '-' or '_', or a few typing errors away.
std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& known);

// The letters A to Z made small, all others as they are.
std::string lower_case(std::string_view text);

// Without the blanks at both ends.
std::string trimmed(const std::string& text);

// "a, b, c".
std::string listed(const std::vector<std::string>& words);

}  // namespace percal
