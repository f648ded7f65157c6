// Just enough XML for the sections of a FEBio file: elements, attributes, text; comments and declarations are passed over.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace percal {

struct XmlElement {
  std::string name;
  int line = 0;
  std::map<std::string, std::string> attributes = {};
  std::string text = {};  // of the element itself, blanks at the ends removed
  std::vector<XmlElement> children = {};

  const XmlElement* child(const std::string& child_name) const;  // the first; null where there is none
  std::string attribute(const std::string& key) const;           // empty where there is none
  // All elements of this name below, in the order of the file.
  void collect(const std::string& wanted, std::vector<const XmlElement*>& into) const;
};

// The elements of a text under one root without a name. Throws BadInput with `file` and line where the text is not XML, and
// where elements are nested more than 100 deep.
XmlElement parse_xml(const std::string& text, const std::string& file);

}  // namespace percal
