#include "percal/base/printable.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

namespace percal {
namespace {

unsigned char byte_at(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

// Bytes of the UTF-8 character that starts at `at`; 0 where there is none.
std::size_t character_length(std::string_view text, std::size_t at) {
  const auto lead = byte_at(text, at);
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xc2 && lead < 0xe0 ? 2
                             : lead >= 0xe0 && lead < 0xf0 ? 3
                             : lead >= 0xf0 && lead < 0xf5 ? 4
                                                           : 0;
  if (at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte_at(text, at + i) & 0xc0) != 0x80) return 0;
  }
  return length;
}

// U+0000 to U+001F, U+007F, and U+0080 to U+009F, which some terminals take for ESC [ and its like.
bool is_control(std::string_view text, std::size_t at) {
  const auto first = byte_at(text, at);
  return first < 0x20 || first == 0x7f || (first == 0xc2 && byte_at(text, at + 1) < 0xa0);
}

}  // namespace

std::size_t add_printable(std::string_view text, std::size_t at, std::string& shown) {
  constexpr char digits[] = "0123456789abcdef";
  const std::size_t length = character_length(text, at);
  if (length > 0 && !is_control(text, at)) {
    shown += text.substr(at, length);
    return length;
  }
  const std::size_t end = at + (length == 0 ? 1 : length);
  for (std::size_t i = at; i < end; ++i) {
    shown += "\\x";
    shown += digits[byte_at(text, i) >> 4];
    shown += digits[byte_at(text, i) & 15];
  }
  return end - at;
}

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '\n' || text[at] == '\t')
      shown += text[at++];
    else
      at += add_printable(text, at, shown);
  }
  return shown;
}

int terminal_columns(int descriptor) {
  winsize size{};
  if (isatty(descriptor) != 1 || ioctl(descriptor, TIOCGWINSZ, &size) != 0) return 0;
  return size.ws_col;
}

}  // namespace percal
