// What readers of TOML files ask for: every key with its kind, what is accepted and its default, as the reader says them at the
// moment it asks. The reference of the file formats is made from such records (docs/formats/keys.md).
#pragma once
#include <map>
#include <string>
#include <vector>

#include "percal/text/range.hpp"
#include "percal/units/quantity.hpp"

namespace percal {

// What a reader said about a key. Texts are for people.
struct KeyForm {
  std::string kind;      // "length", "number", "whole number", "word", "text", "true or false", "table", "tables", ...
  std::string accepted;  // "a positive length with its unit, ..."; empty where the kind says it all
  std::string fallback;  // the default as it would be written in the file; empty where there is none
};

// What getters of TOML tables say about the keys they are asked for.
// "a whole number from 1 to 9"; "\"a\", \"b\"".
std::string accepted_integer(int low, int high);
std::string accepted_words(const std::vector<std::string>& words);

KeyForm quantity_form(const Dimension& dimension, const Range& range);
KeyForm quantity_array_form(const Dimension& dimension, const Range& range);
KeyForm quantity_tuples_form(const Dimension& dimension, const Range& range, const std::string& what);  // "pairs"
KeyForm integer_form(int low, int high);
KeyForm word_form(const std::vector<std::string>& words);
inline KeyForm text_form() { return {"text", "", ""}; }
inline KeyForm flag_form() { return {"true or false", "", ""}; }
inline KeyForm file_form() { return {"file", "the name of a file", ""}; }

// The form with a default as it would be written in the file.
KeyForm with_default(KeyForm form, std::string fallback);

// A number as it is written in a file: with a unit that reads well where it has a dimension.
std::string written(double value, const Dimension& dimension);

struct RecordedKey {
  std::string path;  // "target.erosion.strain", "shots[].points[].speed", "materials.NAME.density"
  KeyForm form;
  bool required = false;  // left out, the file is refused; false for keys that are asked for only where they are there
};

// The keys of one kind of file in the order in which they were asked for first. Of a key that was asked for several times the
// first form stands, one that was described stands before it, and it is required only where no reader ever looked
// whether it is there.
class KeyRecord {
 public:
  void ask(const std::string& path, const KeyForm& form, bool required);
  void describe(const std::string& path, const KeyForm& form);  // in place of what the getters say
  void look(const std::string& path);                           // whether the key is there: so it may be missing
  void merge(const KeyRecord& other);

  std::vector<RecordedKey> keys() const;

 private:
  struct Entry {
    RecordedKey key;
    bool asked = false, described = false, looked = false;
  };
  Entry& entry(const std::string& path);
  std::vector<Entry> entries_;
};

// While one of these is alive, the TOML files that this thread reads are recorded, each by its name. Nothing is recorded
// otherwise. They may not be nested.
class KeyRecording {
 public:
  KeyRecording();
  ~KeyRecording();
  KeyRecording(const KeyRecording&) = delete;
  KeyRecording& operator=(const KeyRecording&) = delete;

  const KeyRecord& of(const std::string& file) const;  // throws std::out_of_range where it was not read

  // The record of a file that is about to be read; nullptr where nothing is recorded. It lives as long as the recording.
  static KeyRecord* start(const std::string& file);

 private:
  std::map<std::string, KeyRecord> records_;
};

}  // namespace percal
