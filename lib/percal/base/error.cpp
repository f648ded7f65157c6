#include "percal/base/error.hpp"

#include <cmath>

namespace percal {
namespace {
std::string message(const Place& place, const std::string& found, const std::string& accepted) {
  std::string text = place.file;
  if (place.line > 0) text += (text.empty() ? "line " : ":") + std::to_string(place.line);
  if (!text.empty()) text += ": ";
  if (!place.key.empty()) text += place.key + ": ";
  text += "found " + found;
  if (!accepted.empty()) text += "; accepted: " + accepted;
  return text;
}
}  // namespace

BadInput::BadInput(const Place& place, const std::string& found, const std::string& accepted)
    : std::runtime_error(message(place, found, accepted)) {}

BadInput::BadInput(const std::string& message) : std::runtime_error(message) {}

NoMemory::NoMemory(const std::string& what, double bytes)
    : std::runtime_error("out of memory: " + what + " wants " + std::to_string(std::lround(std::ceil(bytes / 1e6))) +
                         " MB") {}

}  // namespace percal
