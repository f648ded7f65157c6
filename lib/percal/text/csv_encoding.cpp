#include "percal/base/error.hpp"
#include "percal/text/csv_layout.hpp"

namespace percal {
namespace {

void append_utf8(std::string& text, unsigned point) {
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | ((point >> shift) & 0x3f)); };
  if (point < 0x80) {
    text += static_cast<char>(point);
  } else if (point < 0x800) {
    text += static_cast<char>(0xc0 | (point >> 6));
    tail(0);
  } else if (point < 0x10000) {
    text += static_cast<char>(0xe0 | (point >> 12));
    tail(6), tail(0);
  } else {
    text += static_cast<char>(0xf0 | (point >> 18));
    tail(12), tail(6), tail(0);
  }
}

// `low` is the place of a unit's low byte: 0 in little-endian text.
std::string from_utf16(const std::string& bytes, std::size_t low, const std::string& file) {
  const auto broken = [&] { return BadInput({file, 0, ""}, "broken UTF-16", "text in UTF-8"); };
  if (bytes.size() % 2 != 0) throw broken();
  const auto unit = [&](std::size_t at) {
    return static_cast<unsigned>(static_cast<unsigned char>(bytes[at + low])) |
           static_cast<unsigned>(static_cast<unsigned char>(bytes[at + 1 - low])) << 8;
  };
  std::string text;
  for (std::size_t at = 2; at < bytes.size(); at += 2) {  // behind the mark
    unsigned point = unit(at);
    if (point >= 0xd800 && point < 0xe000) {
      at += 2;
      const unsigned second = at < bytes.size() ? unit(at) : 0;
      if (point >= 0xdc00 || second < 0xdc00 || second >= 0xe000) throw broken();
      point = 0x10000 + ((point - 0xd800) << 10) + (second - 0xdc00);
    }
    append_utf8(text, point);
  }
  return text;
}

}  // namespace

std::string as_utf8(std::string text, const std::string& file) {
  if (text.starts_with("PK\x03\x04") || text.starts_with("\xD0\xCF\x11\xE0"))
    throw BadInput({file, 0, ""}, "a spreadsheet (.xlsx, .xls or .ods)",
                   "text: save its sheet as \"CSV UTF-8\" and give that file");
  if (text.starts_with("\xFF\xFE"))
    text = from_utf16(text, 0, file);
  else if (text.starts_with("\xFE\xFF"))
    text = from_utf16(text, 1, file);
  else if (text.starts_with("\xEF\xBB\xBF"))
    text.erase(0, 3);
  if (text.find('\0') != std::string::npos)
    throw BadInput({file, 0, ""}, "NUL bytes (a binary file, or text in UTF-16 without a byte-order mark)",
                   "text in UTF-8");
  return text;
}

}  // namespace percal
