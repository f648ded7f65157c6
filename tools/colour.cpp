#include "colour.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "percal/base/printable.hpp"

namespace percal::tools {
namespace {

std::string shown(const char* code, const std::string& text, std::FILE* stream) {
  return has_colour(stream) ? "\033[" + std::string(code) + "m" + text + "\033[0m" : text;
}

}  // namespace

bool has_colour(std::FILE* stream) {
  if (isatty(fileno(stream)) != 1) return false;
  const char* none = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return (!none || *none == '\0') && terminal && *terminal != '\0' && std::string(terminal) != "dumb";
}

std::string red(const std::string& text, std::FILE* stream) { return shown("31", text, stream); }

void print(const std::string& text, std::FILE* stream) { fmt::print(stream, "{}", printable(text)); }

}  // namespace percal::tools
