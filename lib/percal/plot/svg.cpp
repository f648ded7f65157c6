#include "percal/plot/svg.hpp"

#include <algorithm>

#include "percal/text/markup.hpp"

namespace percal {
namespace {

std::string replaced(const std::string& text, const std::string& from, const std::string& to) {
  std::string result;
  std::size_t start = 0;
  for (std::size_t at; (at = text.find(from, start)) != std::string::npos; start = at + from.size())
    result += text.substr(start, at - start) + to;
  return result + text.substr(start);
}

// Every piece from `open` to the next `close` is left out.
std::string without(const std::string& text, const std::string& open, const std::string& close) {
  std::string result;
  std::size_t start = 0;
  for (std::size_t at; (at = text.find(open, start)) != std::string::npos;) {
    const std::size_t end = text.find(close, at);
    if (end == std::string::npos) break;
    result += text.substr(start, at - start);
    start = end + close.size();
  }
  return result + text.substr(start);
}

// gnuplot draws a white disc behind a point.
std::string without_white(const std::string& text) {
  std::string result;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size() - 1) + 1;
    const std::string line = text.substr(start, end - start);
    if (line.find("<use ") == std::string::npos || line.find("color='white'") == std::string::npos) result += line;
    start = end;
  }
  return result;
}

// Groups that hold nothing, which gnuplot writes at every change of colour.
std::string without_empty_groups(const std::string& text) {
  std::string result;
  std::size_t start = 0;
  for (std::size_t at; (at = text.find("<g ", start)) != std::string::npos;) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) break;
    const bool is_empty = text.compare(end, 7, ">\n</g>\n") == 0;
    result += text.substr(start, is_empty ? at - start : end + 1 - start);
    start = is_empty ? end + 7 : end + 1;
  }
  return result + text.substr(start);
}

}  // namespace

std::string tidy_svg(const std::string& svg, const std::string& prefix) {
  const std::size_t root = svg.find("<svg");
  if (root == std::string::npos) return svg;
  std::string text = svg.substr(root);
  text = without(text, "<title>Gnuplot", "</desc>\n");
  text = without(text, "<title>gnuplot_plot_", "</title>");  // of a series without a name
  text = without(text, "<filter", "</filter>\n");
  text = without_empty_groups(without_white(text));
  for (const char* attribute : {"stroke", "fill", "color"}) {
    const std::string name = attribute;
    text = replaced(text, name + "='black'", name + "='currentColor'");
    text = replaced(text, name + "=\"black\"", name + "=\"currentColor\"");
  }
  text = replaced(text, " font-family=\"sans\"", "");
  text = replaced(text, "id='", "id='" + prefix + "-");
  text = replaced(text, "id=\"", "id=\"" + prefix + "-");
  text = replaced(text, "href='#", "href='#" + prefix + "-");
  return "<svg font-family=\"sans-serif\"" + text.substr(4);
}

std::string inline_svg(const std::string& svg, const std::string& alt) {
  std::string text = without(svg, " xmlns=\"", "\"\n");
  text = without(text, " xmlns:xlink=\"", "\"\n");
  text = replaced(text, "xlink:href=", "href=");
  return "<svg role=\"img\" aria-label=\"" + escaped(alt) + "\"" + text.substr(text.find("<svg") + 4);
}

}  // namespace percal
