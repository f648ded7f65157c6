#include "percal/text/stl.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "percal/base/error.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr std::size_t binary_head = 84, binary_triangle = 50;  // bytes
constexpr const char* accepted_forms =
    "an STL file: text that begins with \"solid\" and has facets, or 84 bytes and 50 for each triangle";

std::uint32_t whole_number_at(const std::string& content, std::size_t at) {
  std::uint32_t number = 0;
  for (int byte = 3; byte >= 0; --byte) number = number << 8 | static_cast<unsigned char>(content[at + byte]);
  return number;
}

double number_at(const std::string& content, std::size_t at) {
  const std::uint32_t bits = whole_number_at(content, at);
  float number = 0;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

void need_few(std::size_t triangles, const std::string& name, int line) {
  if (triangles > most_triangles)
    throw BadInput({.file = name, .line = line, .key = ""}, fmt::format("{} triangles or more", triangles),
                   fmt::format("at most {}", most_triangles));
}

std::vector<StlTriangle> binary_triangles(const std::string& content, const std::string& name) {
  const std::size_t count = whole_number_at(content, binary_head - 4);
  need_few(count, name, 0);
  std::vector<StlTriangle> triangles(count);
  for (std::size_t k = 0; k < count; ++k)
    for (int corner = 0; corner < 3; ++corner)
      for (int d = 0; d < 3; ++d) {
        const double number = number_at(content, binary_head + k * binary_triangle + 12 * (corner + 1) + 4 * d);
        if (!std::isfinite(number))
          throw BadInput({.file = name, .line = 0, .key = ""},
                         fmt::format("a number that is not finite in triangle {}", k + 1), "finite numbers");
        triangles[k].corners[corner][d] = number;
      }
  return triangles;
}

// Words of a text with the lines that they stand in.
class StlWords {
 public:
  StlWords(const std::string& content, const std::string& name) : lines_(content), name_(name) {}

  // False at the end.
  bool next() {
    while (!(words_ >> word_)) {
      std::string line;
      if (!std::getline(lines_, line)) {
        word_ = "the end of the file";
        return false;
      }
      ++line_;
      words_ = std::istringstream(line);
    }
    return true;
  }
  void skip_line() { words_ = std::istringstream(); }
  const std::string& word() const { return word_; }
  int line() const { return line_; }

  void need(const char* word) {
    if (!next() || word_ != word) refuse(in_quotes(word));
  }
  double number() {
    next();
    double value = 0;
    const bool plus = word_.starts_with('+') && !word_.starts_with("+-");
    const char *begin = word_.data() + (plus ? 1 : 0), *end = word_.data() + word_.size();
    const auto [read_to, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || read_to != end || !std::isfinite(value)) refuse("a finite number");
    return value;
  }
  [[noreturn]] void refuse(const std::string& accepted) const {
    throw BadInput({.file = name_, .line = line_, .key = ""}, in_quotes(word_), accepted);
  }

 private:
  std::istringstream lines_, words_;
  const std::string& name_;
  std::string word_;
  int line_ = 0;
};

std::vector<StlTriangle> text_triangles(const std::string& content, const std::string& name) {
  StlWords words(content, name);
  std::vector<StlTriangle> triangles;
  words.need("solid");
  words.skip_line();  // the body's name
  for (;;) {
    if (!words.next()) words.refuse("\"facet\" or \"endsolid\"");
    if (words.word() == "endsolid") break;
    if (words.word() != "facet") words.refuse("\"facet\" or \"endsolid\"");
    words.need("normal");
    for (int d = 0; d < 3; ++d) words.number();
    words.need("outer");
    words.need("loop");
    StlTriangle& triangle = triangles.emplace_back();
    for (int corner = 0; corner < 3; ++corner) {
      words.need("vertex");
      triangle.lines[corner] = words.line();
      for (double& number : triangle.corners[corner]) number = words.number();
    }
    words.need("endloop");
    words.need("endfacet");
    need_few(triangles.size(), name, words.line());
  }
  words.skip_line();
  if (words.next()) words.refuse("nothing behind \"endsolid\": one body");
  return triangles;
}

bool is_binary(const std::string& content) {
  return content.size() >= binary_head &&
         content.size() == binary_head + binary_triangle * std::size_t{whole_number_at(content, binary_head - 4)};
}

}  // namespace

// Some binary files begin with "solid", too: their length tells.
std::vector<StlTriangle> parse_stl(const std::string& content, const std::string& name) {
  const bool binary = is_binary(content);
  if (!binary && !content.starts_with("solid"))
    throw BadInput({.file = name, .line = 0, .key = ""},
                   content.size() < binary_head
                       ? fmt::format("{} bytes that do not begin with \"solid\"", content.size())
                       : fmt::format("{} bytes, which are not those of the {} triangles that it speaks of",
                                     content.size(), whole_number_at(content, binary_head - 4)),
                   accepted_forms);
  std::vector<StlTriangle> triangles = binary ? binary_triangles(content, name) : text_triangles(content, name);
  if (triangles.empty()) throw BadInput({.file = name, .line = 0, .key = ""}, "no triangle", "the triangles of a body");
  return triangles;
}

std::vector<StlTriangle> read_stl(const std::string& path) { return parse_stl(read_file(path), path); }

}  // namespace percal
