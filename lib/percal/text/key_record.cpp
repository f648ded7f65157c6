#include "percal/text/key_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "percal/units/words.hpp"

namespace percal {
namespace {
thread_local std::map<std::string, KeyRecord>* recorded = nullptr;

std::string general_words(const Range& range) { return range.in_general.empty() ? words_of(range) : range.in_general; }
std::string kind_of(const Dimension& dimension) { return dimension == dimension::none ? "number" : name_of(dimension); }

}  // namespace

std::string accepted_integer(int low, int high) { return fmt::format("a whole number from {} to {}", low, high); }

std::string accepted_words(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + in_quotes(word);
  return text;
}

KeyForm quantity_form(const Dimension& dimension, const Range& range) {
  return {kind_of(dimension), general_words(range), ""};
}

KeyForm quantity_array_form(const Dimension& dimension, const Range& range) {
  return {"array: " + kind_of(dimension), "each element " + general_words(range), ""};
}

KeyForm quantity_tuples_form(const Dimension& dimension, const Range& range, const std::string& what) {
  return {"array of " + what + ": " + kind_of(dimension), "each number " + general_words(range), ""};
}

KeyForm integer_form(int low, int high) { return {"whole number", accepted_integer(low, high), ""}; }

KeyForm word_form(const std::vector<std::string>& words) { return {"word", accepted_words(words), ""}; }

KeyForm with_default(KeyForm form, std::string fallback) {
  form.fallback = std::move(fallback);
  return form;
}

std::string written(double value, const Dimension& dimension) {
  if (dimension == dimension::none) return fmt::format("{}", value);
  const std::string units = units_of(dimension);
  return in_quotes(value == 0 ? "0 " + units.substr(0, units.find(',')) : format_quantity(value, dimension));
}

KeyRecord::Entry& KeyRecord::entry(const std::string& path) {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.key.path == path; });
  if (found != entries_.end()) return *found;
  entries_.push_back({{path, {}, false}});
  return entries_.back();
}

void KeyRecord::ask(const std::string& path, const KeyForm& form, bool required) {
  Entry& e = entry(path);
  if (!e.asked) e.key.required = required;
  if (!e.asked && !e.described) e.key.form = form;
  e.asked = true;
}

void KeyRecord::describe(const std::string& path, const KeyForm& form) {
  Entry& e = entry(path);
  if (!e.described) e.key.form = form;
  e.described = true;
}

void KeyRecord::look(const std::string& path) { entry(path).looked = true; }

void KeyRecord::merge(const KeyRecord& other) {
  for (const Entry& theirs : other.entries_) {
    if (theirs.described) describe(theirs.key.path, theirs.key.form);
    if (theirs.asked) ask(theirs.key.path, theirs.key.form, theirs.key.required);
    if (theirs.looked) look(theirs.key.path);
  }
}

std::vector<RecordedKey> KeyRecord::keys() const {
  std::vector<RecordedKey> keys;
  for (const Entry& e : entries_) {
    if (!e.asked) continue;
    keys.push_back(e.key);
    keys.back().required = e.key.required && !e.looked;
  }
  return keys;
}

KeyRecording::KeyRecording() {
  assert(!recorded);
  recorded = &records_;
}

KeyRecording::~KeyRecording() { recorded = nullptr; }

const KeyRecord& KeyRecording::of(const std::string& file) const { return records_.at(file); }

KeyRecord* KeyRecording::start(const std::string& file) { return recorded ? &(*recorded)[file] : nullptr; }

}  // namespace percal
