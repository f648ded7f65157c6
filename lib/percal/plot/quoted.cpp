#include "percal/plot/quoted.hpp"

namespace percal {
namespace {

// The quote is doubled within.
std::string between(char quote, const std::string& text) {
  std::string safe(1, quote);
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < ' ') continue;
    if (c == quote) safe += quote;
    safe += c;
  }
  return safe + quote;
}

}  // namespace

std::string gnuplot_quoted(const std::string& text) { return between('\'', text); }
std::string csv_quoted(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool formula = first != std::string::npos && std::string("=+-@").find(text[first]) != std::string::npos;
  return between('"', formula ? "'" + text : text);
}

}  // namespace percal
