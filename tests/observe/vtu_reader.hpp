// Reads what vtu.cpp writes, by the rules of the format.
#pragma once
#include <zlib.h>

#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "percal/observe/vtu.hpp"

namespace percal {

// The bytes behind one header of blocks.
inline std::string unpacked(const std::string& data) {
  const auto number = [&](std::size_t k) {
    std::uint64_t value = 0;
    std::memcpy(&value, data.data() + 8 * k, 8);
    return value;
  };
  const std::size_t blocks = number(0);
  std::size_t at = 8 * (3 + blocks);
  std::string bytes;
  for (std::size_t k = 0; k < blocks; ++k) {
    const bool is_short = k + 1 == blocks && number(2) != 0;
    std::string block(is_short ? number(2) : number(1), '\0');
    uLongf size = block.size();
    if (at + number(3 + k) > data.size()) throw std::runtime_error("a block passes the end");
    if (uncompress(reinterpret_cast<Bytef*>(block.data()), &size, reinterpret_cast<const Bytef*>(data.data() + at),
                   number(3 + k)) != Z_OK ||
        size != block.size())
      throw std::runtime_error("a block that zlib does not read");
    at += number(3 + k);
    bytes += block;
  }
  return bytes;
}

class VtuReader {
 public:
  explicit VtuReader(std::string text) : text_(std::move(text)) {
    const std::string marker = "<AppendedData encoding=\"raw\">\n_";
    const std::size_t place = text_.find(marker);
    if (place == std::string::npos) throw std::runtime_error("no appended data");
    appended_ = place + marker.size();
  }

  const std::string& text() const { return text_; }

  // Of the element in which `mark` stands.
  std::string attribute(const std::string& mark, const std::string& name) const {
    const std::size_t place = text_.find(mark);
    if (place > appended_) throw std::runtime_error("nothing has " + mark);
    const std::size_t begin = text_.rfind('<', place), end = text_.find('>', place);
    const std::string element = text_.substr(begin, end - begin);
    const std::size_t value = element.find(" " + name + "=\"");
    if (value == std::string::npos) throw std::runtime_error(mark + " has no " + name);
    const std::size_t from = value + name.size() + 3;
    return element.substr(from, element.find('"', from) - from);
  }

  template <class T>
  std::vector<T> array(const std::string& name, const std::string& type) const {
    const std::string mark = "Name=\"" + name + "\"";
    if (attribute(mark, "type") != type) throw std::runtime_error(name + " is not of type " + type);
    const std::string bytes = unpacked(text_.substr(appended_ + std::stoull(attribute(mark, "offset"))));
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }

 private:
  std::string text_;
  std::size_t appended_ = 0;
};

}  // namespace percal
