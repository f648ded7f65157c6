#include "percal/base/error.hpp"

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

}  // namespace percal
