#include "percal/fit/read/curve_measures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "percal/text/csv_cells.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

template <class Meaning>
struct Phrase {
  const char* words;
  Meaning meaning;
};

constexpr Phrase<StressMeasure> stress_table[] = {
    {"nominal", StressMeasure::nominal},
    {"engineering", StressMeasure::nominal},
    {"eng", StressMeasure::nominal},
    {"conventional", StressMeasure::nominal},
    {"lagrange", StressMeasure::nominal},
    {"lagrangian", StressMeasure::nominal},
    {"first piola kirchhoff", StressMeasure::nominal},
    {"first piola", StressMeasure::nominal},
    {"first pk", StressMeasure::nominal},
    {"piola kirchhoff 1", StressMeasure::nominal},
    {"pk1", StressMeasure::nominal},
    {"1pk", StressMeasure::nominal},
    {"biot", StressMeasure::biot},
    {"cauchy", StressMeasure::cauchy},
    {"true", StressMeasure::cauchy},
    {"kirchhoff", StressMeasure::cauchy},  // J = 1
    {"second piola kirchhoff", StressMeasure::second_piola},
    {"second piola", StressMeasure::second_piola},
    {"second pk", StressMeasure::second_piola},
    {"piola kirchhoff 2", StressMeasure::second_piola},
    {"pk2", StressMeasure::second_piola},
    {"2pk", StressMeasure::second_piola},
};

constexpr Phrase<Abscissa> strain_table[] = {
    {"engineering", Abscissa::engineering_strain},
    {"eng", Abscissa::engineering_strain},
    {"nominal", Abscissa::engineering_strain},
    {"conventional", Abscissa::engineering_strain},
    {"infinitesimal", Abscissa::engineering_strain},
    {"linear", Abscissa::engineering_strain},
    {"cauchy", Abscissa::engineering_strain},
    {"biot", Abscissa::engineering_strain},
    {"true", Abscissa::true_strain},
    {"natural", Abscissa::true_strain},
    {"hencky", Abscissa::true_strain},
    {"logarithmic", Abscissa::true_strain},
    {"log", Abscissa::true_strain},
    {"ln", Abscissa::true_strain},
    {"green", Abscissa::green_lagrange_strain},
    {"lagrange", Abscissa::green_lagrange_strain},
    {"lagrangian", Abscissa::green_lagrange_strain},
    {"green st venant", Abscissa::green_lagrange_strain},
    {"green saint venant", Abscissa::green_lagrange_strain},
    {"almansi", Abscissa::almansi_strain},
    {"euler", Abscissa::almansi_strain},
    {"eulerian", Abscissa::almansi_strain},
};

// Words that say which specimen, direction or test, and no measure.
constexpr const char* silent_words[] = {
    "stress",       "sigma",   "stretch",      "strain",   "lambda",    "gamma",
    "shear",        "simple",  "pure",         "tensile",  "tension",   "compressive",
    "uniaxial",     "biaxial", "equibiaxial",  "planar",   "axial",     "compression",
    "mean",         "average", "avg",          "measured", "applied",   "loading",
    "longitudinal", "data",    "experimental", "exp",      "direction", "along",
    "in",           "of",      "or",           "the",      "and",       "value",
    "values",       "ratio",   "principal",    "test",     "specimen",  "sample",
    "extensometer", "dic",     "crosshead",    "video",    "xx",        "yy",
    "zz",           "xy",      "xz",           "yz",       "radial",    "circumferential",
    "fibre",        "fiber",   "cross",        "ut",       "et",        "ps",
    "ss",           "film",    "per"};

// Letters that papers use for a measure (P, S, T, E): as a word of a header they could mean one.
bool is_label(const std::string& word) {
  if (std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c); })) return true;
  return word.size() == 1 && word != "%" && std::string("pste").find(word[0]) == std::string::npos;
}

bool is_silent(std::string word) {
  if (is_label(word)) return true;
  while (std::isdigit(static_cast<unsigned char>(word.back()))) word.pop_back();
  return is_label(word) || std::any_of(std::begin(silent_words), std::end(silent_words),
                                       [&](const char* known) { return word == known; });
}

bool has(const std::vector<std::string>& words, const std::string& part) {
  return std::any_of(words.begin(), words.end(),
                     [&](const auto& word) { return word.find(part) != std::string::npos; });
}

// "Compressive strain", but not "tension_compression_strain".
bool is_compressive(const std::vector<std::string>& words) {
  return (has(words, "compressive") || has(words, "compression")) && !has(words, "tensi");
}

template <class Table>
std::vector<std::string> phrases_of(const Table& table) {
  std::vector<std::string> all;
  for (const auto& phrase : table) all.push_back(phrase.words);
  return all;
}

// Number of words from `at` on that are the phrase; 0 where they are not.
std::size_t match(const std::vector<std::string>& words, std::size_t at, const std::string& phrase) {
  const std::vector<std::string> wanted = words_of_header(phrase);
  if (at + wanted.size() > words.size()) return 0;
  return std::equal(wanted.begin(), wanted.end(), words.begin() + static_cast<std::ptrdiff_t>(at)) ? wanted.size() : 0;
}

// The measure that the words name, the longest phrase first; `read_other` may know further words. nullopt where no word names one.
template <class Meaning, class Table, class Other>
std::optional<Meaning> measure_named(const CsvTable& table, const CsvColumn& column, const Table& known,
                                     const Other& read_other) {
  const std::vector<std::string> words = words_of_header(column.name);
  const Place place{table.file, table.header_line, column.header};
  std::optional<Meaning> found;
  for (std::size_t at = 0; at < words.size();) {
    std::size_t longest = 0;
    Meaning meaning{};
    for (const auto& phrase : known)
      if (const std::size_t length = match(words, at, phrase.words); length > longest)
        longest = length, meaning = phrase.meaning;
    if (longest > 0) {
      if (found && *found != meaning)
        throw BadInput(place, "two measures in one name", "one of " + listed(phrases_of(known)));
      found = meaning;
    } else if (!is_silent(words[at]) && !read_other(words[at])) {
      throw BadInput(place, "the word " + in_quotes(words[at]) + ", which percal does not know",
                     "a measure among " + listed(phrases_of(known)) +
                         "; give the column another name if the word says nothing of the measure");
    }
    at += std::max<std::size_t>(longest, 1);
  }
  return found;
}

// The header's unit, or a word of the name such as "percent" or "%".
double size_of(const CsvTable& table, const CsvColumn& column, const std::optional<double>& in_name) {
  const Place place{table.file, table.header_line, column.header};
  if (column.unit.empty()) return in_name.value_or(1);
  const auto size = size_of_strain(column.unit);
  if (!size)
    throw BadInput(place, "the unit " + in_quotes(column.unit),
                   "a dimensionless column: no unit, -, mm/mm, " + listed(strain_units()));
  if (in_name && *in_name != *size) throw BadInput(place, "two units in one name", "one of them");
  return *size;
}

}  // namespace

std::vector<std::string> words_of_header(const std::string& name) {
  std::vector<std::string> words;
  bool joined = false;
  char before = ' ';
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool letter = std::isalnum(byte) || byte >= 0x80;
    const bool hump = std::islower(static_cast<unsigned char>(before)) && std::isupper(byte);
    if (c == '%') words.emplace_back("%");
    if (letter && (!joined || hump)) words.emplace_back();
    if (letter) words.back() += c;
    joined = letter;
    before = c;
  }
  for (auto& word : words) {
    word = lower_case(word);
    for (const auto& [written, meant] :
         {std::pair{"1st", "first"}, {"2nd", "second"}, {"kirchoff", "kirchhoff"}, {"kirchhof", "kirchhoff"}})
      if (word == written) word = meant;
  }
  return words;
}

StressWords stress_words(const CsvTable& table, int column) {
  const CsvColumn& y = table.columns[static_cast<std::size_t>(column)];
  const auto measure = measure_named<StressMeasure>(table, y, stress_table, [](const std::string&) { return false; });
  return {measure.value_or(StressMeasure::nominal), is_compressive(words_of_header(y.name))};
}

AbscissaWords abscissa_words(const CsvTable& table, int column) {
  const CsvColumn& x = table.columns[static_cast<std::size_t>(column)];
  const Place place{table.file, table.header_line, x.header};
  const std::vector<std::string> words = words_of_header(x.name);
  const bool stretch = has(words, "stretch") || has(words, "lambda"),
             gamma = has(words, "gamma") || has(words, "shear");
  if (!stretch && !gamma && !has(words, "strain"))
    throw BadInput(place, "a column whose name does not say what it counts",
                   "stretch, strain (engineering), true_strain, green_strain or gamma in the header");
  std::optional<double> size;
  const auto measure = measure_named<Abscissa>(table, x, strain_table, [&](const std::string& word) {
    const auto of_word = size_of_strain(word == "cent" || word == "mille" ? "per " + word : word);
    if (of_word) size = of_word;
    return of_word.has_value();
  });
  AbscissaWords found{measure.value_or(Abscissa::engineering_strain), size_of(table, x, size), is_compressive(words)};
  if (stretch || gamma) {
    if (measure && !(gamma && !stretch && *measure == Abscissa::engineering_strain))
      throw BadInput(place, "a measure of strain in the name of a stretch or of a shear",
                     "stretch, gamma or shear strain without one");
    found.abscissa = stretch && gamma ? Abscissa::stretch_or_gamma : gamma ? Abscissa::gamma : Abscissa::stretch;
  }
  return found;
}

bool says_compressive(const CsvColumn& column) { return is_compressive(words_of_header(column.name)); }

std::string word(StressMeasure measure) {
  switch (measure) {
    case StressMeasure::cauchy: return "cauchy";
    case StressMeasure::second_piola: return "second Piola-Kirchhoff";
    case StressMeasure::biot: return "biot";
    case StressMeasure::nominal: break;
  }
  return "nominal";
}

std::vector<std::pair<std::string, std::string>> stress_phrases() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& phrase : stress_table) all.emplace_back(phrase.words, word(phrase.meaning));
  return all;
}

std::vector<std::pair<std::string, std::string>> strain_phrases() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& [words, meaning] : strain_table)
    all.emplace_back(words, meaning == Abscissa::true_strain             ? "true"
                            : meaning == Abscissa::green_lagrange_strain ? "Green-Lagrange"
                            : meaning == Abscissa::almansi_strain        ? "Almansi"
                                                                         : "engineering");
  return all;
}

double nominal_of(double stress, StressMeasure measure, const Strained& strained) {
  if (measure == StressMeasure::nominal) return stress;
  if (measure == StressMeasure::cauchy) return nominal_of_cauchy(stress, strained);
  if (strained.deformation == Deformation::simple_shear)
    throw std::invalid_argument(
        word(measure) +
        " stress of simple shear; accepted: the nominal or Cauchy shear stress, since the other "
        "needs the normal stress too");
  const bool held = strained.deformation == Deformation::planar_held;
  return measure == StressMeasure::second_piola && !held ? strained.amount * stress : stress;
}

}  // namespace percal
