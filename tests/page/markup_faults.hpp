// Faults of a page's markup: elements that are not closed in order, ids that occur twice, links that lead nowhere, anything
// that would be fetched.
#pragma once
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace percal::test {

namespace markup {

// The next tag from `start` on; attribute values may hold '>'.
struct Tag {
  std::size_t begin = std::string::npos, end = 0;
  std::string name;
  bool closes = false, closes_itself = false;
};

inline Tag next_tag(const std::string& page, std::size_t start) {
  Tag tag;
  for (std::size_t at = page.find('<', start); at != std::string::npos; at = page.find('<', at + 1)) {
    const std::size_t name = at + 1 + (page[at + 1] == '/');
    if (!std::isalpha(static_cast<unsigned char>(page[name]))) continue;
    tag.begin = at;
    tag.closes = page[at + 1] == '/';
    tag.name = page.substr(name, page.find_first_of(" \n\t/>", name) - name);
    char quote = 0;
    for (tag.end = name; tag.end < page.size() && (quote != 0 || page[tag.end] != '>'); ++tag.end) {
      const char c = page[tag.end];
      if (quote == 0 && (c == '"' || c == '\''))
        quote = c;
      else if (c == quote)
        quote = 0;
    }
    tag.closes_itself = page[tag.end - 1] == '/';
    return tag;
  }
  return tag;
}

}  // namespace markup

inline std::vector<std::string> markup_faults(const std::string& page) {
  const std::set<std::string> empty_elements{"meta", "br", "hr", "img", "link", "input"};
  std::vector<std::string> faults, open;
  std::set<std::string> ids, links;
  std::string tags;
  for (markup::Tag tag = markup::next_tag(page, 0); tag.begin != std::string::npos;
       tag = markup::next_tag(page, tag.end)) {
    const std::string text = page.substr(tag.begin, tag.end - tag.begin);
    tags += text + ">\n";
    if (tag.closes) {
      if (open.empty() || open.back() != tag.name)
        faults.push_back("</" + tag.name + "> closes " + (open.empty() ? "nothing" : open.back()));
      if (!open.empty()) open.pop_back();
    } else if (!tag.closes_itself && !empty_elements.contains(tag.name)) {
      open.push_back(tag.name);
    }
    std::smatch found;
    if (std::regex_search(text, found, std::regex("\\sid=[\"']([^\"']*)[\"']")) && !ids.insert(found[1]).second)
      faults.push_back("id " + found[1].str() + " occurs twice");
    if (std::regex_search(text, found, std::regex("href=[\"']#([^\"']*)[\"']"))) links.insert(found[1]);
    if (tag.name == "script" || tag.name == "link") faults.push_back("<" + tag.name + ">");
    if (std::regex_search(text, std::regex("\\s(src|srcset|data|action|poster)=")) ||
        std::regex_search(text, std::regex("href=[\"'][^#]")) || text.find("url(") != std::string::npos)
      faults.push_back("fetched: " + text);
  }
  for (const std::string& name : open) faults.push_back("<" + name + "> is never closed");
  for (const std::string& link : links)
    if (!ids.contains(link)) faults.push_back("nothing has the id " + link);
  const std::size_t style = page.find("<style>"), end = page.find("</style>");
  if (style != std::string::npos && std::regex_search(page.substr(style, end - style), std::regex("url\\(|@import")))
    faults.push_back("the style sheet fetches something");
  return faults;
}

}  // namespace percal::test
