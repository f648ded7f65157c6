// A result as a page of data: sections of sentences, lists, tables and figures. Each command makes one from its own result.json
// (COMMAND/page/); text.hpp, html.hpp and markdown.hpp write it.
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "percal/plot/chart.hpp"

namespace percal::page {

// answer: what was asked for, what to know about it, what to do next; the terminal shows these sections unasked. more: the rest.
enum class Detail { answer, more };

struct Sentence {
  std::string text;  // plain text; a few sentences at most
};

enum class Tone { plain, note, warning };  // a note or a warning is marked as one by every writer

struct List {
  std::vector<std::string> items;
  Tone tone = Tone::plain;
};

// The only table type: cells are words, numbers already have their units.
struct Table {
  std::string caption;
  std::vector<std::vector<std::string>>
      rows;  // the first row is the header, empty cells: none; the first column names the row
  std::vector<std::string> notes;
  bool folded = false;  // long: a page for the browser shows it when it is asked to
};

struct Figure {
  std::string name;     // of its files, unique on the page: "ridge_mu"
  std::string caption;  // what it shows, a sentence or two
  std::string alt;      // what a reader who cannot see it should know: axes, series, the finding
  Chart chart;
};

// Text to be kept as it stands: the scene, a log.
struct Code {
  std::string caption;
  std::string text;
};

using Block = std::variant<Sentence, List, Table, Figure, Code>;

struct Section {
  std::string id;     // of the link: "ridge"
  std::string title;  // "The ridge"
  std::vector<Block> blocks;
  Detail detail = Detail::more;
};

struct Page {
  std::string title;
  std::string summary;  // a sentence or two: the answer with its interval
  std::vector<Section> sections;
};

// The figures in the order of the page.
std::vector<const Figure*> figures_of(const Page& page);

}  // namespace percal::page
