#include "percal/card/xml.hpp"

#include <algorithm>
#include <cctype>

#include "percal/base/error.hpp"
#include "percal/card/deck.hpp"

namespace percal {
namespace {

constexpr int deepest = 100;

struct Parser {
  const std::string& text;
  const std::string& file;
  std::size_t at = 0;
  int line = 1;

  [[noreturn]] void refuse(const std::string& found, const std::string& accepted) const {
    throw BadInput(Place{file, line, ""}, found, accepted);
  }
  bool ended() const { return at >= text.size(); }
  bool next_is(const std::string& what) const { return text.compare(at, what.size(), what) == 0; }
  void go_to(std::size_t end) {
    line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                        text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    at = end;
  }
  // The text up to `end`, which is passed.
  std::string until(const std::string& end) {
    const auto found = text.find(end, at);
    if (found == std::string::npos) refuse("the end of the file", "XML with " + end);
    const std::string passed = text.substr(at, found - at);
    go_to(found + end.size());
    return passed;
  }
  void skip_blanks() {
    std::size_t end = at;
    while (end < text.size() && std::isspace(static_cast<unsigned char>(text[end]))) ++end;
    go_to(end);
  }
  std::string name() {
    std::size_t end = at;
    const auto good = [](char letter) {
      return std::isalnum(static_cast<unsigned char>(letter)) || letter == '_' || letter == '-' || letter == '.' ||
             letter == ':';
    };
    while (end < text.size() && good(text[end])) ++end;
    if (end == at) refuse("'" + text.substr(at, 10) + "'", "a name of XML");
    const std::string found = text.substr(at, end - at);
    go_to(end);
    return found;
  }
  void attributes(XmlElement& element) {
    for (skip_blanks(); !ended() && text[at] != '>' && text[at] != '/'; skip_blanks()) {
      const std::string key = name();
      skip_blanks();
      if (!next_is("=")) refuse("attribute " + key + " without a value", "key=\"value\"");
      go_to(at + 1);
      skip_blanks();
      if (ended() || (text[at] != '"' && text[at] != '\'')) refuse("a value without quotation marks", "key=\"value\"");
      const std::string quote(1, text[at]);
      go_to(at + 1);
      element.attributes[key] = until(quote);
    }
  }
  // What stands between an element's tags, up to its end tag or, at the top, the end of the file.
  void content(XmlElement& element, int depth) {
    if (depth > deepest) refuse("elements nested more than 100 deep", "a FEBio file");
    while (!ended()) {
      if (next_is("<!--")) {
        until("-->");
      } else if (next_is("<?")) {
        until("?>");
      } else if (next_is("</")) {
        go_to(at + 2);
        const std::string closed = trimmed(until(">"));
        if (closed != element.name) refuse("</" + closed + ">", "</" + element.name + ">");
        return;
      } else if (next_is("<")) {
        child(element, depth);
      } else {
        const std::size_t end = std::min(text.find('<', at), text.size());
        element.text += text.substr(at, end - at);
        go_to(end);
      }
    }
    if (!element.name.empty()) refuse("the end of the file", "</" + element.name + ">");
  }
  void child(XmlElement& parent, int depth) {
    go_to(at + 1);
    XmlElement element{.name = "", .line = line};
    element.name = name();
    attributes(element);
    if (next_is("/>")) {
      go_to(at + 2);
    } else {
      until(">");
      content(element, depth + 1);
    }
    element.text = trimmed(element.text);
    parent.children.push_back(std::move(element));
  }
};

}  // namespace

const XmlElement* XmlElement::child(const std::string& child_name) const {
  const auto found =
      std::find_if(children.begin(), children.end(), [&](const XmlElement& one) { return one.name == child_name; });
  return found == children.end() ? nullptr : &*found;
}

std::string XmlElement::attribute(const std::string& key) const {
  const auto found = attributes.find(key);
  return found == attributes.end() ? "" : found->second;
}

void XmlElement::collect(const std::string& wanted, std::vector<const XmlElement*>& into) const {
  for (const XmlElement& one : children) {
    if (one.name == wanted) into.push_back(&one);
    one.collect(wanted, into);
  }
}

XmlElement parse_xml(const std::string& text, const std::string& file) {
  Parser parser{text, file};
  XmlElement root;
  parser.content(root, 0);
  return root;
}

}  // namespace percal
