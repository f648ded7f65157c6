#include "percal/text/key_record.hpp"

#include <algorithm>
#include <cassert>

namespace percal {
namespace {
thread_local std::map<std::string, KeyRecord>* recorded = nullptr;
}  // namespace

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
